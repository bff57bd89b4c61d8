"""Queries: the tables of a world's state and a question come in; hits, nearest points and gaps go out, sorted.
Rays and casts walk through a grid (after J. Amanatides, A. Woo 1987); overlaps, casts and gaps are those of a
point and the Minkowski sum of both shapes (G. van den Bergen, "Collision Detection in Interactive 3D Environments").
"""
