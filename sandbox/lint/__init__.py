"""Scenes that load, and are silly: what an author hardly meant.

A rule is one file in `rules/`; `registry.py` lists them all. What a rule sees of a scene is a `Subject`.
"""
