"""The memory of a step: what it needs and forgets, and how its entry points are called with it.

In: a state.
Out: bundles of tables for the stages, and the arguments of entry points by name.
Source: scratch apart from state, as Rapier's pipeline holds it.
"""
