"""Kinematic bodies on paths: before a step they get the velocity that leads to where they are due; there they arrive.

Places are worked out of the number of steps gone, with + - * / alone, so that nothing adds up over time.
"""

from __future__ import annotations

import math

from sandbox._jit import entry_point, kernel
from sandbox.geometry.trig import cos_sin
from sandbox.tables import Field, Records, Table

WAY = Table(
    "way",
    (
        Field("first", "-", "its first place", "i8"),
        Field("count", "-", "its places; 0 if there is no path", "i8"),
        Field("loops", "-", "1: it begins anew after the last", "i8"),
        Field("smooth", "-", "1: between two places bodies begin and end at rest", "i8"),
        Field("goes_on", "-", "1 in steps in which it does", "i8"),
        Field("switched", "-", "1 if its body begins to move in this step, or stops", "i8"),
        Field("x", "m", "where its body is when the step ends"),
        Field("y", "m", ""),
        Field("angle", "rad", ""),
    ),
)
"""One row a path, beside that of the state."""

STOP = Table(
    "stop",
    (
        Field("time", "s", "when it is there"),
        Field("x", "m", "from the origin of the path"),
        Field("y", "m", ""),
        Field("angle", "rad", ""),
    ),
)
"""The places of all paths, one path after the other."""


@entry_point
def lead(bodies: Records, paths: Records, ways: Records, stops: Records, seconds: float) -> int:
    """Give every driven body the velocity with which it arrives on time, at the end of a step of so many `seconds`.

    Returns how many begin to move, or stop.
    """
    count = 0
    for row in range(ways.shape[0]):
        way = ways[row]
        way.goes_on = 0
        way.switched = 0
        if way.count > 0:
            body = bodies[paths[row].body]
            moved = body.velocity_x != 0.0 or body.velocity_y != 0.0 or body.angular_velocity != 0.0
            _lead(body, paths[row], way, stops, seconds)
            moves = body.velocity_x != 0.0 or body.velocity_y != 0.0 or body.angular_velocity != 0.0
            if moves != moved:
                way.switched = 1
                count += 1
    return count


@entry_point
def arrive(bodies: Records, paths: Records, ways: Records) -> None:
    """Write the poses that were led to: exactly, whatever substeps rounded."""
    for row in range(ways.shape[0]):
        way = ways[row]
        if way.goes_on == 1:
            body = bodies[paths[row].body]
            if body.frozen_step < 0:
                paths[row].steps += 1
                cosine, sine = cos_sin(way.angle)
                body.position_x = way.x
                body.position_y = way.y
                body.angle = way.angle
                body.rotation_cos = cosine
                body.rotation_sin = sine
                body.center_x = way.x + (cosine * body.local_center_x - sine * body.local_center_y)
                body.center_y = way.y + (sine * body.local_center_x + cosine * body.local_center_y)


@kernel
def _lead(body: Records, path: Records, way: Records, stops: Records, seconds: float) -> None:
    """Give one body its velocity, and note where it will be; none if its path is at its end or waits, or bad numbers
    froze it."""
    whole = stops[way.first + way.count - 1].time
    if path.enabled == 0 or body.frozen_step >= 0 or (way.loops == 0 and path.steps * seconds >= whole):
        body.velocity_x = 0.0
        body.velocity_y = 0.0
        body.angular_velocity = 0.0
        return
    x, y, angle = place_after(way, stops, (path.steps + 1) * seconds)
    way.goes_on = 1
    way.x = path.origin_x + x
    way.y = path.origin_y + y
    due: float = path.origin_angle + angle
    way.angle = due
    cosine, sine = cos_sin(due)
    center_x = way.x + (cosine * body.local_center_x - sine * body.local_center_y)
    center_y = way.y + (sine * body.local_center_x + cosine * body.local_center_y)
    body.velocity_x = (center_x - body.center_x) / seconds
    body.velocity_y = (center_y - body.center_y) / seconds
    body.angular_velocity = (due - body.angle) / seconds


@kernel
def place_after(way: Records, stops: Records, seconds: float) -> tuple[float, float, float]:
    """Where a path is after so many seconds: x and y (m) and angle (rad) from its origin."""
    last = way.first + way.count - 1
    whole = stops[last].time
    if way.loops == 1:
        seconds = seconds - whole * math.floor(seconds / whole)
    if seconds >= whole:
        return stops[last].x, stops[last].y, stops[last].angle
    leg = way.first  # the place that comes next
    end = last
    while leg < end:
        middle = (leg + end) // 2
        if stops[middle].time > seconds:
            end = middle
        else:
            leg = middle + 1
    to = stops[leg]
    if leg == way.first:
        return to.x, to.y, to.angle
    begin = stops[leg - 1]
    share = (seconds - begin.time) / (to.time - begin.time)
    if way.smooth == 1:
        share = share * share * (3.0 - 2.0 * share)
    x = begin.x + share * (to.x - begin.x)
    y = begin.y + share * (to.y - begin.y)
    return x, y, begin.angle + share * (to.angle - begin.angle)
