"""Questions to a world: `Queries` is what users see (`world.query`), the kernels behind it have a file a kind.

`lay_out.py` puts all shapes into the grid, `walk.py` visits the cells that something swept along a way could meet,
`sweep.py` (rays, casts), `proximity.py` (points, overlaps, nearest) and `gap.py` (two bodies) judge what lies in them.
"""
