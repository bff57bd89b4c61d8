"""The broad phase: which pairs of shapes may touch in this step.

In: shapes and the poses and velocities of their bodies.
Out: axis-aligned boxes, proxies, and the pairs whose boxes overlap, sorted.
Source: hierarchical grid with hashed cells (Ericson, Real-Time Collision Detection, 2005, 7.2), of fat boxes
whose pairs are kept (Verlet 1967).
"""
