"""Worlds of Box2D 2.x as files hold them, and what they are in a scene."""
