"""Colours that mean something: one way to colour bodies a file."""
