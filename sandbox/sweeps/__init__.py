"""Many runs of one scene, each with other values: parameter studies, over processes or a cluster.

In: a scene, what is to vary, what is to be collected. Out: a table with a row for each run. [README](README.md)
"""
