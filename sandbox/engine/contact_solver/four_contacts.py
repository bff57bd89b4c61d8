"""Four contacts side by side, from their rows and put ahead to the middle of the step: what a block is filled from."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel
from sandbox._vectors import Mask, Vector, select
from sandbox.engine.contact_solver.contact_rows import (
    ANCHOR_AND_SEPARATION_2,
    ANCHORS_1,
    AXIS,
    KEPT_OF_POINT_1,
    KEPT_OF_POINT_2,
    SEPARATION_1_AND_ANCHOR_2,
    point_counts,
)
from sandbox.engine.contact_solver.gather import PairPose
from sandbox.engine.contact_solver.law import Anchors
from sandbox.engine.midpoint.move_contact import Axis, moved_axis, moved_point
from sandbox.engine.records.gather_fields import Rows, gather_fields
from sandbox.tables import Records


class Points(NamedTuple):
    """One of the two points of each of four contacts: its anchors and its gap (m), and what it kept of the step
    before: impulses (N s) in a substep of level 0, the rest length (m)."""

    anchors: Anchors
    separation: Vector
    load: Vector
    tangent: Vector
    rest_length: Vector


class FourContacts(NamedTuple):
    """What the lanes of a block are filled from; `both` tells which contacts have two points."""

    axes: Axis
    one: Points
    two: Points
    both: Mask
    rolling_impulse: Vector


@inlined_kernel
def read_contacts(contacts: Records, rows: Rows) -> FourContacts:
    """What four contacts have; a second point that is not there lies at the place of the first."""
    axes = Axis(*gather_fields(contacts, rows, AXIS))
    anchors = Anchors(*gather_fields(contacts, rows, ANCHORS_1))
    separation1, ax, _, _ = gather_fields(contacts, rows, SEPARATION_1_AND_ANCHOR_2)
    ay, bx, by, separation2 = gather_fields(contacts, rows, ANCHOR_AND_SEPARATION_2)
    load, tangent, rest_length, _ = gather_fields(contacts, rows, KEPT_OF_POINT_1)
    one = Points(anchors, separation1, load, tangent, rest_length)
    load, tangent, rest_length, rolling_impulse = gather_fields(contacts, rows, KEPT_OF_POINT_2)
    both = point_counts(contacts, rows) == 2.0
    anchors = Anchors(
        select(both, ax, one.anchors.ax),
        select(both, ay, one.anchors.ay),
        select(both, bx, one.anchors.bx),
        select(both, by, one.anchors.by),
    )
    separation2 = select(both, separation2, separation1)
    two = Points(anchors, separation2, load, tangent, select(both, rest_length, one.rest_length))
    return FourContacts(axes, one, two, both, rolling_impulse)


@inlined_kernel
def moved_by(four: FourContacts, way: PairPose, owners: Vector) -> FourContacts:
    """The same after the bodies have moved so far."""
    axes = moved_axis(four.axes, four.one.anchors, way, owners)
    one = _moved_points(four.one, four.axes, axes, way, owners)
    two = _moved_points(four.two, four.axes, axes, way, owners)
    return FourContacts(axes, one, two, four.both, four.rolling_impulse)


@inlined_kernel
def _moved_points(of: Points, before: Axis, after: Axis, way: PairPose, owners: Vector) -> Points:
    anchors, separation = moved_point(of.anchors, of.separation, before, after, way, owners)
    return Points(anchors, separation, of.load, of.tangent, of.rest_length)
