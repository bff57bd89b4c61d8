"""The joint solver: what hangs together by joints is one linear system, solved at once in each substep.

In: the joint table, the bodies it ties and their velocities.
Out: velocities and positions that keep the joints, and their forces.
Source: RATTLE (Andersen 1983), sparse LDL^T (Baraff 1996; Davis 2006), block pivoting (Judice and Pires 1994).
"""
