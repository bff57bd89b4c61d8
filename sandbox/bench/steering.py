"""What happens between the steps of benchmark scenes, but for ragdolls."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.motion import SetVelocity
from sandbox.engine.commands.spawn import Spawn

_RATE = 60.0
_BOXES = 1000


def junkyard(step: int) -> Sequence[Command]:
    """The pusher of Box2D's junkyard swings by 60 m: it gets the velocity that takes it where it should be next."""
    way = _pusher(step) - _pusher(max(0, step - 1))
    return (SetVelocity("pusher", (way * _RATE, 0.0), 0.0),)


def _pusher(step: int) -> float:
    return 60.0 * math.sin(0.2 * step / _RATE)


def drop_boxes(step: int) -> Sequence[Command]:
    """A box a step falls into pymunk's tumbler, from the second step on."""
    if not 0 < step <= _BOXES:
        return ()
    return (Spawn({"id": f"box-{step}", "prefab": "box", "position": [0.0, -10.0]}),)
