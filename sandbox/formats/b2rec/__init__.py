"""Recordings of Box2D v3 (`.b2rec`): the world as it stands when the first step begins."""
