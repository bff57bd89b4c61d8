"""How materials look: which words in a material's name mean which colour, texture and translucency."""
