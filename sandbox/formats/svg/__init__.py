"""Drawings in SVG as scenes."""
