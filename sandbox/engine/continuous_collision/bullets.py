"""What only bullets do: they stop at other moving bodies, and kinematic ones carry them along."""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.integrate import place_origin
from sandbox.engine.continuous_collision.relative_sweep import hit, lay_way
from sandbox.engine.continuous_collision.roll_back import take_back
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Records
from sandbox.world.records import DYNAMIC, KINEMATIC

_ROUNDS = 16
_SAME = 0.999
"""A hit this late on the way is the touch at which the way has been made to end."""


@kernel
def hold_bullet(
    bodies: Records,
    shapes: Records,
    motions: Records,
    holds: Records,
    stops: Records,
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
    stop_a = stops[a].time
    stop_b = stops[b].time
    both = stop_a if stop_a < stop_b else stop_b
    lay_way(bodies, motions, holds, a, b, 0.0, 0.0, both, both, sweep[0])
    t = hit(shapes, turned, pair.shape_a, pair.shape_b, manifold, sweep, swept)
    if both > 0.0 and 0.0 <= t < _SAME:
        t = t * both if turn < _ROUNDS else 0.0
        if bodies[a].bullet == 1 or turn >= _ROUNDS:
            stops[a].time = t
        if bodies[b].bullet == 1 or turn >= _ROUNDS:
            stops[b].time = t
        return True
    if stop_a == stop_b:
        return False
    lay_way(bodies, motions, holds, a, b, both, both, stop_a, stop_b, sweep[0])
    t = hit(shapes, turned, pair.shape_a, pair.shape_b, manifold, sweep, swept)
    if t < 0.0 or t >= _SAME:
        return False
    late = b if stop_a < stop_b else a
    stops[late].time = both + t * (stops[late].time - both) if turn < _ROUNDS else 0.0
    return True


@kernel
def ride(
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
    lay_way(bodies, motions, holds, a, b, 0.0, 0.0, 1.0, 1.0, sweep[0])
    t = hit(shapes, turned, pair.shape_a, pair.shape_b, manifold, sweep, swept)
    if t < 0.0:
        return
    rider = b if bodies[a].type == KINEMATIC else a
    carrier = a if rider == b else b
    rest = 1.0 - t
    body = bodies[rider]
    way = motions[rider]
    other = motions[carrier]
    take_back(body, way, rest)
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
