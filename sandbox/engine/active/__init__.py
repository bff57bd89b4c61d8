"""The active set: which bodies a step has to look at, in which islands, with how many substeps, and who sleeps.

In: bodies, their contacts and joints.
Out: lists of active bodies, shapes and contacts; islands; substep levels; who is awake.
Source: islands by union-find (Tarjan and van Leeuwen 1984); sleeping as in Box2D; buckling after Greenhill (1881).
"""
