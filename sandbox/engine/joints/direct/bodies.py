"""The bodies of a batch between the world and the joint solver: gathered before a pass, scattered after it."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, any_lane, lanes, load, select, spread, store, store_fields, transpose
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.passes import BLOW, MOVE
from sandbox.engine.joints.direct.records import Batches
from sandbox.engine.records.bodies import FREE_MOTION, POSE, VELOCITY
from sandbox.engine.records.gather_fields import Rows, gather_fields
from sandbox.geometry.trig import cos_sin_lanes
from sandbox.tables import Records

_START_X, _START_W = FREE_MOTION.places(("start_x", "start_w"), 8)
"""Numbers of fields of a free motion, from which on four are read at once."""


@kernel
def gather_bodies(d: Batches, batch: Records, motions: Records, free_motions: Records, purpose: int) -> None:
    """Take over velocities and displacements. Half of what forces add is held back before the move, and given back
    after it.

    That is the velocity Verlet scheme: positions move by the velocity at the middle of the substep.
    """
    v = d.memory
    halves = load(v, batch.lanes + at.HALVES) == 1.0
    parted = halves if purpose != BLOW else halves & ~halves
    for slot in range(d.layouts[batch.layout].seats):
        place = slot * at.SEAT_SIZE
        seat = batch.seats + place
        rows = _rows_of(d, batch, slot)
        if rows[0] < 0 or rows[1] < 0 or rows[2] < 0 or rows[3] < 0:
            _gather_beside_world(d, batch, slot, motions)
            continue
        x, y, w, delta_x = gather_fields(motions, rows, VELOCITY)
        delta_y, delta_cos, delta_sin, delta_angle = gather_fields(motions, rows, POSE)
        held = parted & (load(v, seat + at.INVERSE_MASS) != 0.0)
        if any_lane(held):
            if purpose == MOVE:
                start_x, start_y, _, _ = gather_fields(free_motions, rows, _START_X)
                start_w, free_x, free_y, free_w = gather_fields(free_motions, rows, _START_W)
                store(v, seat + at.KICK_X, 0.5 * (free_x - start_x))
                store(v, seat + at.KICK_Y, 0.5 * (free_y - start_y))
                store(v, seat + at.KICK_W, 0.5 * (free_w - start_w))
            sign = 1.0
            if purpose == MOVE:
                sign = -1.0 if batch.between == 0 else 0.0
            x = select(held, x + sign * load(v, seat + at.KICK_X), x)
            y = select(held, y + sign * load(v, seat + at.KICK_Y), y)
            w = select(held, w + sign * load(v, seat + at.KICK_W), w)
        store(v, place + at.VELOCITY_X, x)
        store(v, place + at.VELOCITY_Y, y)
        store(v, place + at.VELOCITY_W, w)
        store(v, place + at.DELTA_X, delta_x)
        store(v, place + at.DELTA_Y, delta_y)
        store(v, place + at.DELTA_ANGLE, delta_angle)
        store(v, place + at.DELTA_COS, delta_cos)
        store(v, place + at.DELTA_SIN, delta_sin)


@kernel
def gather_starts(d: Batches, batch: Records, free_motions: Records) -> None:
    """Take over the velocities with which the substep began."""
    v = d.memory
    for slot in range(d.layouts[batch.layout].seats):
        place = slot * at.SEAT_SIZE
        for k in range(batch.count):
            body = d.bodies[batch.bodies + slot * WIDTH + k]
            v[place + at.VELOCITY_X + k] = free_motions[body].start_x if body >= 0 else 0.0
            v[place + at.VELOCITY_Y + k] = free_motions[body].start_y if body >= 0 else 0.0
            v[place + at.VELOCITY_W + k] = free_motions[body].start_w if body >= 0 else 0.0


@inlined_kernel
def _rows_of(d: Batches, batch: Records, slot: int) -> Rows:
    """The bodies on a seat, in each lane; -1 is the world."""
    first = batch.bodies + slot * WIDTH
    return d.bodies[first], d.bodies[first + 1], d.bodies[first + 2], d.bodies[first + 3]


@kernel
def _gather_beside_world(d: Batches, batch: Records, slot: int, motions: Records) -> None:
    """The same for a seat that joints cannot move and on which some part has the world, which stays where it is."""
    v = d.memory
    place = slot * at.SEAT_SIZE
    for field in range(at.VELOCITY_X, at.TENSION, WIDTH):
        store(v, place + field, spread(0.0))
    for field in range(at.DELTA_X, at.AHEAD_X, WIDTH):
        store(v, place + field, spread(1.0 if field == at.DELTA_COS else 0.0))
    for k in range(batch.count):
        body = d.bodies[batch.bodies + slot * WIDTH + k]
        if body >= 0:
            motion = motions[body]
            v[place + at.VELOCITY_X + k] = motion.velocity_x
            v[place + at.VELOCITY_Y + k] = motion.velocity_y
            v[place + at.VELOCITY_W + k] = motion.angular_velocity
            v[place + at.DELTA_X + k] = motion.delta_x
            v[place + at.DELTA_Y + k] = motion.delta_y
            v[place + at.DELTA_ANGLE + k] = motion.delta_angle
            v[place + at.DELTA_COS + k] = motion.delta_cos
            v[place + at.DELTA_SIN + k] = motion.delta_sin


@kernel
def scatter_bodies(d: Batches, batch: Records, motions: Records) -> None:
    """Give the velocities back."""
    v = d.memory
    for slot in range(d.layouts[batch.layout].moving):
        place = slot * at.SEAT_SIZE
        row = _rows_of(d, batch, slot)
        x = load(v, place + at.VELOCITY_X)
        y = load(v, place + at.VELOCITY_Y)
        w = load(v, place + at.VELOCITY_W)
        motion = transpose(x, y, w, load(v, place + at.DELTA_X))
        mass = lanes(load(v, batch.seats + place + at.INVERSE_MASS))
        count = batch.count
        if mass[0] > 0.0:
            store_fields(motions, row[0], VELOCITY, motion[0])
        if mass[1] > 0.0 and count > 1:
            store_fields(motions, row[1], VELOCITY, motion[1])
        if mass[2] > 0.0 and count > 2:
            store_fields(motions, row[2], VELOCITY, motion[2])
        if mass[3] > 0.0 and count > 3:
            store_fields(motions, row[3], VELOCITY, motion[3])


@kernel
def look_ahead(d: Batches, batch: Records, ahead: float) -> None:
    """Poses of the bodies of a batch, those that joints cannot move included, `ahead` seconds from now."""
    v = d.memory
    for slot in range(d.layouts[batch.layout].seats):
        place = slot * at.SEAT_SIZE
        seat = batch.seats + place
        turn = load(v, place + at.DELTA_ANGLE) + ahead * load(v, place + at.VELOCITY_W)
        store(v, place + at.AHEAD_X, load(v, place + at.DELTA_X) + ahead * load(v, place + at.VELOCITY_X))
        store(v, place + at.AHEAD_Y, load(v, place + at.DELTA_Y) + ahead * load(v, place + at.VELOCITY_Y))
        store(v, place + at.ANGLE, load(v, seat + at.START_ANGLE) + turn)
        if ahead != 0.0:
            c, s = cos_sin_lanes(turn)
        else:
            c = load(v, place + at.DELTA_COS)
            s = load(v, place + at.DELTA_SIN)
        start_cos = load(v, seat + at.START_COS)
        start_sin = load(v, seat + at.START_SIN)
        store(v, place + at.COS, start_cos * c - start_sin * s)
        store(v, place + at.SIN, start_sin * c + start_cos * s)
