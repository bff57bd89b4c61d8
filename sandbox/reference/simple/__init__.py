"""The simple solver: sequential impulses to read from top to bottom, beside the engine's own."""
