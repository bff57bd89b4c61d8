"""Bodies by themselves: velocities from forces, positions from velocities, and what to do about bad numbers.

In: the body table with its forces, and the length of a substep.
Out: velocities, displacements and poses; flags; frozen bodies.
Source: semi-implicit Euler for what is in contact, velocity Verlet for what is free (Hairer and others 2003).
"""
