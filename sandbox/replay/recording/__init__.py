"""Recordings: what was done to a scene and what came of it, as text that a person can review."""
