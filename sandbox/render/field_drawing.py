"""Regions as one sees them: a dim fill over their area, a line on water, streaks in wind, flames of thrusters."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sandbox.render.camera import Camera, Floats
from sandbox.render.contour import cut_polygon
from sandbox.render.field_frame import FieldMarks, RegionMark
from sandbox.render.line import Line
from sandbox.render.theme import Color, Theme
from sandbox.world.field_records import WATER, WIND

OPACITY = 0.13
STREAK_PIXELS = 72.0
"""Distance of the streaks in wind."""
_LEVEL = 1e-9


@dataclass(frozen=True)
class RegionFill:
    """A convex polygon (k, 2) in pixels, within the picture, in one colour (sRGB) and opacity."""

    points: Floats
    color: Color
    opacity: float


def region_fills(marks: FieldMarks, camera: Camera, theme: Theme) -> list[RegionFill]:
    """The areas of all regions that have one."""
    areas = ((region, area(region, camera)) for region in marks.regions)
    return [
        RegionFill(camera.to_screen(points), _color(region, theme), OPACITY)
        for region, points in areas
        if len(points) >= 3 and (len(region.edges) or region.disc[2] > 0.0)
    ]


def field_strokes(marks: FieldMarks, camera: Camera, theme: Theme) -> list[Line]:
    """The lines on water, the streaks in wind and the flames."""
    lines = [line for region in marks.regions for line in _of_region(region, camera, theme)]
    for x, y, jet_x, jet_y in marks.flames:
        start = camera.to_screen(np.array([[x, y]]))[0]
        length = float(np.clip(0.6 * camera.scale, 6.0, 60.0))
        end = start + length * np.array([jet_x, -jet_y])
        lines.append(Line(tuple(start), tuple(end), 0.35 * length, theme.flame, 0.45))
        lines.append(Line(tuple(start), tuple(start + 0.6 * (end - start)), 0.16 * length, theme.spark, 0.8))
    return lines


def area(region: RegionMark, camera: Camera) -> Floats:
    """The part of a region's area that is in the picture (k, 2), metres, counter-clockwise; maybe no rows."""
    low, high = _view(camera)
    points = np.array([low, (high[0], low[1]), high, (low[0], high[1])])
    if region.disc[2] > 0.0:
        turn = np.linspace(0.0, 2.0 * np.pi, 96, endpoint=False)
        points = region.disc[:2] + region.disc[2] * np.column_stack([np.cos(turn), np.sin(turn)])
        for axis in (0, 1):
            points = cut_polygon(points, points[:, axis] - low[axis])
            points = cut_polygon(points, high[axis] - points[:, axis])
    for nx, ny, offset in region.edges:
        points = cut_polygon(points, offset - (nx * points[:, 0] + ny * points[:, 1]))
    return points


def _view(camera: Camera) -> tuple[Floats, Floats]:
    """Corners of the picture and a little more, in metres."""
    half = (np.asarray(camera.size) / 2.0 + 8.0) / camera.scale
    return np.asarray(camera.center) - half, np.asarray(camera.center) + half


def _color(region: RegionMark, theme: Theme) -> Color:
    return {WATER: theme.water, WIND: theme.wind}.get(region.kind, theme.gravity)


def _of_region(region: RegionMark, camera: Camera, theme: Theme) -> Iterator[Line]:
    points = area(region, camera)
    if region.kind == WATER:
        for level in region.edges[region.edges[:, 1] == 1.0, 2]:
            on = points[np.abs(points[:, 1] - level) <= _LEVEL * (1.0 + abs(level))]
            if len(on) >= 2:
                ends = camera.to_screen(on)
                left, right = ends[np.argmin(ends[:, 0])], ends[np.argmax(ends[:, 0])]
                yield Line(tuple(left), tuple(right), 2.0, theme.water, 0.8)
    elif region.kind == WIND and region.flow.any() and len(points) >= 3:
        yield from _streaks(region, points, camera, theme)


def _streaks(region: RegionMark, points: Floats, camera: Camera, theme: Theme) -> Iterator[Line]:
    """Short strokes with the wind, on a lattice that stays where it is in the world."""
    pitch = STREAK_PIXELS / camera.scale
    low, high = points.min(axis=0), points.max(axis=0)
    way = region.flow / np.hypot(*region.flow)
    columns = np.arange(np.ceil(low[0] / pitch), np.floor(high[0] / pitch) + 1)
    for row in np.arange(np.ceil(low[1] / pitch), np.floor(high[1] / pitch) + 1):
        for column in columns:
            start = np.array([column + 0.5 * (row % 2), row]) * pitch
            ends = np.array([start, start + 0.35 * pitch * way])
            if _inside(region, ends).all():
                a, b = camera.to_screen(ends)
                yield Line(tuple(a), tuple(b), 1.5, theme.wind, 0.45)


def _inside(region: RegionMark, points: Floats) -> Floats:
    inside = np.ones(len(points), bool)
    for nx, ny, offset in region.edges:
        inside &= nx * points[:, 0] + ny * points[:, 1] <= offset
    if region.disc[2] > 0.0:
        inside &= np.hypot(*(points - region.disc[:2]).T) <= region.disc[2]
    return inside
