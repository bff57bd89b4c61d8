"""What an experiment is: a scene set in motion by some engine, watched, and held against a closed form."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from sandbox.scene.flat import FlatScene, Vec

G = 9.81
RATE = 60
"""Steps a second."""


class Run(Protocol):
    """A scene in motion. Bodies are named by their ids; lengths in metres, angles in radians."""

    def step(self, steps: int = 1) -> None:
        """Advance by so many sixtieths of a second."""

    def place(self, name: str) -> Vec:
        """Centre of mass."""

    def angle(self, name: str) -> float:
        """Of the body, counter-clockwise; may be wrapped to one turn."""

    def velocity(self, name: str) -> Vec:
        """Of the centre of mass, m/s."""

    def spin(self, name: str) -> float:
        """Angular velocity, rad/s."""


class LacksError(Exception):
    """An engine has not got what an experiment is about."""


Engine = Callable[[FlatScene], Run]
"""Puts a scene in motion, or raises `LacksError`."""


@dataclass(frozen=True)
class Experiment:
    """A row of the table: `measure` gives the relative error of whatever engine it is handed.

    `bound` is what our own error may be; `against` says what the error is relative to, or that it is in metres.
    `behind`: another engine is nearer to the truth, which `sandbox/LIMITS.md` tells of.
    """

    name: str
    against: str
    bound: float
    measure: Callable[[Engine], float]
    behind: bool = False


def experiment(
    name: str, against: str, bound: float, behind: bool = False
) -> Callable[[Callable[[Engine], float]], Experiment]:
    """Decorator that makes a measuring function an `Experiment`."""
    return lambda measure: Experiment(name, against, bound, measure, behind)


def off(measured: float, truth: float) -> float:
    """Relative error."""
    return abs(measured - truth) / abs(truth)


def off_pair(measured: Vec, truth: Vec, scale: float) -> float:
    """Distance of two vectors as a share of `scale`."""
    return ((measured[0] - truth[0]) ** 2 + (measured[1] - truth[1]) ** 2) ** 0.5 / scale
