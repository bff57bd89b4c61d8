"""Stage: hold what would have come out on the other side.

The solver stops what the narrow phase has foreseen. What it could not foresee (a spinning rod, a body that another
one shot off in mid-step, a press of contacts that disagree) is caught here: each body whose way in the step was long
enough to matter is swept along it, and stopped where it first touches if it would have come through, or deep into,
something immovable. It keeps its velocity, but for what gravity added on the way taken back, so that the next step
finds it touching and does the bounce, at the energy that belongs to the height.
Static bodies hold all dynamic ones, moving bodies hold only those marked as bullets.
"""

from __future__ import annotations

import math

from sandbox._jit import ZERO, entry_point, kernel
from sandbox.engine.bounds import shape_margin
from sandbox.engine.broad_phase import propose
from sandbox.engine.grid import boxes_overlap
from sandbox.engine.integrate import place_origin
from sandbox.engine.islands import is_active
from sandbox.engine.joints.apart import are_joined
from sandbox.engine.one_way import comes_from_front
from sandbox.geometry.sweep import time_of_hit
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Integers, Records
from sandbox.world.records import DYNAMIC, KINEMATIC, ONE_WAY, STATIC

FAST_SHARE = 0.5
"""A body that moves or swings farther in a step than this share of its half width is swept."""
DEEP = 0.005
"""Overlap that is let pass, in metres: it is pushed out in time."""
DEEP_SHARE = 0.25
"""Past this share of the half widths of both, shapes are about to come out on the wrong side."""
_LEAST_DEEP = 1e-9
_ROUNDS = 16
_SAME = 0.999
"""A hit this late on the way is the touch at which the way has been made to end."""


@kernel
def expect_fast(bodies: Records, holds: Records, seconds: float) -> None:
    """Mark the bodies that set out to go or swing far, or to turn past what `look_ahead` sees; `mark_fast` adds others.

    One that is stopped in mid-step ends near to where it began, and may have turned deep into something.
    """
    for i in range(bodies.shape[0]):
        body = bodies[i]
        turn = seconds * abs(body.angular_velocity)
        swing = turn * (body.extent - holds[i].thin)
        way = seconds * (abs(body.velocity_x) + abs(body.velocity_y))
        far = way + swing > FAST_SHARE * holds[i].thin or 0.5 * turn * swing > shape_margin(body.extent)
        holds[i].fast = 1 if far else 0


@kernel
def mark_fast(bodies: Records, motions: Records, holds: Records) -> int:
    """Mark the active bodies that may have passed through something in this step; return how many.

    Bullets always: something fast may have passed over them. `expect_fast` has marked some already.
    """
    count = ZERO
    for i in range(bodies.shape[0]):
        body = bodies[i]
        motion = motions[i]
        hold = holds[i]
        swing = abs(motion.delta_angle) * (body.extent - hold.thin)
        far = hold.fast == 1 or abs(motion.delta_x) + abs(motion.delta_y) + swing > FAST_SHARE * hold.thin
        hold.fast = 0
        if (far or hold.deep == 1 or body.bullet == 1) and is_active(body):
            hold.fast = 1
            count += 1
    return count


@kernel
def allowed_depth(a: Records, b: Records) -> float:
    """How deep two shapes may get into each other unforeseen, in metres."""
    share = DEEP_SHARE * (a.thin + b.thin)
    share = share if share < DEEP else DEEP
    return float(share if share > _LEAST_DEEP else _LEAST_DEEP)


@entry_point
def catch(
    bodies: Records,
    shapes: Records,
    settings: Records,
    counters: Records,
    motions: Records,
    holds: Records,
    turned: Records,
    boxes: Records,
    owners: Records,
    pairs: Records,
    sorted_pairs: Records,
    manifold: Records,
    sweep: Records,
    swept: Records,
    bonds: Records,
    joined: Integers,
) -> None:
    """Take the bodies that `mark_fast` marked back to where they first touch what they may not pass.

    `bodies` are at the end of the step, `turned` and `boxes` are of its beginning, `motions` lie between.
    """
    for i in range(bodies.shape[0]):
        holds[i].stop = 1.0
        holds[i].bounces = 0
    count = _list_fast(holds, owners, pairs, counters[0].pair_count, sorted_pairs)
    for k in range(count):
        _ride(bodies, shapes, motions, holds, turned, sorted_pairs[k], manifold, sweep, swept)
    bullets = ZERO
    for k in range(count):
        bullets += _hold(bodies, shapes, motions, holds, turned, sorted_pairs[k], manifold, sweep, swept)
    for i in range(shapes.shape[0]):
        if holds[owners[i].body].fast == 1 and _strays(bodies, shapes, motions, turned, boxes, i):
            for j in range(shapes.shape[0]):
                if not boxes_overlap(boxes[i], boxes[j]) or are_joined(bonds, joined, owners[i].body, owners[j].body):
                    continue
                if propose(owners, i, j, sorted_pairs, count) > count:
                    _hold(bodies, shapes, motions, holds, turned, sorted_pairs[count], manifold, sweep, swept)
    changed = bullets > 0
    turn = ZERO
    while changed:
        changed = False
        for k in range(count):
            if _hold_bullet(bodies, shapes, motions, holds, turned, sorted_pairs[k], turn, manifold, sweep, swept):
                changed = True
        turn += 1
    for i in range(bodies.shape[0]):
        if holds[i].stop < 1.0:
            share = 1.0 - holds[i].stop
            _take_back(bodies[i], motions[i], share)
            if holds[i].bounces == 1:
                _take_back_fall(bodies[i], motions[i], share, settings[0])


@kernel
def _list_fast(holds: Records, owners: Records, pairs: Records, pair_count: int, fast: Records) -> int:
    """List the pairs of which a body is fast, in order; return how many. The rest of the table stays free for one."""
    count = ZERO
    for k in range(pair_count):
        if holds[owners[pairs[k].shape_a].body].fast + holds[owners[pairs[k].shape_b].body].fast > 0:
            fast[count] = pairs[k]
            count += 1
    return count


@kernel
def _strays(bodies: Records, shapes: Records, motions: Records, turned: Records, boxes: Records, i: int) -> bool:
    """Whether a shape has left the box that the grid knew: its box becomes that of its true way then."""
    shape = shapes[i]
    body = bodies[shape.body]
    motion = motions[shape.body]
    swing = abs(motion.delta_angle)
    grow = shape.radius + body.extent * (swing if swing < 2.0 else 2.0)
    first = turned[shape.vertex_start]
    lower_x = first.x
    lower_y = first.y
    upper_x = first.x
    upper_y = first.y
    for j in range(shape.vertex_start + 1, shape.vertex_start + shape.vertex_count):
        x = turned[j].x
        y = turned[j].y
        lower_x = x if x < lower_x else lower_x
        lower_y = y if y < lower_y else lower_y
        upper_x = x if x > upper_x else upper_x
        upper_y = y if y > upper_y else upper_y
    dx = motion.delta_x
    dy = motion.delta_y
    lower_x = body.center_x + lower_x - grow - (dx if dx > 0.0 else 0.0)
    lower_y = body.center_y + lower_y - grow - (dy if dy > 0.0 else 0.0)
    upper_x = body.center_x + upper_x + grow - (dx if dx < 0.0 else 0.0)
    upper_y = body.center_y + upper_y + grow - (dy if dy < 0.0 else 0.0)
    box = boxes[i]
    inside_x = lower_x >= box.lower_x and upper_x <= box.upper_x
    if inside_x and lower_y >= box.lower_y and upper_y <= box.upper_y:
        return False
    box.lower_x = lower_x
    box.lower_y = lower_y
    box.upper_x = upper_x
    box.upper_y = upper_y
    return True


@kernel
def _hold(
    bodies: Records,
    shapes: Records,
    motions: Records,
    holds: Records,
    turned: Records,
    pair: Records,
    manifold: Records,
    sweep: Records,
    swept: Records,
) -> int:
    """Stop the fast body of a pair at the other one, if that is immovable; 1 if the pair is for `_hold_bullet`."""
    a = shapes[pair.shape_a].body
    b = shapes[pair.shape_b].body
    if holds[a].fast + holds[b].fast == 0:
        return 0
    if bodies[a].type != STATIC and bodies[b].type != STATIC:
        return int(bodies[a].bullet + bodies[b].bullet > 0)
    mover = b if bodies[a].type == STATIC else a
    _lay_way(bodies, motions, a, b, 0.0, 0.0, 1.0, 1.0, sweep[0])
    if (shapes[pair.shape_a].traits | shapes[pair.shape_b].traits) & ONE_WAY:
        slop = 2.0 * allowed_depth(shapes[pair.shape_a], shapes[pair.shape_b])  # what is caught may sink on
        if not comes_from_front(bodies, shapes, turned, pair.shape_a, pair.shape_b, sweep[0].x, sweep[0].y, slop):
            return 0
    t = _hit(shapes, turned, pair.shape_a, pair.shape_b, manifold, sweep, swept)
    if t >= 0.0 and t < holds[mover].stop:
        holds[mover].stop = t
        restitution = shapes[pair.shape_a].restitution + shapes[pair.shape_b].restitution
        holds[mover].bounces = 1 if restitution > 0.0 else 0
    return 0


@kernel
def _lay_way(
    bodies: Records,
    motions: Records,
    a: int,
    b: int,
    start_a: float,
    start_b: float,
    end_a: float,
    end_b: float,
    s: Records,
) -> None:
    """The relative way of two bodies, each between two times of its own way through the step."""
    x = bodies[b].center_x - bodies[a].center_x
    y = bodies[b].center_y - bodies[a].center_y
    back_a = 1.0 - start_a
    back_b = 1.0 - start_b
    s.x = x - back_b * motions[b].delta_x + back_a * motions[a].delta_x
    s.y = y - back_b * motions[b].delta_y + back_a * motions[a].delta_y
    long_a = end_a - start_a
    long_b = end_b - start_b
    s.way_x = long_b * motions[b].delta_x - long_a * motions[a].delta_x
    s.way_y = long_b * motions[b].delta_y - long_a * motions[a].delta_y
    s.angle_a = start_a * motions[a].delta_angle
    s.angle_b = start_b * motions[b].delta_angle
    s.turn_a = long_a * motions[a].delta_angle
    s.turn_b = long_b * motions[b].delta_angle


@kernel
def _hit(shapes: Records, turned: Records, i: int, j: int, manifold: Records, sweep: Records, swept: Records) -> float:
    """When the pair whose way is laid in `sweep` touches on its way into each other; -1 if it does not go there."""
    a = shapes[i]
    b = shapes[j]
    sweep[0].deep = allowed_depth(a, b)
    floor = DEEP_SHARE * (a.thin + b.thin)
    sweep[0].floor = floor if floor > sweep[0].deep else sweep[0].deep
    t = time_of_hit(
        turned, a.vertex_start, a.vertex_count, a.radius, b.vertex_start, b.vertex_count, b.radius, sweep, swept,
        manifold,
    )  # fmt: skip
    return float(t)


@kernel
def _hold_bullet(
    bodies: Records,
    shapes: Records,
    motions: Records,
    holds: Records,
    turned: Records,
    pair: Records,
    turn: int,
    manifold: Records,
    sweep: Records,
    swept: Records,
) -> bool:
    """Stop a bullet at another dynamic body, and then that body at the bullet; whether anything changed.

    Stopping one changes what others meet, so this is repeated until nothing changes. After `_ROUNDS` turns both
    stay where they were, which ends it for certain.
    """
    a = shapes[pair.shape_a].body
    b = shapes[pair.shape_b].body
    dynamic = bodies[a].type == DYNAMIC and bodies[b].type == DYNAMIC
    if not dynamic or bodies[a].bullet + bodies[b].bullet == 0 or holds[a].fast + holds[b].fast == 0:
        return False
    stop_a = holds[a].stop
    stop_b = holds[b].stop
    both = stop_a if stop_a < stop_b else stop_b
    _lay_way(bodies, motions, a, b, 0.0, 0.0, both, both, sweep[0])
    t = _hit(shapes, turned, pair.shape_a, pair.shape_b, manifold, sweep, swept)
    if both > 0.0 and 0.0 <= t < _SAME:
        t = t * both if turn < _ROUNDS else 0.0
        if bodies[a].bullet == 1 or turn >= _ROUNDS:
            holds[a].stop = t
        if bodies[b].bullet == 1 or turn >= _ROUNDS:
            holds[b].stop = t
        return True
    if stop_a == stop_b:
        return False
    _lay_way(bodies, motions, a, b, both, both, stop_a, stop_b, sweep[0])
    t = _hit(shapes, turned, pair.shape_a, pair.shape_b, manifold, sweep, swept)
    if t < 0.0 or t >= _SAME:
        return False
    late = b if stop_a < stop_b else a
    holds[late].stop = both + t * (holds[late].stop - both) if turn < _ROUNDS else 0.0
    return True


@kernel
def _ride(
    bodies: Records,
    shapes: Records,
    motions: Records,
    holds: Records,
    turned: Records,
    pair: Records,
    manifold: Records,
    sweep: Records,
    swept: Records,
) -> None:
    """Let a bullet that comes through a kinematic body be carried by it from where they touch."""
    a = shapes[pair.shape_a].body
    b = shapes[pair.shape_b].body
    if holds[a].fast + holds[b].fast == 0 or bodies[a].bullet + bodies[b].bullet == 0:
        return
    if bodies[a].type != KINEMATIC and bodies[b].type != KINEMATIC:
        return
    _lay_way(bodies, motions, a, b, 0.0, 0.0, 1.0, 1.0, sweep[0])
    t = _hit(shapes, turned, pair.shape_a, pair.shape_b, manifold, sweep, swept)
    if t < 0.0:
        return
    rider = b if bodies[a].type == KINEMATIC else a
    carrier = a if rider == b else b
    rest = 1.0 - t
    body = bodies[rider]
    way = motions[rider]
    other = motions[carrier]
    _take_back(body, way, rest)
    x = body.center_x - bodies[carrier].center_x + rest * other.delta_x
    y = body.center_y - bodies[carrier].center_y + rest * other.delta_y
    turn = rest * float(other.delta_angle)
    c, s = cos_sin(turn)
    x_after = bodies[carrier].center_x + c * x - s * y
    y_after = bodies[carrier].center_y + s * x + c * y
    way.delta_x = t * way.delta_x + (x_after - body.center_x)
    way.delta_y = t * way.delta_y + (y_after - body.center_y)
    way.delta_angle = t * way.delta_angle + turn
    body.center_x = x_after
    body.center_y = y_after
    angle: float = body.angle + turn
    body.angle = angle
    body.rotation_cos, body.rotation_sin = cos_sin(angle)
    place_origin(body)


@kernel
def _take_back(body: Records, motion: Records, share: float) -> None:
    """Take back that share of a body's way through the step."""
    body.center_x -= share * motion.delta_x
    body.center_y -= share * motion.delta_y
    if motion.delta_angle != 0.0:
        angle: float = body.angle - share * motion.delta_angle
        body.angle = angle
        body.rotation_cos, body.rotation_sin = cos_sin(angle)
    place_origin(body)


@kernel
def _take_back_fall(body: Records, motion: Records, share: float, setting: Records) -> None:
    """Give a body that was taken back the speed along gravity that belongs to the height where it is now.

    Or every catch of a bouncing body would lift or lower it for nothing. What stopped it in mid-step knows nothing of
    heights: the speed changes by no more than twice what gravity does in the time taken back.
    """
    ax = body.gravity_scale * setting.gravity_x
    ay = body.gravity_scale * setting.gravity_y
    square = ax * ax + ay * ay
    if square == 0.0:
        return
    size = math.sqrt(square)
    before = (body.velocity_x * ax + body.velocity_y * ay) / size
    after = before * before - 2.0 * share * (motion.delta_x * ax + motion.delta_y * ay)
    after = math.sqrt(after) if after > 0.0 else 0.0
    change = after - abs(before)
    most = 2.0 * share * setting.step_seconds * size
    change = change if change < most else most
    change = change if change > -most else -most
    change = change if before > 0.0 else -change
    body.velocity_x += change * ax / size
    body.velocity_y += change * ay / size
