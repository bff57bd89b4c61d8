"""Fill an empty kernel cache before other processes begin."""

from __future__ import annotations

from sandbox._jit import cache_is_cold
from sandbox.engine.world import World
from sandbox.scene.flat import FlatScene


def compile_first() -> None:
    """Compile what every step needs, once, or every process would."""
    if cache_is_cold():
        World(FlatScene(())).step()
