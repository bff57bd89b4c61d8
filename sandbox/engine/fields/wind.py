"""Wind: pressure on every bit of boundary that meets the air, exact over straight edges and arcs.

Newton's impact law (Principia, book II, propositions 34 and 35): where a surface meets the air with the speed u along
its outward normal n, air of density rho presses with C rho u^2 / 2 against n; what is turned away feels nothing. A
plate that meets it squarely has the drag C, a disc 2/3 of that for its width. Along an edge the pressure times its
lever is a polynomial of third degree, which Gauss's rule with two points integrates without error; along an arc the
spin about its centre adds nothing to u, and the integrals are closed forms. There is no friction along the surface, no
lee, and bodies do not shelter each other.
"""

from __future__ import annotations

import math

from sandbox._jit import kernel
from sandbox.engine.fields.area import boundary_within
from sandbox.engine.fields.records import Fields
from sandbox.tables import Records

_GAUSS = 0.21132486540518713
"""Where Gauss's two points lie on (0, 1), from either end: (1 - 1 / sqrt(3)) / 2."""


@kernel
def blow(region: Records, fields: Fields, bodies: Records, shape: Records, vertices: Records) -> None:
    """Add the drag of a region of air on a shape, at the velocity that its body has now."""
    found, count = boundary_within(region, fields, bodies, shape, vertices)
    _press(region, bodies[shape.body], fields.pushes[shape.body], found, count)


@kernel
def _press(region: Records, body: Records, push: Records, pieces: Records, count: int) -> None:
    for k in range(count):
        if pieces[k].own == 0:
            continue
        if pieces[k].radius > 0.0:
            _press_arc(region, body, push, pieces[k])
        else:
            _press_edge(region, body, push, pieces[k])


@kernel
def _press_edge(region: Records, body: Records, push: Records, p: Records) -> None:
    dx = p.end_x - p.start_x
    dy = p.end_y - p.start_y
    length = math.sqrt(dx * dx + dy * dy)
    if length == 0.0:
        return
    nx = dy / length
    ny = -dx / length
    ahead = (body.velocity_x - region.flow_x) * nx + (body.velocity_y - region.flow_y) * ny
    a = ahead + body.angular_velocity * (p.start_x * ny - p.start_y * nx)
    b = ahead + body.angular_velocity * (p.end_x * ny - p.end_y * nx)
    if a <= 0.0 and b <= 0.0:
        return
    first = a / (a - b) if a < 0.0 else 0.0
    last = a / (a - b) if b < 0.0 else 1.0
    weight = 0.25 * region.density * region.drag * length * (last - first)
    carried = region.flow_x * nx + region.flow_y * ny
    for k in range(2):
        t = first + (last - first) * (_GAUSS if k == 0 else 1.0 - _GAUSS)
        lever = (p.start_x + t * dx) * ny - (p.start_y + t * dy) * nx
        rate = weight * (a + t * (b - a))
        push.drag_xx += rate * nx * nx
        push.drag_xy += rate * nx * ny
        push.drag_yy += rate * ny * ny
        push.drag_xw += rate * nx * lever
        push.drag_yw += rate * ny * lever
        push.drag_ww += rate * lever * lever
        push.carry_x += rate * nx * carried
        push.carry_y += rate * ny * carried
        push.carry_w += rate * lever * carried


@kernel
def _press_arc(region: Records, body: Records, push: Records, p: Records) -> None:
    ux = body.velocity_x - region.flow_x - body.angular_velocity * p.center_y
    uy = body.velocity_y - region.flow_y + body.angular_velocity * p.center_x
    speed = math.sqrt(ux * ux + uy * uy)
    if speed == 0.0:
        return
    mx = ux / speed
    my = uy / speed
    c1 = (mx * (p.start_x - p.center_x) + my * (p.start_y - p.center_y)) / p.radius
    s1 = (mx * (p.start_y - p.center_y) - my * (p.start_x - p.center_x)) / p.radius
    c2 = (mx * (p.end_x - p.center_x) + my * (p.end_y - p.center_y)) / p.radius
    s2 = (mx * (p.end_y - p.center_y) - my * (p.end_x - p.center_x)) / p.radius
    if c1 <= 0.0 and c2 <= 0.0:
        return
    if c1 < 0.0:
        c1 = 0.0
        s1 = -1.0
    if c2 < 0.0:
        c2 = 0.0
        s2 = 1.0
    rate = 0.5 * region.density * region.drag * p.radius * speed
    along = rate * ((s2 - s2 * s2 * s2 / 3.0) - (s1 - s1 * s1 * s1 / 3.0))
    mixed = rate * (c1 * c1 * c1 - c2 * c2 * c2) / 3.0
    across = rate * (s2 * s2 * s2 - s1 * s1 * s1) / 3.0
    xx = along * mx * mx - 2.0 * mixed * mx * my + across * my * my
    xy = (along - across) * mx * my + mixed * (mx * mx - my * my)
    yy = along * my * my + 2.0 * mixed * mx * my + across * mx * mx
    xw = xy * p.center_x - xx * p.center_y
    yw = yy * p.center_x - xy * p.center_y
    push.drag_xx += xx
    push.drag_xy += xy
    push.drag_yy += yy
    push.drag_xw += xw
    push.drag_yw += yw
    push.drag_ww += yw * p.center_x - xw * p.center_y
    push.carry_x += xx * region.flow_x + xy * region.flow_y
    push.carry_y += xy * region.flow_x + yy * region.flow_y
    push.carry_w += xw * region.flow_x + yw * region.flow_y
