"""Joints as strokes over the bodies: pins, rods, rails, springs, ropes and pulleys."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np

from sandbox.render.camera import Camera, Floats
from sandbox.render.joint_frame import JointMarks
from sandbox.render.line import Line
from sandbox.render.theme import Theme
from sandbox.world import joint_records as kinds

PIN_METRES = 0.09
"""Radius of a pin; on screen it is kept between `PIN_PIXELS`."""
PIN_PIXELS = 1.2, 4.5
COILS = 7
_CIRCLE = 20


class _StrokeList:
    """Collects strokes in pixels: every mark is a light stroke on a dark one, so that it shows on any colour."""

    def __init__(self, camera: Camera, theme: Theme) -> None:
        self.camera, self.theme = camera, theme
        self.size = float(np.clip(PIN_METRES * camera.scale, *PIN_PIXELS))
        self.dark: list[Line] = []
        self.light: list[Line] = []

    def path(self, points: Floats, width: float, closed: bool = False) -> None:
        """A polyline through points of the screen (n, 2)."""
        pairs = list(zip(points[:-1].tolist(), points[1:].tolist(), strict=True))
        if closed:
            pairs.append((points[-1].tolist(), points[0].tolist()))
        for start, end in pairs:
            self.dark.append(Line((start[0], start[1]), (end[0], end[1]), width + 1.6, self.theme.ink))
            self.light.append(Line((start[0], start[1]), (end[0], end[1]), width, self.theme.joint))

    def dot(self, at: Floats, radius: float) -> None:
        """A disc."""
        self.path(np.vstack([at, at]), 2.0 * radius)

    def ring(self, at: Floats, radius: float, width: float) -> None:
        """A circle."""
        turn = np.linspace(0.0, 2.0 * math.pi, _CIRCLE, endpoint=False)
        self.path(at + radius * np.column_stack([np.cos(turn), np.sin(turn)]), width, closed=True)


def joint_strokes(marks: JointMarks, camera: Camera, theme: Theme) -> list[Line]:
    """The strokes of all joints in sight, dark ones first."""
    strokes = _StrokeList(camera, theme)
    if len(marks) == 0:
        return []
    a, b = camera.to_screen(marks.a), camera.to_screen(marks.b)
    for k in _in_sight(a, b, camera):
        _DRAW[int(marks.kind[k])](strokes, marks, k, a, b)
    return strokes.dark + strokes.light


def _in_sight(a: Floats, b: Floats, camera: Camera) -> Iterator[int]:
    margin = 200.0
    low, high = np.minimum(a, b) - margin, np.maximum(a, b) + margin
    seen = (high >= 0.0).all(axis=1) & (low <= np.asarray(camera.size)).all(axis=1)
    yield from np.flatnonzero(seen).tolist()


def _pin(strokes: _StrokeList, marks: JointMarks, k: int, a: Floats, b: Floats) -> None:
    strokes.dot(b[k], strokes.size)


def _weld(strokes: _StrokeList, marks: JointMarks, k: int, a: Floats, b: Floats) -> None:
    for dx, dy in ((1.0, 1.0), (1.0, -1.0)):
        arm = np.array([dx, dy]) * strokes.size
        strokes.path(np.array([b[k] - arm, b[k] + arm]), 0.55 * strokes.size)


def _distance(strokes: _StrokeList, marks: JointMarks, k: int, a: Floats, b: Floats) -> None:
    if marks.sprung[k]:
        strokes.path(zigzag(a[k], b[k], 1.6 * strokes.size), 0.45 * strokes.size)
    elif np.isfinite(marks.reach[k, 1]):
        length = float(marks.reach[k, 1]) * strokes.camera.scale
        strokes.path(sagging(a[k], b[k], length), 0.5 * strokes.size)
    else:
        strokes.path(np.array([a[k], b[k]]), 0.75 * strokes.size)
    strokes.dot(a[k], 0.7 * strokes.size)
    strokes.dot(b[k], 0.7 * strokes.size)


def _prismatic(strokes: _StrokeList, marks: JointMarks, k: int, a: Floats, b: Floats) -> None:
    axis = marks.axis[k] * (1.0, -1.0) * strokes.camera.scale
    slide = float((b[k] - a[k]) @ axis) / strokes.camera.scale**2
    low, high = marks.reach[k]
    low, high = low if np.isfinite(low) else min(slide, 0.0) - 0.5, high if np.isfinite(high) else max(slide, 0.0) + 0.5
    strokes.path(np.array([a[k] + low * axis, a[k] + high * axis]), 0.5 * strokes.size)
    side = np.array([-axis[1], axis[0]]) / np.hypot(*axis) * 1.3 * strokes.size
    for end in (a[k] + low * axis, a[k] + high * axis):
        strokes.path(np.array([end - side, end + side]), 0.5 * strokes.size)
    if marks.sprung[k]:
        strokes.path(zigzag(a[k] + low * axis, b[k], 1.4 * strokes.size), 0.4 * strokes.size)
    strokes.dot(b[k], strokes.size)


def _wheel(strokes: _StrokeList, marks: JointMarks, k: int, a: Floats, b: Floats) -> None:
    up = marks.axis[k] * (1.0, -1.0) * 6.0 * strokes.size
    if marks.sprung[k]:
        strokes.path(zigzag(a[k] + up, b[k], 1.3 * strokes.size, coils=4), 0.4 * strokes.size)
    strokes.dot(b[k], 1.1 * strokes.size)


def _pulley(strokes: _StrokeList, marks: JointMarks, k: int, a: Floats, b: Floats) -> None:
    wheels = strokes.camera.to_screen(marks.points[k])
    radius = 2.6 * strokes.size
    # The rope runs over the outer sides of the two wheels and over their tops.
    side = 1.0 if wheels[0][0] <= wheels[1][0] else -1.0
    left, right = wheels[0] - (side * radius, 0.0), wheels[1] + (side * radius, 0.0)
    strokes.path(np.array([a[k], left]), 0.45 * strokes.size)
    strokes.path(np.array([right, b[k]]), 0.45 * strokes.size)
    top = np.array([0.0, -radius])
    strokes.path(np.array([wheels[0] + top, wheels[1] + top]), 0.45 * strokes.size)
    for wheel in wheels:
        strokes.ring(wheel, radius, 0.5 * strokes.size)
        strokes.dot(wheel, 0.5 * strokes.size)
    strokes.dot(a[k], 0.7 * strokes.size)
    strokes.dot(b[k], 0.7 * strokes.size)


def _gear(strokes: _StrokeList, marks: JointMarks, k: int, a: Floats, b: Floats) -> None:
    """A dashed line from the one joint to the other."""
    first, second = marks.parents[k]
    if first < 0 or second < 0:
        return
    for start in np.arange(0.06, 0.94, 0.1):
        ends = b[first] + (b[second] - b[first]) * np.array([[start], [start + 0.05]])
        strokes.path(ends, 0.3 * strokes.size)


def _to_point(strokes: _StrokeList, marks: JointMarks, k: int, a: Floats, b: Floats) -> None:
    """A motor or target: a thin line to where it drives, which is marked by a ring."""
    goal = strokes.camera.to_screen(marks.points[k, :1])[0]
    strokes.path(np.array([goal, b[k]]), 0.3 * strokes.size)
    strokes.ring(goal, 1.3 * strokes.size, 0.4 * strokes.size)
    strokes.dot(b[k], 0.6 * strokes.size)


def _friction(strokes: _StrokeList, marks: JointMarks, k: int, a: Floats, b: Floats) -> None:
    strokes.ring(b[k], 0.9 * strokes.size, 0.35 * strokes.size)


def zigzag(start: Floats, end: Floats, side: float, coils: int = COILS) -> Floats:
    """A spring as a polyline from start to end (n, 2), `side` pixels wide to each side."""
    along = np.concatenate([[0.0, 0.12], 0.12 + 0.76 * (np.arange(2 * coils) + 0.5) / (2 * coils), [0.88, 1.0]])
    across = np.concatenate([[0.0, 0.0], np.where(np.arange(2 * coils) % 2 == 0, side, -side), [0.0, 0.0]])
    way = end - start
    length = max(float(np.hypot(*way)), 1e-9)
    normal = np.array([-way[1], way[0]]) / length
    line: Floats = start + along[:, None] * way + across[:, None] * normal
    return line


def sagging(start: Floats, end: Floats, length: float) -> Floats:
    """A rope of a length between two points of the screen: straight when taut, else a parabola that hangs down."""
    way = end - start
    distance = float(np.hypot(*way))
    if length <= 1.001 * distance:
        return np.array([start, end])
    t = np.linspace(0.0, 1.0, 15)
    # Chord s and sag d make an arc of about s + 8 d^2 / (3 s) where it is flat, of 2 d where it hangs.
    sag = min(math.sqrt(0.375 * max(distance, 0.25 * length) * (length - distance)), 0.5 * length)
    line: Floats = start + t[:, None] * way
    line[:, 1] += 4.0 * sag * t * (1.0 - t)
    return line


_Draw = Callable[[_StrokeList, JointMarks, int, Floats, Floats], None]
_DRAW: dict[int, _Draw] = {
    kinds.DISTANCE: _distance,
    kinds.REVOLUTE: _pin,
    kinds.PRISMATIC: _prismatic,
    kinds.WELD: _weld,
    kinds.WHEEL: _wheel,
    kinds.GEAR: _gear,
    kinds.PULLEY: _pulley,
    kinds.MOTOR: _to_point,
    kinds.TARGET: _to_point,
    kinds.FRICTION: _friction,
}
"""How each kind is drawn."""
