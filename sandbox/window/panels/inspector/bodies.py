"""The bodies that are selected: where they are, how they move, what they weigh."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.motion import SetPose, SetVelocity
from sandbox.tables import plain
from sandbox.window.editor import Editor, Entry, Vec
from sandbox.window.widgets import Scale, row
from sandbox.window.workspace import Workspace
from sandbox.world.records import DYNAMIC, STATIC

TYPES = ("static", "kinematic", "dynamic")
_POSITION = Entry("inspector.position", "position", Scale("m", 0.01, digits=6), "Origin. Drag, or click to type.")
_MIDDLE = Entry("inspector.position", "middle", Scale("m", 0.01, digits=6), "Mean of the origins; moves all of them.")
_ANGLE = Entry("inspector.angle", "angle", Scale("°", 0.5, digits=6), "Turned so far, counter-clockwise.")
_VELOCITY = Entry("inspector.velocity", "velocity", Scale("m/s", 0.02, digits=5), "Of the centre of mass.")
_SPIN = Entry("inspector.spin", "spin", Scale("°/s", 1.0, digits=5), "Angular velocity, counter-clockwise.")


def draw_motion(workspace: Workspace, editor: Editor, names: Sequence[str], rows: Any) -> None:
    """Pose and velocity of the bodies `names`, which lie in `rows` of the table."""
    table = plain(workspace.session.world.state.bodies)
    places = np.column_stack([table["position_x"][rows], table["position_y"][rows]])
    angles = table["angle"][rows]
    middle = float(places[:, 0].mean()), float(places[:, 1].mean())

    def move(to: Vec) -> Iterable[Command]:
        by = to[0] - middle[0], to[1] - middle[1]
        if len(names) == 1:
            return [SetPose(names[0], to, float(angles[0]))]
        poses = zip(names, places.tolist(), angles.tolist(), strict=True)
        return [SetPose(name, (x + by[0], y + by[1]), angle) for name, (x, y), angle in poses]

    def turn(degrees: float) -> Iterable[Command]:
        return [
            SetPose(name, (x, y), math.radians(degrees)) for name, (x, y) in zip(names, places.tolist(), strict=True)
        ]

    editor.pair(workspace, _POSITION if len(names) == 1 else _MIDDLE, np.array([middle]), move)
    editor.number(workspace, _ANGLE, np.degrees(angles), turn)
    _draw_velocity(workspace, editor, names, rows)


def _draw_velocity(workspace: Workspace, editor: Editor, names: Sequence[str], rows: Any) -> None:
    """Of those that can have one."""
    table = plain(workspace.session.world.state.bodies)
    movable = table["type"][rows] != STATIC
    if not movable.any():
        return
    rows = rows[movable]
    velocities = np.column_stack([table["velocity_x"][rows], table["velocity_y"][rows]])
    spins = table["angular_velocity"][rows]

    def given() -> Iterable[tuple[str, Vec, float]]:
        who = [name for name, can in zip(names, movable, strict=True) if can]
        return zip(who, map(tuple, velocities.tolist()), spins.tolist(), strict=True)

    def push(velocity: Vec) -> Iterable[Command]:
        return [SetVelocity(name, velocity, spin) for name, _, spin in given()]

    def spin(degrees: float) -> Iterable[Command]:
        return [SetVelocity(name, velocity, math.radians(degrees)) for name, velocity, _ in given()]

    editor.pair(workspace, _VELOCITY, velocities, push)
    editor.number(workspace, _SPIN, np.degrees(spins), spin)


def draw_mass(workspace: Workspace, rows: Any) -> None:
    """Type, mass, inertia, centre of mass, and whether they are awake."""
    table = plain(workspace.session.world.state.bodies)
    mass = table["mass"][rows]
    if len(rows) == 1:
        body = table[rows[0]]
        if body["type"] == DYNAMIC:
            row("mass", f"{body['mass']:.5g} kg", "Follows from densities and sizes.")
            row("inertia", f"{body['inertia']:.4g} kg m²", "About the centre of mass; 0 where it cannot turn.")
        row("centre of mass", _place(body["center_x"], body["center_y"]))
        row("state", _state(body))
        return
    center = [float((mass * table[name][rows]).sum() / mass.sum()) if mass.sum() else 0.0 for name in _CENTER]
    row("mass", f"{mass.sum():.5g} kg", "Of all together.")
    if mass.sum():
        row("centre of mass", _place(*center), "Of all together.")
    moving = table["type"][rows] == DYNAMIC
    row("state", f"{int((moving & (table['awake'][rows] == 1)).sum()):,} of {int(moving.sum()):,} dynamic ones awake")


_CENTER = ("center_x", "center_y")


def describe(workspace: Workspace, rows: Any) -> str:
    """What kinds of body there are: "dynamic", or "3 dynamic, 1 static"."""
    types = plain(workspace.session.world.state.bodies)["type"][rows]
    counts = [(int((types == kind).sum()), TYPES[kind]) for kind in (2, 1, 0)]
    return TYPES[int(types[0])] if len(rows) == 1 else ", ".join(f"{n:,} {kind}" for n, kind in counts if n)


def _place(x: float, y: float) -> str:
    scale = _POSITION.scale
    return f"{scale.shown(x):g}, {scale.shown(y):g} m"


def _state(body: Any) -> str:
    if body["frozen_step"] >= 0:
        return f"frozen by bad numbers at step {int(body['frozen_step']):,}"
    if body["type"] == STATIC:
        return "never moves"
    return "awake" if body["awake"] else f"asleep, at rest for {body['sleep_time']:.2f} s"
