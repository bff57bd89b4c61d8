"""A whole scene simulated twice, by this engine and by pymunk, measured by the same code."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import pymunk

from sandbox.engine.world import World
from sandbox.reference.measures import Measurer, Measures
from sandbox.reference.space import build_space, left_out
from sandbox.scene import Scene
from sandbox.scene.flat import FlatScene
from sandbox.tables import Records
from sandbox.world.records import BODY

_REPORT_EVERY = 16


@dataclass(frozen=True)
class Twin:
    """Samples of both runs at the same `times` (s); `notes` say what of the scene pymunk does not know."""

    times: tuple[float, ...]
    ours: tuple[Measures, ...]
    theirs: tuple[Measures, ...]
    notes: tuple[str, ...]


def simulate_twin(
    scene: Scene | FlatScene, steps: int, every: int = 1, on_steps: Callable[[int], None] | None = None
) -> Twin:
    """Run `scene` for `steps` steps in both engines and measure it at the start, every `every` steps and at the end.

    pymunk runs at its defaults, with one `Space.step` of the same length for each of our steps.
    """
    flat = scene.flatten() if isinstance(scene, Scene) else scene
    world, (space, bodies) = World(flat), build_space(flat)
    measurer, seconds = Measurer(world.state), 1.0 / flat.settings.step_rate
    times, ours, theirs = [], [], []
    for k in range(steps + 1):
        if k > 0:
            world.step()
            space.step(seconds)
        if k % every == 0 or k == steps:
            times.append(k * seconds)
            ours.append(measurer.measure(world.state.bodies))
            theirs.append(measurer.measure(_as_records(world.state.bodies, bodies)))
        if on_steps is not None and k % _REPORT_EVERY == 0:
            on_steps(k)
    return Twin(tuple(times), tuple(ours), tuple(theirs), left_out(flat))


def _as_records(ours: Records, theirs: list[pymunk.Body]) -> Records:
    """Our table of bodies with the poses and velocities of pymunk's."""
    rows = BODY.zeros(len(ours))
    rows[:] = ours
    for row, body in zip(rows, theirs, strict=True):
        row.center_x, row.center_y = body.local_to_world(body.center_of_gravity)
        row.rotation_cos, row.rotation_sin = math.cos(body.angle), math.sin(body.angle)
        row.angle = body.angle
        row.velocity_x, row.velocity_y = body.velocity
        row.angular_velocity = body.angular_velocity
    return rows
