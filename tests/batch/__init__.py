"""Batches: each world as it would go alone."""
