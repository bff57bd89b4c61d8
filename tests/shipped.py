"""The scenes that come with the package, each loaded once."""

from __future__ import annotations

from functools import cache

from sandbox.resources import SCENE_SUFFIX, shipped_scenes
from sandbox.scene import Scene, load_scene

FILES = {file.name.removesuffix(SCENE_SUFFIX): file for file in shipped_scenes()}


@cache
def shipped(name: str) -> Scene:
    """A shipped scene by its name. Not to be changed."""
    return load_scene(FILES[name])
