"""The engine: what changes the state of a world. `world` is the door, `step` the table of contents.

In: a state (`sandbox.world`) and commands.
Out: the state one step later, its contacts, events and answers to queries.
Source: the soft step of Box2D v3 (Catto 2024) for contacts, a direct solver for joints; each room names its own.
"""
