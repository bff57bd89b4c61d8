"""Rows come and go: bodies, joints and regions are added at the end or taken out, and all that points at rows follows.

What stays is moved byte for byte: poses, velocities, sleep, the impulses of contacts and joints. The tables come out as
if the world had been built without what is gone, so nothing depends on the way that led there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.scene.flat import FlatBody
from sandbox.scene.spawned import Spawned
from sandbox.tables import Integers, close_up, extended, plain, without
from sandbox.world import records
from sandbox.world.body_rows import body_rows
from sandbox.world.build_fields import build_thrusters
from sandbox.world.build_joints import build_joints
from sandbox.world.build_rules import build_paths
from sandbox.world.directory import Directory
from sandbox.world.joint_pose import coordinate
from sandbox.world.region_rows import add_regions
from sandbox.world.reseam import add_seams, remove_seams
from sandbox.world.shape_rows import Rows
from sandbox.world.state import State
from sandbox.world.tiling import check_room, rejoin, rejoin_around

Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class Added:
    """How many bodies, shapes and joints there were before others came; how many thrusters, paths and regions came."""

    bodies: int
    shapes: int
    joints: int
    thrusters: int
    paths: int
    regions: int


@dataclass(frozen=True)
class Moved:
    """Where rows have gone: the new row of each old body, shape and joint, -1 if it is gone, and which contacts are
    left. `first_body` and `first_shape` are the first rows that have changed."""

    bodies: Integers
    shapes: Integers
    joints: Integers
    contacts: Flags
    first_body: int
    first_shape: int


def add_rows(state: State, directory: Directory, found: Spawned) -> Added:
    """Add bodies, joints and regions after all others.

    `directory` knows those that are there, and then these as well. Raises `CapacityError`, and adds nothing, where too
    many static polygons would lie in one place.
    """
    before = len(state.bodies), len(state.shapes), len(state.joints)
    thrusters, paths = len(state.thrusters), len(state.paths)
    if found.bodies:
        _append_bodies(state, found.bodies)
    state.census.bodies.add(found.bodies, found.body_words)
    state.census.joints.add(found.joints, found.joint_words)
    state.census.regions.add(found.regions, found.region_words)
    directory.add(len(found.bodies), len(found.joints), len(found.regions))
    if found.joints:
        _append_joints(state, build_joints(found.joints, state.bodies, directory.body, directory.joint))
    if found.regions:
        add_regions(state, found.regions)
    if found.bodies or found.joints:
        state.layout += 1
    return Added(*before, len(state.thrusters) - thrusters, len(state.paths) - paths, len(found.regions))


def _append_bodies(state: State, flat: Sequence[FlatBody]) -> None:
    bodies, shapes, vertices, sides, seams = body_rows(flat, state.patterns)
    if (bodies["type"] == records.STATIC).any():
        check_room(state, *(rows.view(np.recarray) for rows in (bodies, shapes, vertices)))
    if any(body.thrusters for body in flat):
        _append_thrusters(state, flat, bodies)
    if any(body.path is not None for body in flat):
        paths = plain(build_paths(flat, bodies))
        paths["body"] += len(state.bodies)
        state.paths = extended(state.paths, paths)
    fixed = bodies["type"] != records.DYNAMIC
    if fixed.any() and (plain(state.bodies)["awake"] == 0).any():
        bodies["posed"][fixed] = 1  # what sleeps where it comes has to notice
    tiles = add_seams(state, bodies, shapes, seams)
    for name, count in (
        ("body", len(state.bodies)), ("vertex_start", len(state.vertices)), ("outline_start", len(state.outlines))
    ):  # fmt: skip
        column = shapes[name]
        column += count  # `shapes[name] += count` writes the column once more
    state.bodies = extended(state.bodies, bodies)
    state.shapes = extended(state.shapes, shapes)
    state.vertices = extended(state.vertices, vertices)
    state.outlines = extended(state.outlines, sides)
    rejoin_around(state, tiles)


def _append_thrusters(state: State, flat: Sequence[FlatBody], bodies: Rows) -> None:
    step_rate, now = state.census.scene.settings.step_rate, int(state.counters[0].step_count)
    thrusters = plain(build_thrusters(flat, bodies.view(np.recarray), step_rate, now))
    thrusters["body"] += len(state.bodies)
    state.thrusters = extended(state.thrusters, thrusters)


def _append_joints(state: State, rows: Any) -> None:
    first = len(state.joints)
    state.joints = extended(state.joints, plain(rows))
    gears = first + np.flatnonzero(plain(state.joints)["joint_1"][first:] >= 0)
    for row in gears.tolist():
        joint = state.joints[row]
        one, two = state.joints[joint.joint_1], state.joints[joint.joint_2]  # a gear keeps what it finds
        joint.length = coordinate(state, one) + float(joint.ratio) * coordinate(state, two)


def remove_rows(state: State, directory: Directory, bodies: Flags, joints: Flags) -> Moved:
    """Take out the marked bodies and joints. Every joint of a marked body has to be marked as well."""
    shapes = plain(state.shapes)
    gone = bodies[shapes["body"]]
    body_rows, shape_rows, joint_rows = (_new_rows(~marked) for marked in (bodies, gone, joints))
    first = [int(marked.argmax()) if marked.any() else len(marked) for marked in (bodies, gone)]
    contacts = _remove_contacts(state, body_rows, shape_rows, first[0])
    if len(joints):
        _remove_joints(state, ~joints, body_rows, joint_rows)
    beside = np.zeros(0, np.int64)
    if bodies.any():
        beside = _remove_shapes(state, ~gone, body_rows, shape_rows)
        _remove_bodies(state, ~bodies, body_rows)
    rejoin(state, beside)
    names = state.census.bodies.remove(~bodies), state.census.joints.remove(~joints)
    directory.remove(*names)
    state.layout += 1
    return Moved(body_rows, shape_rows, joint_rows, contacts, *first)


def _remove_bodies(state: State, left: Flags, body_rows: Integers) -> None:
    state.bodies = without(state.bodies, left)
    island = plain(state.bodies)["island"]
    asleep = np.flatnonzero(island)
    island[asleep] = body_rows[island[asleep] - 1] + 1
    drags, thrusters = plain(state.drags), plain(state.thrusters)
    held = drags["body"] >= 0
    drags["body"][held] = body_rows[drags["body"][held]]
    if len(thrusters):
        state.thrusters = without(state.thrusters, left[thrusters["body"]])
        thrusters = plain(state.thrusters)
        thrusters["body"] = body_rows[thrusters["body"]]
    if len(state.paths):
        state.paths = without(state.paths, left[plain(state.paths)["body"]])
        plain(state.paths)["body"] = body_rows[plain(state.paths)["body"]]
    if len(state.sensings):
        _remove_sensings(state, left, body_rows)


def _remove_sensings(state: State, left: Flags, body_rows: Integers) -> None:
    sensings = plain(state.sensings)
    state.sensings = without(state.sensings, left[sensings["sensor_body"]] & left[sensings["body"]])
    sensings = plain(state.sensings)
    for name in ("sensor_body", "body"):
        sensings[name] = body_rows[sensings[name]]


def _remove_contacts(state: State, body_rows: Integers, shape_rows: Integers, first: int) -> Flags:
    """Take out the contacts of what goes, and name the others anew. Bodies before row `first` stay where they are, with
    their shapes: only contacts whose `body_b`, which is no less than `body_a`, is not one of them are looked at."""
    used: Any = plain(state.contacts)[: int(state.counters[0].contact_count)]
    moved = np.flatnonzero(used["body_b"] >= first)
    for side in "ab":
        used[f"shape_{side}"][moved] = shape_rows[used[f"shape_{side}"][moved]]
        used[f"body_{side}"][moved] = body_rows[used[f"body_{side}"][moved]]
    left = np.ones(len(used), np.bool_)
    left[moved] = (used["shape_a"][moved] >= 0) & (used["shape_b"][moved] >= 0)
    state.counters[0].contact_count = close_up(used, left)
    return left


def _remove_joints(state: State, left: Flags, body_rows: Integers, rows: Integers) -> None:
    state.joints = without(state.joints, left)
    joints = plain(state.joints)
    for name, moved in (("body_a", body_rows), ("body_b", body_rows), ("joint_1", rows), ("joint_2", rows)):
        joints[name] = np.append(moved, -1)[joints[name]]  # -1 stays -1


def _remove_shapes(state: State, left: Flags, body_rows: Integers, shape_rows: Integers) -> Integers:
    """Shapes with their vertices, outlines and seams, which lie in the order of the shapes. Returns the tiles that lay
    beside some of those."""
    shapes = plain(state.shapes)
    beside = remove_seams(state, left, shape_rows)
    for name, start, count in (
        ("vertices", "vertex_start", "vertex_count"), ("outlines", "outline_start", "outline_count"),
    ):  # fmt: skip
        counts = shapes[count]
        setattr(state, name, without(getattr(state, name), np.repeat(left, counts)))
        shapes[start] -= np.cumsum(np.where(left, 0, counts))
    state.shapes = without(state.shapes, left)
    shapes = plain(state.shapes)
    shapes["body"] = body_rows[shapes["body"]]
    return beside


def _new_rows(left: Flags) -> Integers:
    """The new row of each old one; -1 for those that go."""
    rows: Integers = np.where(left, np.cumsum(left) - 1, -1)
    return rows
