"""What a benchmark scene has beside its file: bodies that no generator makes, and what happens between its steps."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from sandbox.bench import layouts, steering
from sandbox.bench.ragdolls import rain
from sandbox.engine.commands.base import Command
from sandbox.engine.commands.spawn import Words

Parts = dict[str, list[Words]]
"""Entries of `bodies` and of `joints`, in the words of a scene file."""


def _nothing() -> Parts:
    return {}


def _idle(_step: int) -> Sequence[Command]:
    return ()


@dataclass(frozen=True)
class Driver:
    """`parts` are added to the scene before it begins; `commands` gives what is done to it after so many steps.

    Both depend on nothing else, so that every engine gets the same. `iterations` are those that pymunk takes, where
    the original sets them.
    """

    parts: Callable[[], Parts] = field(default=_nothing)
    commands: Callable[[int], Sequence[Command]] = field(default=_idle)
    iterations: int = 10


DRIVERS: dict[str, Driver] = {
    "box2d-joint-grid": Driver(parts=layouts.joint_grid),
    "box2d-junkyard": Driver(commands=steering.junkyard),
    "box2d-rain": Driver(commands=rain),
    "pymunk-add-pair": Driver(iterations=50),
    "pymunk-mixed-static-dynamic": Driver(parts=layouts.mixed_static_dynamic),
    "pymunk-mostly-static-single": Driver(parts=layouts.mostly_static_single),
    "pymunk-multifixture": Driver(parts=layouts.multifixture),
    "pymunk-slow-explosion": Driver(parts=layouts.slow_explosion),
    "pymunk-tumbler": Driver(commands=steering.drop_boxes),
}
"""The drivers of the shipped benchmark scenes by their names; all other scenes go on by themselves."""
