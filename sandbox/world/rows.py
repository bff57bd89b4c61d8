"""Rows come and go: bodies and joints are added at the end or taken out, and all that points at rows follows.

What stays is moved byte for byte: poses, velocities, sleep, the impulses of contacts and joints. The tables come out as
if the world had been built without what is gone, so nothing depends on the way that led there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.scene.flat import FlatBody, FlatJoint
from sandbox.tables import Integers, Records, Table, taken
from sandbox.world import records
from sandbox.world.body_rows import body_tables
from sandbox.world.build_fields import build_thrusters
from sandbox.world.build_joints import build_joints
from sandbox.world.directory import Directory
from sandbox.world.field_records import THRUSTER
from sandbox.world.flush import find_tiles
from sandbox.world.joint_pose import coordinate
from sandbox.world.joint_records import JOINT
from sandbox.world.reseam import reseam
from sandbox.world.state import State

Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class Moved:
    """Where rows have gone: the new row of each old body and shape, -1 if it is gone, and the old rows of the contacts
    that are left."""

    bodies: Integers
    shapes: Integers
    contacts: Integers


def add_rows(
    state: State,
    directory: Directory,
    bodies: Sequence[FlatBody],
    joints: Sequence[FlatJoint],
    words: tuple[Sequence[str], Sequence[str]],
) -> Moved:
    """Add bodies and joints after all others; `words` are what each of them can be read from again.

    `directory` knows those that are there, and then these as well.
    """
    count, shape_count = len(state.bodies), len(state.shapes)
    tables = body_tables(bodies)
    sleepers = bool((state.bodies.awake == 0).any())
    _append_bodies(state, tables, bodies, sleepers)
    roster = state.roster
    directory.add([body.id for body in bodies], [joint.id for joint in joints])
    _append_joints(state, build_joints(joints, state.bodies, directory.body, directory.joint))
    state.roster = type(roster)(
        roster.scene, roster.bodies.plus(bodies, words[0]), roster.joints.plus(joints, words[1])
    )
    state.layout += 1
    contacts = int(state.counters[0].contact_count)
    return Moved(np.arange(count), np.arange(shape_count), np.arange(contacts))


def _append_bodies(state: State, tables: tuple[Records, ...], flat: Sequence[FlatBody], sleepers: bool) -> None:
    bodies, shapes, vertices, sides, seams = tables
    thrusters = build_thrusters(flat, bodies, state.roster.scene.settings.step_rate, int(state.counters[0].step_count))
    thrusters.body += len(state.bodies)
    if sleepers:
        bodies.posed[bodies.type != records.DYNAMIC] = 1  # what sleeps where it comes has to notice
    tiled = len(find_tiles(bodies, shapes)) > 0
    shapes.body += len(state.bodies)
    shapes.vertex_start += len(state.vertices)
    shapes.outline_start += len(state.outlines)
    shapes.seam_start += len(state.seams)
    old_seams = _joined(records.SEAM, state.seams, seams)
    state.bodies = _joined(records.BODY, state.bodies, bodies)
    state.shapes = _joined(records.SHAPE, state.shapes, shapes)
    state.vertices = _joined(records.VERTEX, state.vertices, vertices)
    state.outlines = _joined(records.OUTLINE, state.outlines, sides)
    state.thrusters = _joined(THRUSTER, state.thrusters, thrusters)
    reseam(state, old_seams, tiled)


def _append_joints(state: State, rows: Records) -> None:
    first = len(state.joints)
    state.joints = _joined(JOINT, state.joints, rows)
    for joint in state.joints[first:]:
        if joint.joint_1 >= 0:  # a gear keeps what it finds
            one, two = state.joints[joint.joint_1], state.joints[joint.joint_2]
            joint.length = coordinate(state, one) + float(joint.ratio) * coordinate(state, two)


def remove_rows(state: State, bodies: Flags, joints: Flags) -> Moved:
    """Take out the marked bodies and joints. Every joint of a marked body has to be marked as well."""
    gone = bodies[state.shapes.body]
    tiled = bool(gone[find_tiles(state.bodies, state.shapes)].any())
    body_rows, shape_rows = _new_rows(~bodies), _new_rows(~gone)
    contacts = _remove_contacts(state, body_rows, shape_rows)
    _remove_joints(state, ~joints, body_rows)
    _remove_shapes(state, ~gone, body_rows)
    state.bodies = taken(state.bodies, ~bodies)
    asleep = state.bodies.island > 0
    state.bodies.island[asleep] = body_rows[state.bodies.island[asleep] - 1] + 1
    held = state.drags.body >= 0
    state.drags.body[held] = body_rows[state.drags.body[held]]
    state.thrusters = taken(state.thrusters, ~bodies[state.thrusters.body])
    state.thrusters.body = body_rows[state.thrusters.body]
    roster = state.roster
    rows = [np.flatnonzero(~marked).tolist() for marked in (bodies, joints)]
    state.roster = type(roster)(roster.scene, roster.bodies.only(rows[0]), roster.joints.only(rows[1]))
    reseam(state, state.seams, tiled)
    state.layout += 1
    return Moved(body_rows, shape_rows, contacts)


def _remove_contacts(state: State, body_rows: Integers, shape_rows: Integers) -> Integers:
    used: Any = state.contacts[: int(state.counters[0].contact_count)]
    left: Integers = np.flatnonzero((shape_rows[used.shape_a] >= 0) & (shape_rows[used.shape_b] >= 0))
    rows = used[left]
    rows.shape_a, rows.shape_b = shape_rows[rows.shape_a], shape_rows[rows.shape_b]
    rows.body_a, rows.body_b = body_rows[rows.body_a], body_rows[rows.body_b]
    state.contacts[: len(left)] = rows
    state.counters[0].contact_count = len(left)
    return left


def _remove_joints(state: State, left: Flags, body_rows: Integers) -> None:
    joints, rows = taken(state.joints, left), _new_rows(left)
    for name, moved in (("body_a", body_rows), ("body_b", body_rows), ("joint_1", rows), ("joint_2", rows)):
        joints[name] = np.append(moved, -1)[joints[name]]  # -1 stays -1
    state.joints = joints


def _remove_shapes(state: State, left: Flags, body_rows: Integers) -> None:
    """Shapes with their vertices and outlines, which lie in the order of the shapes."""
    shapes = state.shapes
    state.vertices = taken(state.vertices, np.repeat(left, shapes.vertex_count))
    state.outlines = taken(state.outlines, np.repeat(left, shapes.outline_count))
    shapes = state.shapes = taken(shapes, left)
    shapes.body = body_rows[shapes.body]
    shapes.vertex_start = np.cumsum(shapes.vertex_count) - shapes.vertex_count
    shapes.outline_start = np.cumsum(shapes.outline_count) - shapes.outline_count


def _joined(table: Table, first: Records, second: Records) -> Records:
    rows = table.zeros(len(first) + len(second))
    rows[: len(first)], rows[len(first) :] = first, second
    return rows


def _new_rows(left: Flags) -> Integers:
    """The new row of each old one; -1 for those that go."""
    rows: Integers = np.where(left, np.cumsum(left) - 1, -1)
    return rows
