"""The plane of a separating-axis picture: the sheet, shapes with their corners and edges, arrows, words beside them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from sandbox.geometry.mass import edge_normals
from sandbox.geometry.sat_rows import Vec, author_edges
from sandbox.geometry.shapes import Core, Shape
from sandbox.render.camera import Camera, fit
from sandbox.render.svg import Pixel, Svg, number


class Plane:
    """A window of an SVG picture onto the plane: `at` is its upper left pixel; draws what is given in metres."""

    def __init__(self, svg: Svg, at: Pixel, size: tuple[int, int], points: Iterable[Vec], margin: float = 46.0) -> None:
        self.svg, self.at, self.size = svg, at, size
        xs, ys = zip(*points, strict=True)
        inner = round(size[0] - 2 * margin), round(size[1] - 2 * margin)
        self.scale = fit((min(xs), min(ys), max(xs), max(ys)), inner, margin=0.0).scale
        self._camera = Camera(((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2), self.scale, size)

    def pixel(self, point: Vec) -> Pixel:
        """Where a point of the plane is in the picture."""
        x, y = self._camera.to_screen(point)
        return self.at[0] + float(x), self.at[1] + float(y)

    def shows(self, point: Vec) -> bool:
        """Whether a point of the plane is inside the window."""
        low_x, low_y, high_x, high_y = self._camera.bounds
        return low_x <= point[0] <= high_x and low_y <= point[1] <= high_y

    def __enter__(self) -> Plane:
        """Begin to draw on the sheet: whatever reaches beyond its edges is cut off."""
        self.sheet()
        self.svg.window(*self.at, *self.size)
        return self

    def __exit__(self, *_exception: object) -> None:
        self.svg.close_window()

    def sheet(self) -> None:
        """The ruled paper: a line every metre, or every 1, 2 or 5 tens of metres that gives lines enough."""
        (x, y), (width, height) = self.at, self.size
        self.svg.rectangle(x, y, width, height, "lit", 10.0)
        low_x, low_y, high_x, high_y = self._camera.bounds
        spacing = _spacing(46.0 / self.scale)
        for k in range(math.ceil(low_x / spacing), math.floor(high_x / spacing) + 1):
            left = self.pixel((k * spacing, 0.0))[0]
            self.svg.line((left, y), (left, y + height), "grid")
        for k in range(math.ceil(low_y / spacing), math.floor(high_y / spacing) + 1):
            top = self.pixel((0.0, k * spacing))[1]
            self.svg.line((x, top), (x + width, top), "grid")

    def shape(self, shape: Core, kind: str, shift: Vec = (0.0, 0.0)) -> None:
        """A shape filled in the colour `kind`, moved by `shift` metres."""
        core = [(x + shift[0], y + shift[1]) for x, y in shape.vertices]
        if len(core) == 1:
            self.svg.circle(self.pixel(core[0]), shape.radius * self.scale, kind)
        else:
            self.svg.path(self._outline(core, shape.radius), kind)

    def corners(self, shape: Shape, kind: str) -> None:
        """The core's corners as dots with the author's numbers outside of them."""
        middle = _middle(shape.vertices)
        for vertex in shape.vertices:
            self.svg.circle(self.pixel(vertex), 3.2, f"{kind} dot")
            if len(shape.vertices) == 1:
                continue  # the centre of a disc
            label = str(shape.given.index(vertex) + 1)
            x, y = self._away(vertex, middle, 13.0 + shape.radius * self.scale)
            self.svg.text((x, y + 4.5), label, f"{kind} small strong number", "middle")

    def edges(self, shape: Shape, kind: str) -> None:
        """The edges as arrows in the author's direction, with their numbers."""
        middle = _middle(shape.vertices)
        for number_, start, end in author_edges(shape):
            self.svg.arrow(self.pixel(start), self.pixel(end), f"{kind} edge", 12.0)
            x, y = self._away(_between(start, end), middle, 16.0)
            self.svg.text((x, y + 5.0), f"E{number_}", f"{kind} strong", "middle")

    def perpendiculars(self, shape: Shape, kind: str, length: float = 44.0) -> None:
        """The axis (-y, x) of every edge as an arrow of `length` pixels from the edge's middle."""
        for number_, start, end in author_edges(shape):
            (x0, y0), (x1, y1) = self.pixel(start), self.pixel(end)
            long = math.hypot(x1 - x0, y1 - y0)
            # Turned a quarter to the left in the plane, hence on a screen whose y points down.
            ux, uy = (y1 - y0) / long, -(x1 - x0) / long
            x, y = (x0 + x1) / 2, (y0 + y1) / 2
            self.svg.arrow((x, y), (x + ux * length, y + uy * length), f"{kind} axis")
            self.svg.text(
                (x + ux * (length + 12), y + uy * (length + 12) + 5.0), str(number_), f"{kind} strong", "middle"
            )

    def line(self, start: Vec, end: Vec, kind: str) -> None:
        """A straight line between two points of the plane."""
        self.svg.line(self.pixel(start), self.pixel(end), kind)

    def dot(self, point: Vec, kind: str, radius: float = 4.5) -> None:
        """A mark of `radius` pixels."""
        self.svg.circle(self.pixel(point), radius, kind)

    def arrow(self, start: Vec, end: Vec, kind: str, head: float = 13.0) -> None:
        """An arrow between two points of the plane."""
        self.svg.arrow(self.pixel(start), self.pixel(end), kind, head)

    def through(self, point: Vec, direction: Vec, kind: str) -> None:
        """A straight line across the whole window."""
        length = math.hypot(*direction)
        ux, uy = direction[0] / length, -direction[1] / length
        x, y = self.pixel(point)
        ends = _clipped((x, y), (ux, uy), (*self.at, self.at[0] + self.size[0], self.at[1] + self.size[1]))
        if ends is not None:
            self.svg.line(*ends, kind)

    def _outline(self, core: Sequence[Vec], radius: float) -> str:
        """A rounded core as a path: every edge moved out by the radius, joined by arcs about the corners."""
        steps: list[str] = []
        normals = edge_normals(core)
        for i, (start, (nx, ny)) in enumerate(zip(core, normals, strict=True)):
            end = core[(i + 1) % len(core)]
            p = self.pixel((start[0] + nx * radius, start[1] + ny * radius))
            q = self.pixel((end[0] + nx * radius, end[1] + ny * radius))
            arc = number(radius * self.scale)
            steps.append(f"A{arc} {arc} 0 0 0 {_pair(p)}" if steps and radius else f"{'L' if steps else 'M'}{_pair(p)}")
            steps.append(f"L{_pair(q)}")
        if radius:
            first = self.pixel((core[0][0] + normals[0][0] * radius, core[0][1] + normals[0][1] * radius))
            steps.append(f"A{arc} {arc} 0 0 0 {_pair(first)}")
        return " ".join(steps) + " Z"

    def _away(self, point: Vec, middle: Vec, pixels: float) -> Pixel:
        """The pixel so far beyond `point`, seen from `middle`."""
        (x, y), (mx, my) = self.pixel(point), self.pixel(middle)
        long = math.hypot(x - mx, y - my)
        if long < 1e-6:
            return x, y - pixels
        return x + (x - mx) / long * pixels, y + (y - my) / long * pixels


def _spacing(least: float) -> float:
    """The smallest of 1, 2, 5, 10, ... (and their tenths) that is not below `least`."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(step * power for step in (1.0, 2.0, 5.0, 10.0) if step * power >= least)


def _middle(points: Sequence[Vec]) -> Vec:
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)


def _between(p: Vec, q: Vec) -> Vec:
    return (p[0] + q[0]) / 2, (p[1] + q[1]) / 2


def _pair(pixel: Pixel) -> str:
    return f"{number(pixel[0])} {number(pixel[1])}"


def _clipped(point: Pixel, way: Pixel, box: tuple[float, float, float, float]) -> tuple[Pixel, Pixel] | None:
    """The part of a line inside a box (left, top, right, bottom); None if it misses it."""
    low, high = -math.inf, math.inf
    for place, step, least, most in ((point[0], way[0], box[0], box[2]), (point[1], way[1], box[1], box[3])):
        if step == 0.0:
            if not least <= place <= most:
                return None
            continue
        first, last = sorted(((least - place) / step, (most - place) / step))
        low, high = max(low, first), min(high, last)
    if low >= high:
        return None
    return (point[0] + way[0] * low, point[1] + way[1] * low), (point[0] + way[0] * high, point[1] + way[1] * high)
