"""What only bullets do: they stop at other moving bodies, and kinematic ones carry them along."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.integrate import place_origin
from sandbox.engine.continuous_collision.contact_impulse import anchors_at, apply_contact_impulse, touch_of
from sandbox.engine.continuous_collision.relative_sweep import (
    Interval,
    SweepTables,
    set_relative_sweep,
    sweep_time_of_impact,
)
from sandbox.engine.continuous_collision.roll_back import roll_back
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC, KINEMATIC

_ROUNDS = 16
_SAME = 0.999
"""A time of impact this late on the sweep is the touch at which the sweep has been made to end."""


@kernel
def stop_bullets(tables: SweepTables, pairs: Records, threshold: float) -> None:
    """Stop bullets at other dynamic bodies, and those at them.

    Stopping one changes what others meet, so this is repeated until nothing changes. A pair is looked at again only if
    one of its bodies has been stopped since: otherwise it would give the same answer.
    """
    impacts = tables.ccd.impacts
    count = pairs.shape[0]
    look = 0
    changed = True
    while changed:
        changed = False
        for k in range(count):
            a = tables.shapes[pairs[k].shape_a].body
            b = tables.shapes[pairs[k].shape_b].body
            before = look - count  # when this pair was looked at in the turn before
            again = impacts[a].stopped >= before or impacts[b].stopped >= before
            if again and _stop_bullet(tables, pairs[k], look // count, threshold):
                changed = True
                impacts[a].stopped = impacts[b].stopped = look
            look += 1


@kernel
def _stop_bullet(tables: SweepTables, pair: Records, turn: int, threshold: float) -> bool:
    """Stop a bullet at another dynamic body, and then that body at the bullet; whether anything changed.

    Those that have touched all the while are struck apart, as `contact_impulse` says. After `_ROUNDS` turns both stay
    where they were, which ends it for certain.
    """
    a = tables.shapes[pair.shape_a].body
    b = tables.shapes[pair.shape_b].body
    dynamic = tables.bodies[a].type == DYNAMIC and tables.bodies[b].type == DYNAMIC
    if (
        not dynamic
        or tables.bodies[a].bullet + tables.bodies[b].bullet == 0
        or tables.ccd_bodies[a].fast + tables.ccd_bodies[b].fast == 0
    ):
        return False
    stop_a = tables.ccd.impacts[a].time
    stop_b = tables.ccd.impacts[b].time
    both = stop_a if stop_a < stop_b else stop_b
    set_relative_sweep(tables, a, b, Interval(0.0, 0.0, both, both))
    t = sweep_time_of_impact(tables, pair.shape_a, pair.shape_b)
    if both > 0.0 and 0.0 <= t < _SAME:
        _part(tables, pair, t, threshold)
        t = t * both if turn < _ROUNDS else 0.0
        if tables.bodies[a].bullet == 1 or turn >= _ROUNDS:
            tables.ccd.impacts[a].time = t
        if tables.bodies[b].bullet == 1 or turn >= _ROUNDS:
            tables.ccd.impacts[b].time = t
        return True
    if stop_a == stop_b:
        return False
    set_relative_sweep(tables, a, b, Interval(both, both, stop_a, stop_b))
    t = sweep_time_of_impact(tables, pair.shape_a, pair.shape_b)
    if t < 0.0 or t >= _SAME:
        return False
    _part(tables, pair, t, threshold)
    late = b if stop_a < stop_b else a
    tables.ccd.impacts[late].time = both + t * (tables.ccd.impacts[late].time - both) if turn < _ROUNDS else 0.0
    return True


@kernel
def _part(tables: SweepTables, pair: Records, t: float, threshold: float) -> None:
    """Strike the bodies of a pair apart that have touched until the time t of their sweep."""
    sweep = tables.ccd.sweep[0]
    if sweep.touched == 0:
        return
    a = tables.shapes[pair.shape_a]
    b = tables.shapes[pair.shape_b]
    touch = touch_of(sweep, a, b)
    apply_contact_impulse(tables.bodies[a.body], tables.bodies[b.body], anchors_at(sweep, t), touch, threshold)


@kernel
def carry_bullet(tables: SweepTables, pair: Records) -> None:
    """Let a bullet that comes through a kinematic body be carried by it from where they touch."""
    a = tables.shapes[pair.shape_a].body
    b = tables.shapes[pair.shape_b].body
    if (
        tables.ccd_bodies[a].fast + tables.ccd_bodies[b].fast == 0
        or tables.bodies[a].bullet + tables.bodies[b].bullet == 0
    ):
        return
    if tables.bodies[a].type != KINEMATIC and tables.bodies[b].type != KINEMATIC:
        return
    set_relative_sweep(tables, a, b, Interval(0.0, 0.0, 1.0, 1.0))
    t = sweep_time_of_impact(tables, pair.shape_a, pair.shape_b)
    if t < 0.0:
        return
    rider = b if tables.bodies[a].type == KINEMATIC else a
    carrier = a if rider == b else b
    rest = 1.0 - t
    body = tables.bodies[rider]
    motion = tables.motions[rider]
    other = tables.motions[carrier]
    roll_back(body, motion, rest)
    x = body.center_x - tables.bodies[carrier].center_x + rest * other.delta_x
    y = body.center_y - tables.bodies[carrier].center_y + rest * other.delta_y
    turn = rest * float(other.delta_angle)
    c, s = cos_sin(turn)
    x_after = tables.bodies[carrier].center_x + c * x - s * y
    y_after = tables.bodies[carrier].center_y + s * x + c * y
    motion.delta_x = t * motion.delta_x + (x_after - body.center_x)
    motion.delta_y = t * motion.delta_y + (y_after - body.center_y)
    motion.delta_angle = t * motion.delta_angle + turn
    body.center_x = x_after
    body.center_y = y_after
    angle: float = body.angle + turn
    body.angle = angle
    body.rotation_cos, body.rotation_sin = cos_sin(angle)
    place_origin(body)
