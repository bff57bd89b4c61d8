"""The narrow phase: which pairs do touch, where, and on which axis.

In: the pairs of the broad phase, and the contacts of the step before.
Out: the contact table: normals, points, separations, and the impulses to start from.
Source: separating-axis test with clipping (Gregorius, GDC 2015); speculative contacts (Catto, GDC 2013).
"""
