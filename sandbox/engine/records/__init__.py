"""The tables that stages hand to each other, and the bundles in which kernels take them.

In: nothing: declarations.
Out: a dtype for each concept, with units and meaning, and a NamedTuple for each room.
Source: solver bodies, graph colours and contact constraints are those of Box2D v3.
"""
