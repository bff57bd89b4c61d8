"""Outlines of a foreign file as shapes of a scene: cleaned of what a scene refuses, or left out with a remark."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

from sandbox.formats.numbers import Vec, tidy_points
from sandbox.formats.remarks import Remarks
from sandbox.formats.uncrossed import crossing, uncrossed
from sandbox.geometry.decompose import check_outline
from sandbox.geometry.polygon import MIN_EDGE, PolygonError
from sandbox.scene.limits import MAX_OUTLINE

Words = dict[str, Any]
"""A part of a scene as it stands in a file."""


def polygon_words(
    outline: Sequence[Vec], remarks: Remarks, place: str, holes: Iterable[Sequence[Vec]] = ()
) -> Words | None:
    """A polygon in metres, convex or not, or None with a remark. Holes that cannot be are left out with one."""
    ring = without_repeats(outline)
    kept = list(map(without_repeats, holes))
    if kept and _fault(ring, kept):
        kept = _possible(ring, kept, remarks, place)
    if not kept and (fault := _fault(ring, ())):
        remarks.note(place, f"a polygon is left out: {fault}")
        return None
    words: Words = {"polygon": tidy_points(ring)}
    return words | ({"holes": [tidy_points(hole) for hole in kept]} if kept else {})


def _possible(ring: list[Vec], holes: list[list[Vec]], remarks: Remarks, place: str) -> list[list[Vec]]:
    """Those holes that a ring can have; the others are left out with a remark, if not the ring itself cannot be."""
    kept: list[list[Vec]] = []
    for hole in [] if _fault(ring, ()) else holes:
        if fault := _fault(ring, (*kept, hole)):
            remarks.note(place, f"a hole is left out: {fault}")
        else:
            kept.append(hole)
    return kept


def polygon_parts(outline: Sequence[Vec], remarks: Remarks, place: str) -> list[Words]:
    """A polygon in metres; one that crosses itself as the polygons that it goes round, with a remark."""
    ring = without_repeats(outline)
    if not _fault(ring, ()):
        return [{"polygon": tidy_points(ring)}]
    if not (3 <= len(ring) <= MAX_OUTLINE and crossing([ring])):
        words = polygon_words(ring, remarks, place)
        return [words] if words else []
    remarks.note(place, "a polygon that crosses itself is all that it goes round")
    found = [polygon_words(part, remarks, place, holes) for part, holes in uncrossed([ring], even_odd=False)]
    return [words for words in found if words]


def chain_words(points: Sequence[Vec], closed: bool, remarks: Remarks, place: str) -> list[Words]:
    """Lines from point to point, in metres: a segment, or one chain, or several where it is too long for one.

    A line that ends where it begins is closed.
    """
    line = without_repeats(points, closed)
    if not closed and len(line) > 3 and math.dist(line[0], line[-1]) < 2 * MIN_EDGE:
        closed, line = True, line[:-1]
    if closed and len(line) < 3:
        closed = False
    if len(line) < 2:
        remarks.note(place, "a line without length is left out")
        return []
    if len(line) == 2:
        return [{"segment": tidy_points(line)}]
    if len(line) <= MAX_OUTLINE:
        return [{"chain": tidy_points(line)} | ({"closed": True} if closed else {})]
    return _cut([*line, line[0]] if closed else line)


def _cut(line: list[Vec]) -> list[Words]:
    """A long line as chains whose ends know of each other, so that they are smooth there."""
    stride = MAX_OUTLINE - 1
    parts = [line[k : k + MAX_OUTLINE] for k in range(0, len(line) - 1, stride)]
    if len(parts[-1]) == 2:  # the last link joins the chain before it, which gives it one of its own
        parts[-2:] = [parts[-2][:-1], [parts[-2][-2], *parts[-1]]]
    found: list[Words] = []
    for k, part in enumerate(parts):
        before = parts[k - 1][-2] if k else _beyond(part[1], part[0])
        after = parts[k + 1][1] if k + 1 < len(parts) else _beyond(part[-2], part[-1])
        found.append({"chain": tidy_points(part), "ghosts": tidy_points([before, after])})
    return found


def without_repeats(points: Sequence[Vec], closed: bool = True) -> list[Vec]:
    """The points without those that repeat the one before, nearer than a scene can tell apart."""
    kept: list[Vec] = []
    for point in points:
        if not kept or math.dist(kept[-1], point) >= 2 * MIN_EDGE:
            kept.append(point)
    while closed and len(kept) > 1 and math.dist(kept[-1], kept[0]) < 2 * MIN_EDGE:
        kept.pop()
    return kept


def convex_hull(points: Iterable[Vec]) -> list[Vec]:
    """The hull counter-clockwise (Andrew's monotone chain), without points on its sides."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    lower, upper = _half(ordered), _half(ordered[::-1])
    return lower[:-1] + upper[:-1]


def _half(ordered: Sequence[Vec]) -> list[Vec]:
    half: list[Vec] = []
    for point in ordered:
        while len(half) > 1 and _cross(half[-2], half[-1], point) <= 0.0:
            half.pop()
        half.append(point)
    return half


def _cross(a: Vec, b: Vec, c: Vec) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _beyond(one: Vec, two: Vec) -> Vec:
    return 2.0 * two[0] - one[0], 2.0 * two[1] - one[1]


def _fault(ring: Sequence[Vec], holes: Sequence[Sequence[Vec]]) -> str:
    """Why a scene would refuse it; "" if it does not."""
    count = len(ring) + sum(map(len, holes))
    if min(map(len, (ring, *holes))) < 3:
        return "it has fewer than 3 corners"
    if count > MAX_OUTLINE:
        return f"it has {count} corners; {MAX_OUTLINE} is the limit"
    try:
        check_outline([(x, y) for x, y in tidy_points(ring)], [[(x, y) for x, y in tidy_points(h)] for h in holes])
    except PolygonError as error:
        return str(error)
    return ""
