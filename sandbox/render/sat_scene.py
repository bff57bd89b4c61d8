"""The pair among all others: every shape of the scene, the box around it, and the pairs whose boxes overlap."""

from __future__ import annotations

from itertools import combinations

from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.shape_box import box_of
from sandbox.geometry.shapes import Shape
from sandbox.render.sat_page import Member, SatFigure, alone
from sandbox.render.svg import Svg


def draw_scene(figure: SatFigure) -> Svg:
    """All shapes, their boxes, and a line for every pair of boxes that overlap: what is left to test."""
    pairs = [pair for pair in combinations(figure.scene_shapes, 2) if _could_collide(*pair)]
    near = [(p, q) for p, q in pairs if _overlap(box_of(p.shape), box_of(q.shape))]
    count = len(figure.scene_shapes)
    words = f"{count} shapes make {len(pairs):,} pairs; only the {len(near):,} whose boxes overlap are tested"
    svg, plane = alone(figure, words, whole_scene=True)
    with plane:
        for member in figure.scene_shapes:
            mine = "a" if member.shape == figure.table.a else "b" if member.shape == figure.table.b else "other"
            plane.shape(member.shape, f"{mine} shape")
            x0, y0, x1, y1 = box_of(member.shape)
            (left, top), (right, bottom) = plane.pixel((x0, y1)), plane.pixel((x1, y0))
            svg.rectangle(left, top, right - left, bottom - top, "other drop")
        for p, q in near:
            plane.line(*_nearest_middles(p.shape, q.shape), "gap edge")
    return svg


def _could_collide(p: Member, q: Member) -> bool:
    return p.body != q.body and (p.moves or q.moves)


def _overlap(p: tuple[float, float, float, float], q: tuple[float, float, float, float]) -> bool:
    return p[0] <= q[2] and q[0] <= p[2] and p[1] <= q[3] and q[1] <= p[3]


def _nearest_middles(p: Shape, q: Shape) -> tuple[Vec, Vec]:
    """The middle of the smaller box, and the point of the larger one's middle line that is nearest to it."""
    a, b = box_of(p), box_of(q)
    return _anchor(a, b), _anchor(b, a)


def _anchor(own: tuple[float, float, float, float], other: tuple[float, float, float, float]) -> Vec:
    """The middle of a box; of one much longer than the other, the place beside the other's middle."""
    width, height = own[2] - own[0], own[3] - own[1]
    x, y = (own[0] + own[2]) / 2, (own[1] + own[3]) / 2
    if width > 3.0 * (other[2] - other[0]):
        x = min(max((other[0] + other[2]) / 2, own[0]), own[2])
    if height > 3.0 * (other[3] - other[1]):
        y = min(max((other[1] + other[3]) / 2, own[1]), own[3])
    return x, y
