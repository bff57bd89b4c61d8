"""The midpoint rule for contacts: normals and anchors of a step are those of its middle.

In: bodies, the contact table of the step, who was struck or touches something new.
Out: bodies and contacts that last, put to where velocities take them in half a step, and back again as the step ends.
Source: the implicit midpoint rule (E. Hairer, C. Lubich and G. Wanner, "Geometric Numerical Integration", 2006);
how a contact moves over both bodies: D. Montana, "The Kinematics of Contact and Grasp" (1988).
"""
