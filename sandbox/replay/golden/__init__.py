"""Golden recordings: running them again, comparing, and saying where two runs part."""
