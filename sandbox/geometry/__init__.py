"""Convex cores and the rounded shapes around them: vertex tables and plain shapes come in; contacts, distances, bounds,
times of impact, masses and convex parts go out. The separating-axis test with clipping (E. Catto, "Contact Manifolds",
GDC 2007) and conservative advancement (B. Mirtich 1996); exact rational arithmetic where rounding could decide.
"""
