"""The window: a pygame-ce window with OpenGL in which scenes run and can be touched."""
