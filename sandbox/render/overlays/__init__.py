"""Overlays: what the last step left in the world's memory, drawn over the bodies.

Each file is one overlay; `registry.py` lists them all. Picture and window draw the same ones.
"""
