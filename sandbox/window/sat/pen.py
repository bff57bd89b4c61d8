"""A pen for what is drawn over the scene: takes points in metres, widths in pixels."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Literal

from imgui_bundle import imgui

from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.shapes import Shape
from sandbox.render.shape_outline import outline_of
from sandbox.render.theme import Color
from sandbox.window.gui_style import palette_of
from sandbox.window.overlay import Overlay, packed_color
from sandbox.window.sat.measure import scaled
from sandbox.window.workspace import Workspace

Anchor = Literal["left", "middle", "right"]
Box = tuple[float, float, float, float]
"""Left, top, right, bottom in pixels of the window."""
SMALL = 14.0
"""Size of labels in pixels."""
MOST_DASHES = 400


class Pen:
    """Draws into an overlay what a workspace's camera sees."""

    def __init__(self, workspace: Workspace, overlay: Overlay) -> None:
        camera, rect = workspace.viewport.camera, workspace.viewport.rect
        self.overlay, self.scale = overlay, camera.scale
        self.theme, self.palette = workspace.theme, palette_of(workspace.theme)
        self.rect = rect
        self._middle = rect[0] + camera.size[0] / 2, rect[1] + camera.size[1] / 2
        self._center = camera.center
        self._list: Any = overlay.pen
        self.taken: list[Box] = []
        """Where arrows and words are."""

    def pixel(self, point: Vec) -> Vec:
        """The pixel of the window over a point."""
        (mx, my), (cx, cy) = self._middle, self._center
        return mx + (point[0] - cx) * self.scale, my - (point[1] - cy) * self.scale

    def fill(self, points: Sequence[Vec], color: Color, opacity: float) -> None:
        """A convex polygon."""
        # Filled with smooth edges it has to go round as ImGui does: clockwise on a screen whose y points down.
        corners = [imgui.ImVec2(*self.pixel(point)) for point in points]
        self._list.add_convex_poly_filled(corners, packed_color(color, opacity))

    def outline(self, points: Sequence[Vec], color: Color, width: float, opacity: float = 1.0) -> None:
        """A closed line."""
        corners = [imgui.ImVec2(*self.pixel(point)) for point in points]
        self._list.add_polyline(corners, packed_color(color, opacity), width, imgui.ImDrawFlags_.closed)

    def shape(self, shape: Shape, color: Color, fill: float) -> None:
        """A shape filled with a colour; a line has nothing to fill."""
        points = outline_of(shape)
        if len(points) > 2:
            self.fill(points, color, fill)

    def rim(self, shape: Shape, color: Color, width: float = 2.0) -> None:
        """The outline of a shape."""
        points = outline_of(shape)
        if len(points) > 2:
            self.outline(points, color, width)
        else:
            self.line(points[0], points[1], color, width + 1.0)

    def ghost(self, shape: Shape, shift: Vec, color: Color) -> None:
        """The dashed outline of a shape moved by `shift` metres."""
        points = [(x + shift[0], y + shift[1]) for x, y in outline_of(shape)]
        for start, end in zip(points, [*points[1:], points[0]], strict=True):
            self.line(
                start, end, color, 1.8, 0.95, dash=(6.0, 5.0) if math.dist(start, end) * self.scale > 14 else None
            )

    def line(
        self,
        start: Vec,
        end: Vec,
        color: Color,
        width: float,
        opacity: float = 1.0,
        dash: tuple[float, float] | None = None,
    ) -> None:
        """A straight line; `dash` are the lengths of dashes and of the gaps between them, in pixels."""
        paint, p, q = packed_color(color, opacity), self.pixel(start), self.pixel(end)
        if dash is None:
            self._list.add_line(imgui.ImVec2(*p), imgui.ImVec2(*q), paint, width)
            return
        clipped = self._seen(p, q)
        if clipped is None:
            return
        (px, py), (qx, qy) = clipped
        long = math.hypot(qx - px, qy - py)
        step = max(sum(dash), long / MOST_DASHES)
        if long < 1e-6:
            return
        ux, uy = (qx - px) / long, (qy - py) / long
        at = 0.0
        while at < long:
            to = min(at + dash[0], long)
            self._list.add_line(
                imgui.ImVec2(px + ux * at, py + uy * at), imgui.ImVec2(px + ux * to, py + uy * to), paint, width
            )
            at += step

    def arrow(self, start: Vec, end: Vec, color: Color, width: float = 2.0, head: float = 11.0) -> None:
        """A line with a head at its end; short ones are all head."""
        (px, py), (qx, qy) = self.pixel(start), self.pixel(end)
        long = math.hypot(qx - px, qy - py)
        if long < 0.5:
            return
        self.taken.append((min(px, qx) - 4, min(py, qy) - 4, max(px, qx) + 4, max(py, qy) + 4))
        ux, uy = (qx - px) / long, (qy - py) / long
        head = min(head, long)
        bx, by = qx - ux * head, qy - uy * head
        paint, half = packed_color(color, 1.0), 0.42 * head
        if long > head:
            self._list.add_line(imgui.ImVec2(px, py), imgui.ImVec2(bx + ux, by + uy), paint, width)
        self._list.add_triangle_filled(
            imgui.ImVec2(qx, qy), imgui.ImVec2(bx - uy * half, by + ux * half),
            imgui.ImVec2(bx + uy * half, by - ux * half), paint,
        )  # fmt: skip

    def dot(self, point: Vec, radius: float, color: Color, hollow: bool = False) -> None:
        """A mark of `radius` pixels, with a thin rim in the colour of the background."""
        at = imgui.ImVec2(*self.pixel(point))
        if hollow:
            self._list.add_circle_filled(at, radius, packed_color(self.theme.background, 0.9), 24)
            self._list.add_circle(at, radius, packed_color(color, 1.0), 24, 2.0)
            return
        self._list.add_circle_filled(at, radius + 1.3, packed_color(self.theme.background, 0.85), 24)
        self._list.add_circle_filled(at, radius, packed_color(color, 1.0), 24)

    def label(
        self, pixel: Vec, text: str, color: Color, anchor: Anchor = "middle", bold: bool = False, size: float = SMALL
    ) -> None:
        """A word at a pixel, on a plate so that it can be read over anything."""
        box = self._plate(pixel, text, anchor, bold, size)
        self.taken.append(box)
        self.overlay.panel(box, self.theme.background, 0.78, 4.0)
        self.overlay.text(box[0] + 4, box[1] + 1, text, color, 1.0, scaled(size), bold)

    def sees(self, pixel: Vec) -> bool:
        """Whether a pixel of the window lies in the viewport."""
        left, top, width, height = self.rect
        return left <= pixel[0] <= left + width and top <= pixel[1] <= top + height

    def is_free(self, pixel: Vec, text: str, anchor: Anchor) -> bool:
        """Whether a bold label would lie on no arrow and no other label."""
        left, top, right, bottom = self._plate(pixel, text, anchor, True, SMALL)
        return all(left >= x1 or right <= x0 or top >= y1 or bottom <= y0 for x0, y0, x1, y1 in self.taken)

    def _plate(self, pixel: Vec, text: str, anchor: Anchor, bold: bool, size: float) -> Box:
        """What lies under a label."""
        high = scaled(size)
        wide = self.overlay.width(text, high, bold)
        left = pixel[0] - {"left": 0.0, "middle": wide / 2, "right": wide}[anchor]
        top = pixel[1] - high / 2
        return left - 4, top - 1, left + wide + 4, top + high + 2

    def fits(self, pixel: Vec, text: str, anchor: Anchor) -> bool:
        """Whether a bold label would lie in the viewport."""
        wide, (left, top, width, height) = self.overlay.width(text, scaled(SMALL), True), self.rect
        start = pixel[0] - {"left": 0.0, "middle": wide / 2, "right": wide}[anchor]
        return left <= start and start + wide <= left + width and top + 8 <= pixel[1] <= top + height - 8

    def away(self, point: Vec, direction: Vec, pixels: float) -> Vec:
        """The pixel so far from a point, in a direction of the plane of length 1."""
        x, y = self.pixel(point)
        return x + direction[0] * pixels, y - direction[1] * pixels

    def _seen(self, p: Vec, q: Vec) -> tuple[Vec, Vec] | None:
        """The part of a line of pixels that lies in the viewport."""
        low, high = 0.0, 1.0
        left, top, width, height = self.rect
        for at, to, least, most in ((p[0], q[0], left, left + width), (p[1], q[1], top, top + height)):
            if at == to:
                if not least <= at <= most:
                    return None
                continue
            first, last = sorted(((least - at) / (to - at), (most - at) / (to - at)))
            low, high = max(low, first), min(high, last)
        if low >= high:
            return None
        dx, dy = q[0] - p[0], q[1] - p[1]
        return (p[0] + low * dx, p[1] + low * dy), (p[0] + high * dx, p[1] + high * dy)
