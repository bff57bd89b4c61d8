"""Overlays: what the last step left in the world's memory, drawn over the bodies.

Each file with an `OVERLAY` is one, and `registry.py` lists them all; the other files are what they are drawn with:
`look.py` what they look at, `pen.py` their marks, `scale.py` how long arrows are, `palette.py` their colours,
`legend.py` the card. Picture and window draw the same ones.
"""
