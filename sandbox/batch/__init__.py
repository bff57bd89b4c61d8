"""Many small worlds at once, for learning and search: stepped in one call, over all cores.

In: a scene, or one for each world. Out: arrays with a row for each world. [README](README.md)
"""
