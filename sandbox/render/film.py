"""A world filmed: step it, and give the frame at each moment of the film."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Protocol

from sandbox.render.frame import Frame, blend, capture
from sandbox.world.state import State


class Steppable(Protocol):
    """What filming needs of a world."""

    @property
    def state(self) -> State: ...

    def step(self, n: int = 1) -> object: ...


def gif_seconds(fps: float) -> float:
    """Seconds a frame nearest to `fps` that a GIF can hold: whole hundredths, at least two."""
    return max(round(100.0 / fps), 2) / 100.0


def film(world: Steppable, steps: int, seconds_a_frame: float, watch: Callable[[], None]) -> Iterator[Frame]:
    """Take `steps` steps and give a frame every `seconds_a_frame` of the world's time, blended between steps.

    The world's present state is the first frame. `watch` is called after every step.
    """
    current = capture(world.state)
    yield current
    begin, shown = current.time, 1
    for _ in range(steps):
        world.step()
        watch()
        previous, current = current, capture(world.state, current.mesh)
        while begin + shown * seconds_a_frame <= current.time + 1e-9:
            moment = begin + shown * seconds_a_frame
            yield blend(previous, current, (moment - previous.time) / (current.time - previous.time))
            shown += 1
