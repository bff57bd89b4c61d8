"""Joints against closed forms, and their lives from the scene to the break."""
