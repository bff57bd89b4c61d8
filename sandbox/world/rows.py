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
from sandbox.world.contact_rows import contacts_of
from sandbox.world.directory import Directory
from sandbox.world.joint_pose import coordinate
from sandbox.world.new_rows import NewRows
from sandbox.world.region_rows import add_regions
from sandbox.world.reseam import add_seams, remove_seams
from sandbox.world.shape_rows import Rows, first_shape
from sandbox.world.state import State
from sandbox.world.tiling import Bodies, check_room, rejoin, rejoin_around

Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class Added:
    """How many bodies, shapes and joints there were before others came; how many thrusters, paths and regions came.
    `rejoined` as in `Moved`."""

    bodies: int
    shapes: int
    joints: int
    thrusters: int
    paths: int
    regions: int
    rejoined: Bodies


@dataclass(frozen=True)
class Moved:
    """Where bodies, shapes and joints have gone, and which contacts are left. Of shapes the first is that of the first
    body whose row has changed. `types` are what the bodies from that one on were, `renamed` the old rows of contacts
    that have gone or name others now, `rejoined` the static bodies that have come to abut others by that, or no longer
    do."""

    bodies: NewRows
    shapes: NewRows
    joints: NewRows
    contacts: Flags
    types: Integers
    renamed: Integers
    rejoined: Bodies


def add_rows(state: State, directory: Directory, found: Spawned) -> Added:
    """Add bodies, joints and regions after all others.

    `directory` knows those that are there, and then these as well. Raises `CapacityError`, and adds nothing, where too
    many static polygons would lie in one place.
    """
    before = len(state.bodies), len(state.shapes), len(state.joints)
    thrusters, paths = len(state.thrusters), len(state.paths)
    rejoined = _append_bodies(state, found.bodies) if found.bodies else ()
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
    return Added(*before, len(state.thrusters) - thrusters, len(state.paths) - paths, len(found.regions), rejoined)


def _append_bodies(state: State, flat: Sequence[FlatBody]) -> Bodies:
    """Returns the bodies that they join anew."""
    bodies, shapes, vertices, sides, seams = body_rows(flat, state.patterns)
    if (bodies["type"] == records.STATIC).any():
        check_room(state, *(rows.view(np.recarray) for rows in (bodies, shapes, vertices)))
    if any(body.thrusters for body in flat):
        _append_thrusters(state, flat, bodies)
    if any(body.path is not None for body in flat):
        paths = plain(build_paths(flat, bodies, state.census.scene.settings.step_rate))
        paths["body"] += len(state.bodies)
        state.paths = extended(state.paths, paths)
    fixed = bodies["type"] != records.DYNAMIC
    if fixed.any() and state.counters[0].asleep_count > 0 and (plain(state.bodies)["awake"] == 0).any():
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
    return rejoin_around(state, tiles)


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
    first = int(bodies.argmax()) if bodies.any() else len(bodies)
    tail = plain(state.shapes)[first_shape(state.shapes, first) :]
    body_rows = NewRows.of(first, ~bodies[first:])
    shape_rows = NewRows.of(len(state.shapes) - len(tail), ~bodies[tail["body"]])
    joint_rows = NewRows.of(0, ~joints)
    types = plain(state.bodies)["type"][first:].copy()
    contacts, renamed = _remove_contacts(state, body_rows, shape_rows)
    if len(joints):
        _remove_joints(state, body_rows, joint_rows)
    beside = np.zeros(0, np.int64)
    if bodies.any():
        beside = _remove_shapes(state, body_rows, shape_rows)
        _remove_bodies(state, body_rows)
    rejoined = rejoin(state, beside)
    names = (
        state.census.bodies.remove(np.flatnonzero(bodies).tolist()),
        state.census.joints.remove(np.flatnonzero(joints).tolist()),
    )
    directory.remove(*names)
    state.layout += 1
    return Moved(body_rows, shape_rows, joint_rows, contacts, types, renamed, rejoined)


def _remove_bodies(state: State, rows: NewRows) -> None:
    state.bodies = without(state.bodies, rows.left, rows.first)
    island = plain(state.bodies)["island"][rows.first :]
    asleep = np.flatnonzero(island)
    island[asleep] = rows[island[asleep] - 1] + 1
    drags = plain(state.drags)
    drags["body"] = rows[drags["body"]]
    for name, columns in (("thrusters", ["body"]), ("paths", ["body"]), ("sensings", ["sensor_body", "body"])):
        if len(getattr(state, name)):
            _remove_of_bodies(state, name, columns, rows)


def _remove_of_bodies(state: State, name: str, columns: Sequence[str], rows: NewRows) -> None:
    """Take out of a table what belongs to bodies that go, by its columns with rows of bodies."""
    table = plain(getattr(state, name))
    for column in columns:
        table[column] = rows[table[column]]
    left = np.logical_and.reduce([table[column] >= 0 for column in columns])
    setattr(state, name, without(getattr(state, name), left))


def _remove_contacts(state: State, body_rows: NewRows, shape_rows: NewRows) -> tuple[Flags, Integers]:
    """Take out the contacts of what goes, and name the others anew: returns which are left, and which those are. Bodies
    before the first one that goes stay where they are, with their shapes: only the contacts of later ones are looked
    at."""
    used: Any = plain(state.contacts)[: int(state.counters[0].contact_count)]
    moved = contacts_of(state.contacts, len(used), np.arange(body_rows.first, len(body_rows)), state.resting)
    for side in "ab":
        used[f"shape_{side}"][moved] = shape_rows[used[f"shape_{side}"][moved]]
        used[f"body_{side}"][moved] = body_rows[used[f"body_{side}"][moved]]
    left = np.ones(len(used), np.bool_)
    left[moved] = (used["shape_a"][moved] >= 0) & (used["shape_b"][moved] >= 0)
    state.counters[0].contact_count = close_up(used, left)
    return left, moved


def _remove_joints(state: State, body_rows: NewRows, rows: NewRows) -> None:
    gone = np.flatnonzero(~rows.left)
    if state.joined is not None:
        state.joined = state.joined.before(body_rows.first, int(gone[0]) if len(gone) else len(rows.left))
    state.joints = without(state.joints, rows.left, rows.first)
    joints = plain(state.joints)
    for name, moved in (("body_a", body_rows), ("body_b", body_rows), ("joint_1", rows), ("joint_2", rows)):
        joints[name] = moved[joints[name]]


def _remove_shapes(state: State, body_rows: NewRows, rows: NewRows) -> Integers:
    """Shapes with their vertices, outlines and seams, which lie in the order of the shapes. Returns the tiles that lay
    beside some of those."""
    beside = remove_seams(state, rows)
    shapes = plain(state.shapes)[rows.first :]
    for name, start, count in (
        ("vertices", "vertex_start", "vertex_count"), ("outlines", "outline_start", "outline_count"),
    ):  # fmt: skip
        table, counts = getattr(state, name), shapes[count]
        if len(table) == 0:
            continue
        setattr(state, name, without(table, np.repeat(rows.left, counts), len(table) - int(counts.sum())))
        shapes[start] -= np.cumsum(np.where(rows.left, 0, counts))
    state.shapes = without(state.shapes, rows.left, rows.first)
    shapes = plain(state.shapes)[rows.first :]
    shapes["body"] = body_rows[shapes["body"]]
    return beside
