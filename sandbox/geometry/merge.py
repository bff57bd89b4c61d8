"""Convex parts from triangles: diagonals are taken out where both sides together are still convex.

This never leaves more than four times the least number of parts (S. Hertel, K. Mehlhorn 1983), and on random polygons,
with the best of three orders, one or two per cent more. Finding the least number takes far longer, and with holes it is
NP-hard.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sandbox.geometry.exact import Point, cross, distance_squared, span
from sandbox.geometry.polygon import MAX_VERTICES, is_straight
from sandbox.geometry.triangulate import Triangles, diagonals

Ring = list[int]


def convex_parts(turns: Turns, triangles: Triangles) -> list[Ring]:
    """Rings of the points of `turns`, counter-clockwise, convex, with at most 64 corners; straight vertices stay."""
    length = {(a, b): distance_squared(turns.points[a], turns.points[b]) for a, b in diagonals(triangles)}
    # Where parts are as many, long diagonals should go: short ones leave fatter parts.
    longest = sorted(length, key=lambda side: (-length[side], side))
    shortest = sorted(length, key=lambda side: (length[side], -side[0], -side[1]))
    orders = longest, shortest, sorted(length)
    return min((_Merger(triangles, turns).merged(order) for order in orders), key=len)


class Turns:
    """Which way three of the points turn; remembered, as the same question comes often."""

    def __init__(self, points: Sequence[Point]) -> None:
        self.points, self.size = points, span(points)
        self.known: dict[tuple[int, int, int], int] = {}

    def of(self, corner: tuple[int, int, int]) -> int:
        """1 left, -1 right, 0 straight on, to a billionth of the size of all."""
        if corner not in self.known:
            a, b, c = (self.points[i] for i in corner)
            turn = cross(a, b, c)
            self.known[corner] = 0 if is_straight(a, b, c, self.size, 1) else (turn > 0) - (turn < 0)
        return self.known[corner]

    def corners(self, face: Ring) -> Ring:
        """What is left of a counter-clockwise face without its straight vertices; nothing if it has dents."""
        turns = [self.of(corner) for corner in triples(face)]
        return [] if min(turns) < 0 else [b for b, turn in zip(face, turns, strict=True) if turn]


class _Merger:
    def __init__(self, triangles: Triangles, turns: Turns) -> None:
        self.turns = turns
        self.faces: dict[tuple[int, int], Ring] = {}
        for (a, b), c in triangles.items():
            if a < b and a < c:
                self.faces[a, b] = self.faces[b, c] = self.faces[c, a] = [a, b, c]

    def merged(self, order: Sequence[tuple[int, int]]) -> list[Ring]:
        """The parts that are left once each diagonal was tried in this order, themselves in order."""
        for a, b in order:
            self._try(a, b)
        firsts = {id(face): _from_least(face) for face in self.faces.values()}
        return sorted(firsts.values())

    def _try(self, a: int, b: int) -> None:
        """Join the two faces along a diagonal, if they are convex together."""
        left, right = self.faces[a, b], self.faces[b, a]
        i, j = left.index(a), right.index(b)
        at_a = left[i - 1], a, right[(j + 2) % len(right)]
        at_b = right[j - 1], b, left[(i + 2) % len(left)]
        if self.turns.of(at_a) < 0 or self.turns.of(at_b) < 0:
            return
        face = _from(left, i + 1)[:-1] + _from(right, j + 1)[:-1]
        if self._is_convex(face):
            self.faces.update(dict.fromkeys(sides(face), face))
            del self.faces[a, b], self.faces[b, a]

    def _is_convex(self, face: Ring) -> bool:
        ring = self.turns.corners(face)
        # Without a straight vertex its neighbours turn a little less.
        return 3 <= len(ring) <= MAX_VERTICES and (len(ring) == len(face) or self.turns.corners(ring) == ring)


def sides(ring: Ring) -> Iterator[tuple[int, int]]:
    """Each vertex with the next."""
    return zip(ring, ring[1:] + ring[:1], strict=True)


def triples(ring: Ring) -> Iterator[tuple[int, int, int]]:
    """Each vertex between its neighbours."""
    return zip(ring[-1:] + ring[:-1], ring, ring[1:] + ring[:1], strict=True)


def _from(ring: Ring, start: int) -> Ring:
    return ring[start:] + ring[:start]


def _from_least(ring: Ring) -> Ring:
    return _from(ring, ring.index(min(ring)))
