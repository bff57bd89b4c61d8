"""The pair of bodies where two runs part, and its separating-axis test in both."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import Any

from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.geometry.collide import collide, distance
from sandbox.geometry.sat_table import SatTable, sat_table
from sandbox.geometry.shapes import Shape
from sandbox.replay.golden.divergence import Divergence
from sandbox.replay.golden.run import Run, RunStepper


@dataclass(frozen=True)
class Pair:
    """Two bodies after step `step`, and their tables; `expected` is None if that run is not known."""

    names: tuple[str, str]
    step: int
    got: SatTable
    expected: SatTable | None


def first_pair(got: RunStepper, expected: RunStepper, parted: Divergence) -> Pair | None:
    """The pair with the first number that differs; None if nothing is near it. Both stages go on to that step."""
    world, other = _world_at(got, parted.step), _world_at(expected, parted.step)
    found = parted.detail
    if found is None:
        return None
    return _pair(world, other, parted.step, found.name if found.table == "contact" else found.body)


def pair_at(got: Run, step: int, body: str) -> Pair | None:
    """The deepest contact of a body after `step` steps; None if it touches nothing."""
    return _pair(_world_at(RunStepper(got.scene, got.commands), step), None, step, body)


def _pair(world: World, other: World | None, step: int, subject: str) -> Pair | None:
    """The pair that `subject` names, "A, B"; of a body alone the deepest contact."""
    names = _names(world, subject) or (None if other is None else _names(other, subject))
    if names is None:
        return None
    try:
        return Pair(names, step, _table(world, names), None if other is None else _table(other, names))
    except SandboxError:  # a body that is not there, or too small to be told apart where it is
        return None


def _world_at(stepper: RunStepper, step: int) -> World:
    try:
        while stepper.step < step:
            stepper.advance()
    except SandboxError:
        pass  # the run ends at a command that is refused
    return stepper.world


def _names(world: World, subject: str) -> tuple[str, str] | None:
    near = [(_of(world, row), float(row.separation1)) for row in world.contacts]
    exact = [names for names, _ in near if ", ".join(names) == subject]
    if exact:
        return exact[0]
    own = [(depth, names) for names, depth in near if subject in names]
    return min(own)[1] if own else None


def _of(world: World, row: Any) -> tuple[str, str]:
    return world.names[int(row.body_a)], world.names[int(row.body_b)]


def _table(world: World, names: tuple[str, str]) -> SatTable:
    """That of the deepest of all pairs of the two bodies' shapes; if none overlaps, of the nearest."""
    pairs = list(product(world.body(names[0]).shapes, world.body(names[1]).shapes))
    a, b = pairs[0] if len(pairs) == 1 else min(pairs, key=lambda pair: _apart(*pair))
    return sat_table(a, b, all_axes=True)


def _apart(a: Shape, b: Shape) -> float:
    contact = collide(a, b)
    return distance(a, b).value if contact is None else -contact.depth
