"""Parts that are factorised: what hangs together by joints is one linear system, solved at once in each substep.

Parts of one layout lie side by side, four to a batch, and are solved together: every number of theirs is a vector.
In: the joint table, the bodies it ties and their velocities.
Out: velocities and positions that keep the joints, and their forces.
"""
