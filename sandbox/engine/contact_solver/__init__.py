"""The contact solver: normal and friction impulses, found one colour of contacts after the other.

In: the contact table and the velocities of the bodies.
Out: accumulated impulses in the contacts, and velocities that respect them.
Source: sequential impulses with warm starting (Catto, GDC 2005), soft step with relaxing (Catto 2024, Box2D v3).
"""
