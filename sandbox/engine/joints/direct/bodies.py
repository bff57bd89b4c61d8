"""The bodies of a batch between the world and the joint solver: gathered before a pass, scattered after it."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox._vectors import WIDTH, absolute, any_lane, load, store
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import Batches
from sandbox.geometry.trig import NEAR_ZERO, cos_sin, cos_sin_near_zero
from sandbox.tables import Records


@kernel
def gather_bodies(d: Batches, batch: Records, motions: Records, free_motions: Records, moving: bool) -> None:
    """Take over velocities and displacements. Half of what forces add is held back while bodies are `moving`, and given
    back after.

    That is the velocity Verlet scheme: positions move by the velocity at the middle of the substep.
    """
    v = d.memory
    layout = d.layouts[batch.layout]
    for slot in range(layout.seats):
        for k in range(WIDTH):
            place = slot * at.SEAT_SIZE + k
            seat = batch.seats + place
            body = d.bodies[batch.bodies + slot * WIDTH + k]
            if body < 0:
                for field in range(at.SEAT_SIZE // WIDTH):
                    v[place + field * WIDTH] = 0.0
                v[place + at.DELTA_COS] = 1.0
                continue
            motion = motions[body]
            x = motion.velocity_x
            y = motion.velocity_y
            w = motion.angular_velocity
            if v[batch.lanes + at.HALVES + k] == 1.0 and v[seat + at.INVERSE_MASS] != 0.0:
                if moving:
                    free_motion = free_motions[body]
                    v[seat + at.KICK_X] = 0.5 * (free_motion.free_x - free_motion.start_x)
                    v[seat + at.KICK_Y] = 0.5 * (free_motion.free_y - free_motion.start_y)
                    v[seat + at.KICK_W] = 0.5 * (free_motion.free_w - free_motion.start_w)
                sign = -1.0 if moving else 1.0
                x += sign * v[seat + at.KICK_X]
                y += sign * v[seat + at.KICK_Y]
                w += sign * v[seat + at.KICK_W]
            v[place + at.VELOCITY_X] = x
            v[place + at.VELOCITY_Y] = y
            v[place + at.VELOCITY_W] = w
            v[place + at.DELTA_X] = motion.delta_x
            v[place + at.DELTA_Y] = motion.delta_y
            v[place + at.DELTA_ANGLE] = motion.delta_angle
            v[place + at.DELTA_COS] = motion.delta_cos
            v[place + at.DELTA_SIN] = motion.delta_sin


@kernel
def scatter_bodies(d: Batches, batch: Records, motions: Records) -> None:
    """Give the velocities back."""
    v = d.memory
    for slot in range(d.layouts[batch.layout].moving):
        for k in range(batch.count):
            place = slot * at.SEAT_SIZE + k
            if v[batch.seats + place + at.INVERSE_MASS] > 0.0:
                motion = motions[d.bodies[batch.bodies + slot * WIDTH + k]]
                motion.velocity_x = v[place + at.VELOCITY_X]
                motion.velocity_y = v[place + at.VELOCITY_Y]
                motion.angular_velocity = v[place + at.VELOCITY_W]


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
            c, s = cos_sin_near_zero(turn)
            if any_lane(absolute(turn) > NEAR_ZERO):
                store(v, place + at.SIN, turn)
                for k in range(WIDTH):
                    v[place + at.COS + k], v[place + at.SIN + k] = cos_sin(v[place + at.SIN + k])
                c = load(v, place + at.COS)
                s = load(v, place + at.SIN)
        else:
            c = load(v, place + at.DELTA_COS)
            s = load(v, place + at.DELTA_SIN)
        start_cos = load(v, seat + at.START_COS)
        start_sin = load(v, seat + at.START_SIN)
        store(v, place + at.COS, start_cos * c - start_sin * s)
        store(v, place + at.SIN, start_sin * c + start_cos * s)
