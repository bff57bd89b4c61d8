"""Restitution: impacts that fall into a substep, resolved before the solver makes them inelastic.

In: contacts that close in, and velocities with and without the forces of the substep.
Out: velocities after the impacts, and their impulses.
Source: Newton's and Coulomb's laws applied contact by contact (Mirtich and Canny 1995), in the order of time; a block
of two points; what falls in the same moment, and what rattles on, strikes together (J. J. Moreau 1985; B. Smith et al.
2012). Without restitution all contacts that a blow
reaches are one complementarity problem (J. J. Moreau 1985). Both of these are solved by passes that Nesterov's method
accelerates (H. Mazhar, T. Heyn, D. Negrut and A. Tasora 2015).
"""
