"""What tests of saving are built from."""

from __future__ import annotations

import copy
from pathlib import Path

import numpy as np

from sandbox import Scene, SceneNow, World, load_scene, scene_of
from sandbox.engine.active.wake import wake_all
from sandbox.world.field_records import NEVER

NUMBERS = ("center_x", "center_y", "velocity_x", "velocity_y", "angular_velocity", "mass", "inertia")


def saved(world: World, folder: Path) -> tuple[SceneNow, World]:
    """What becomes of a world as a scene, and the world of that scene, after a way through a file."""
    found = scene_of(world)
    path = folder / "saved.scene.json"
    found.scene.save(path)
    loaded = load_scene(path)
    assert loaded == found.scene
    return found, World(loaded)


def forgetful(world: World) -> World:
    """The same world, awake, without a memory of steps, contacts, joints and hands: what a scene cannot hold either."""
    twin = copy.copy(world)
    state = twin.state
    for table in (state.regions, state.thrusters):  # what acts at its time does so by a clock that begins anew
        table.start_step = np.maximum(table.start_step - world.step_count, 0)
        ends = np.maximum(table.end_step - world.step_count, 0)
        table.end_step = np.where(table.end_step == NEVER, NEVER, ends)
    for counter in ("step_count", "contact_count", "substep_watch", "substep_levels", "still"):
        state.counters[counter] = 0
    for k in range(5):
        state.joints[f"impulse_{k}"] = 0.0
    wake_all(state)
    state.bodies.sleep_time = 0.0
    state.drags.body = -1
    twin.restore(twin.snapshot())
    return twin


def rows_in(other: World, world: World) -> list[int]:
    """The row that each body of `world` has in `other`."""
    return [other.directory.body(name) for name in world.names]


def difference(world: World, other: World) -> float:
    """Largest difference of places, velocities and masses of bodies with the same id, and of turns that are seen.

    Paths give their bodies the velocities of a step as it begins.
    """
    rows = rows_in(other, world)
    a, b = np.array(world.state.bodies), np.asarray(other.state.bodies)[rows]
    for name in ("velocity_x", "velocity_y", "angular_velocity"):
        a[name][world.state.paths.body] = 0.0
    turns = np.hypot(a["rotation_cos"] - b["rotation_cos"], a["rotation_sin"] - b["rotation_sin"])
    return max(float(np.abs(gaps).max(initial=0.0)) for gaps in (*(a[name] - b[name] for name in NUMBERS), turns))


def apart(world: World, other: World) -> float:
    """Largest distance (m) of centres of bodies with the same id."""
    rows = rows_in(other, world)
    a, b = world.state.bodies, np.asarray(other.state.bodies)[rows]
    return float(np.hypot(a.center_x - b["center_x"], a.center_y - b["center_y"]).max(initial=0.0))


def entries(scene: Scene) -> dict[str, dict[str, object]]:
    """The bodies of a scene as data, by id."""
    return {body.id: body.to_data() for body in scene.bodies}
