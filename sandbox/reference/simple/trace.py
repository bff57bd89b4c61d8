"""Looking over the simple solver's shoulder: every pass of one substep, and a scene over time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from sandbox.errors import SandboxError
from sandbox.reference.measures import Measurer, Measures
from sandbox.reference.simple.collisions import Placed
from sandbox.reference.simple.contacts import Contact, Point
from sandbox.reference.simple.techniques import Techniques
from sandbox.reference.simple.vectors import Vec, vec
from sandbox.reference.simple.world import SimpleWorld
from sandbox.scene.flat import FlatScene

_MANY = 2000
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
    """

    spots: tuple[Spot, ...]
    rows: tuple[tuple[float, ...], ...]
    velocities: tuple[Vec, ...]
    shapes: tuple[Placed, ...]


@dataclass(frozen=True)
class Course:
    """A scene over time: `times` (s), what it measured then, and its shapes at the end."""

    times: tuple[float, ...]
    measures: tuple[Measures, ...]
    end: tuple[Placed, ...]


def watch_passes(scene: FlatScene, techniques: Techniques, step: int) -> Passes:
    """The passes of the first substep of a step (counted from 1), before bodies move.

    Raises `SandboxError` if nothing touches in that step.
    """
    world = SimpleWorld(scene, techniques)
    world.step(step - 1)
    world.collide()
    if not world.contacts:
        raise SandboxError(f"step {step}: nothing touches; give another one with --step")
    pairs = [(contact, point) for contact in world.contacts.values() for point in contact.points]
    spots, shapes = _spots(world, scene), world.placed()
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
    return Passes(spots, tuple(rows), tuple(velocities), shapes)


def settled(scene: FlatScene, techniques: Techniques, step: int) -> tuple[float, ...]:
    """The impulses (N s) that put all contacts of that substep right at once: where many rigid passes lead to."""
    return watch_passes(scene, replace(techniques, accumulate=True, iterations=_MANY), step).rows[-1]


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
