"""Workers: threads that share the loops of a step.

In: a task and a range of pairs, blocks or bodies that do not depend on each other. Out: the same bits as one thread.
Source: the solver stages of Box2D 3 (E. Catto, "SIMD Matters", 2024): blocks of one colour taken by atomic increments.
"""
