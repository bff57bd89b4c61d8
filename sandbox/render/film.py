"""A world filmed: step it, and give the frame at each moment of the film."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Protocol

from sandbox.render.frame import Frame, blend, capture
from sandbox.world.state import State


class Steppable(Protocol):
    """What filming needs of a world."""

    @property
    def state(self) -> State:
        """The records as they are now."""

    def step(self, n: int = 1) -> object:
        """Advance by `n` steps."""


def gif_seconds(fps: float) -> float:
    """Seconds a frame nearest to `fps` that a GIF can hold: whole hundredths, at least two."""
    return max(round(100.0 / fps), 2) / 100.0


def film(world: Steppable, steps: Iterable[object], seconds_a_frame: float) -> Iterator[Frame]:
    """Take a step for each item of `steps` and give a frame every `seconds_a_frame` of the world's time.

    The world's present state is the first frame; later ones are blended between two steps.
    """
    current = capture(world.state)
    yield current
    begin, shown = current.time, 1
    for _ in steps:
        world.step()
        previous, current = current, capture(world.state, current.mesh)
        while (moment := begin + shown * seconds_a_frame) <= current.time + 1e-9:
            yield blend(previous, current, (moment - previous.time) / (current.time - previous.time))
            shown += 1
