"""Stage: hold what would have come out on the other side.

The solver stops what the narrow phase has foreseen. What it could not foresee (a spinning rod, a body that another
one shot off in mid-step, a press of contacts that disagree) is caught here: each body whose way in the step was long
enough to matter is swept along it, and stopped where it first touches if it would have come through, or deep into,
something immovable. It keeps its velocity, but for what gravity added on the way taken back, so that the next step
finds it touching and does the bounce, at the energy that belongs to the height.
Static bodies hold all dynamic ones, moving bodies hold only those marked as bullets.
"""

from __future__ import annotations

from sandbox._jit import ZERO, entry_point, kernel
from sandbox.engine.broad_phase.grid import boxes_overlap
from sandbox.engine.broad_phase.pairs import propose
from sandbox.engine.broad_phase.proxies import ACTIVE, SLEEPS
from sandbox.engine.continuous_collision.bullets import hold_bullet, ride
from sandbox.engine.continuous_collision.contact_impulse import note_stop, strike_held
from sandbox.engine.continuous_collision.relative_sweep import allowed_depth, hit, lay_way
from sandbox.engine.continuous_collision.roll_back import take_back, take_back_fall
from sandbox.engine.joints.pair_filter import are_joined
from sandbox.engine.narrow_phase.one_way import comes_from_front
from sandbox.tables import Integers, Records
from sandbox.world.records import ONE_WAY, STATIC


@entry_point
def catch(
    bodies: Records,
    shapes: Records,
    settings: Records,
    counters: Records,
    census: Records,
    movers: Integers,
    parts: Integers,
    motions: Records,
    holds: Records,
    stops: Records,
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
    active = movers[1 : 1 + movers[0]]
    count = _list_fast(holds, owners, pairs, counters[0].pair_count, sorted_pairs)
    _forget_stops(owners, active, stops, sorted_pairs, count)
    for k in range(count):
        ride(bodies, shapes, motions, holds, turned, sorted_pairs[k], manifold, sweep, swept)
    bullets = ZERO
    for k in range(count):
        bullets += _hold(bodies, shapes, motions, holds, stops, turned, sorted_pairs[k], manifold, sweep, swept)
    known = census[0].laid == census[0].era  # otherwise somebody has woken in this step
    for k in range(census[0].moving if known else shapes.shape[0]):
        i = parts[k]
        if holds[owners[i].body].fast == 0:
            continue
        woke = owners[i].moves == SLEEPS  # the grid has asked for no pairs of sleepers with what does not move
        owners[i].moves = ACTIVE
        if _strays(bodies, shapes, motions, turned, boxes, i) or woke:
            for j in range(shapes.shape[0]):
                if not boxes_overlap(boxes[i], boxes[j]) or are_joined(bonds, joined, owners[i].body, owners[j].body):
                    continue
                if propose(owners, i, j, sorted_pairs, count) > count:
                    _hold(bodies, shapes, motions, holds, stops, turned, sorted_pairs[count], manifold, sweep, swept)
    changed = bullets > 0
    turn = ZERO
    while changed:
        changed = False
        for k in range(count):
            if hold_bullet(
                bodies, shapes, motions, holds, stops, turned, sorted_pairs[k], turn, manifold, sweep, swept
            ):
                changed = True
        turn += 1
    for i in active:
        stop = stops[i]
        if stop.time < 1.0:
            share = 1.0 - stop.time
            take_back(bodies[i], motions[i], share)
            if stop.bounces == 1:
                take_back_fall(bodies[i], motions[i], share, settings[0])
            if stop.struck == 1:
                strike_held(bodies[i], stop, settings[0].restitution_threshold)


@kernel
def _forget_stops(owners: Records, active: Integers, stops: Records, fast: Records, count: int) -> None:
    """Nobody is stopped yet: neither those that move, nor the sleepers that something fast may meet."""
    for i in active:
        _forget_stop(stops[i])
    for k in range(count):
        _forget_stop(stops[owners[fast[k].shape_a].body])
        _forget_stop(stops[owners[fast[k].shape_b].body])


@kernel
def _forget_stop(stop: Records) -> None:
    stop.time = 1.0
    stop.bounces = stop.struck = 0


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
    stops: Records,
    turned: Records,
    pair: Records,
    manifold: Records,
    sweep: Records,
    swept: Records,
) -> int:
    """Stop the fast body of a pair at the other one, if that is immovable; 1 if the pair is for `hold_bullet`."""
    a = shapes[pair.shape_a].body
    b = shapes[pair.shape_b].body
    if holds[a].fast + holds[b].fast == 0:
        return 0
    if bodies[a].type != STATIC and bodies[b].type != STATIC:
        return int(bodies[a].bullet + bodies[b].bullet > 0)
    mover = b if bodies[a].type == STATIC else a
    lay_way(bodies, motions, holds, a, b, 0.0, 0.0, 1.0, 1.0, sweep[0])
    if (shapes[pair.shape_a].traits | shapes[pair.shape_b].traits) & ONE_WAY:
        slop = 2.0 * allowed_depth(shapes[pair.shape_a], shapes[pair.shape_b])  # what is caught may sink on
        if not comes_from_front(bodies, shapes, turned, pair.shape_a, pair.shape_b, sweep[0].x, sweep[0].y, slop):
            return 0
    t = hit(shapes, turned, pair.shape_a, pair.shape_b, manifold, sweep, swept)
    if t >= 0.0 and t < stops[mover].time:
        stops[mover].time = t
        note_stop(stops[mover], sweep[0], shapes[pair.shape_a], shapes[pair.shape_b], mover == b, t)
    return 0
