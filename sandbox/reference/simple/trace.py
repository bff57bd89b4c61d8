"""Looking over the simple solver's shoulder: every pass of one substep, and a scene over time."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from copy import copy, deepcopy
from dataclasses import dataclass, replace
from itertools import count

from sandbox.errors import SandboxError
from sandbox.reference.measures import Measurer, Measures
from sandbox.reference.simple.collisions import Placed
from sandbox.reference.simple.contacts import Contact, Point
from sandbox.reference.simple.techniques import Techniques
from sandbox.reference.simple.vectors import Vec, vec
from sandbox.reference.simple.world import SimpleWorld
from sandbox.scene.flat import FlatScene

MANY = 2000
"""Passes after which the impulses are taken for those that put all contacts right at once."""


@dataclass(frozen=True)
class Spot:
    """A contact point before the solver's first pass: bodies, place (m), unit normal from a to b.

    `speed` (m/s) is that of b against a along the normal, `velocity` the whole of it; `mass` (kg) is the effective
    mass; `gap` in m.
    """

    names: tuple[str, str]
    place: Vec
    normal: Vec
    gap: float
    speed: float
    velocity: Vec
    mass: float


@dataclass(frozen=True)
class Passes:
    """One substep: its points, and after each pass over them a row of the normal impulses given so far (N s).

    `velocities` (m/s) of b against a at the points are those after the last pass; `shapes` lie as the step begins.
    `settled` are the impulses (N s) that put all these contacts right at once: where `MANY` passes lead to.
    """

    spots: tuple[Spot, ...]
    rows: tuple[tuple[float, ...], ...]
    velocities: tuple[Vec, ...]
    shapes: tuple[Placed, ...]
    settled: tuple[float, ...]


@dataclass(frozen=True)
class Course:
    """A scene over time: `times` (s), what it measured then, and its shapes at the end."""

    times: tuple[float, ...]
    measures: tuple[Measures, ...]
    end: tuple[Placed, ...]


def watch_passes(
    scene: FlatScene, techniques: Techniques, step: int, on_done: Callable[[int], None] = lambda _: None
) -> Passes:
    """The passes of the first substep of a step (counted from 1), before bodies move.

    `on_done` hears of each step and each of the `MANY` passes that are done. Raises `SandboxError` if nothing touches
    in that step.
    """
    world = SimpleWorld(scene, techniques)
    for done in range(1, step):
        world.step()
        on_done(done)
    world.collide()
    if not world.contacts:
        raise SandboxError(f"step {step}: nothing touches; give another one with --step")
    spots, shapes = _spots(world, scene), world.placed()
    settled = _settled(world, lambda passes: on_done(step - 1 + passes))
    pairs = [(contact, point) for contact in world.contacts.values() for point in contact.points]
    given = [0.0] * len(spots)
    rows: list[tuple[float, ...]] = []
    velocities: list[Vec] = []

    def after() -> None:
        for k, (_, point) in enumerate(pairs):
            given[k] = point.normal if techniques.accumulate else given[k] + point.normal
        if len(rows) < techniques.iterations:
            rows.append(tuple(given))
            velocities[:] = [vec(_velocity(contact, point)) for contact, point in pairs]

    world.solve(after)
    return Passes(spots, tuple(rows), tuple(velocities), shapes, settled)


def _settled(world: SimpleWorld, on_pass: Callable[[int], None]) -> tuple[float, ...]:
    """Where many passes over the contacts of now lead to; the world stays as it is, as copies are solved."""
    twin = copy(world)
    twin.bodies, twin.contacts = deepcopy((world.bodies, world.contacts))
    twin.techniques = replace(world.techniques, accumulate=True, iterations=MANY)
    passes = count(1)

    def after() -> None:
        done = next(passes)
        on_pass(done)
        if done == MANY:
            raise _Enough

    with suppress(_Enough):
        twin.solve(after)
    return tuple(point.normal for contact in twin.contacts.values() for point in contact.points)


class _Enough(Exception):  # noqa: N818 (no mistake: the rest of a step is not wanted)
    """All passes of the first substep are done."""


def run_course(scene: FlatScene, techniques: Techniques, steps: int, on_steps: Callable[[int], None]) -> Course:
    """Run a scene and measure it at the start and after each step."""
    world = SimpleWorld(scene, techniques)
    measurer = Measurer(world.state)
    times, measures = [], []
    for k in range(steps + 1):
        if k > 0:
            world.step()
        times.append(k * world.numbers.seconds)
        measures.append(measurer.measure(world.records()))
        on_steps(k)
    return Course(tuple(times), tuple(measures), world.placed())


def _spots(world: SimpleWorld, scene: FlatScene) -> tuple[Spot, ...]:
    """The points as the first pass meets them: forces have worked for a substep, impulses have not."""
    kept = [(body.velocity, body.angular) for body in world.bodies]
    for body in world.bodies:
        body.gain_speed(world.numbers.gravity, world.numbers.seconds / world.techniques.substeps)
    names = {id(body): flat.id for body, flat in zip(world.bodies, scene.bodies, strict=True)}
    spots = tuple(
        Spot(
            (names[id(c.a)], names[id(c.b)]), vec(c.a.center + p.anchor_a), vec(c.normal), p.first_gap,
            c.speed(p, c.normal), vec(_velocity(c, p)), p.normal_mass,
        )
        for c in world.contacts.values() for p in c.points
    )  # fmt: skip
    for body, (velocity, angular) in zip(world.bodies, kept, strict=True):
        body.velocity, body.angular = velocity, angular
    return spots


def _velocity(contact: Contact, point: Point) -> complex:
    return contact.b.at(point.anchor_b) - contact.a.at(point.anchor_a)
