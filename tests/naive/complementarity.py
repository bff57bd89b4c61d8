"""Rows with bounds by going through all ways to be at them.

Each row has a *law*: a monotone curve in the plane of speed and impulse, made of straight pieces. Impulses p change
speeds by A p, where A is J M^-1 J^T; wanted are the impulses at which every row is on its curve. As A is positive
definite, but for rows that say the same, there is one answer, and some choice of one piece a row finds it.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np

Array = np.ndarray
INF = float("inf")
ROUNDING = 1e-9


@dataclass(frozen=True)
class Piece:
    """A stretch of a law: either the impulse is `given`, or speed = aim - softness * impulse; and where it ends."""

    aim: float = 0.0
    softness: float = 0.0
    given: float | None = None
    impulses: tuple[float, float] = (-INF, INF)
    speeds: tuple[float, float] = (-INF, INF)


Law = list[Piece]


def striving(aim: float, softness: float = 0.0, strength: float = INF) -> Law:
    """Strives for a speed as far as its strength goes."""
    law = [Piece(aim, softness, impulses=(-strength, strength))]
    if strength < INF:
        law.append(Piece(given=strength, speeds=(-INF, aim - softness * strength)))
        law.append(Piece(given=-strength, speeds=(aim + softness * strength, INF)))
    return law


def driven(aim: float | None, strength: float, slowest: float, fastest: float) -> Law:
    """A motor that strives for a speed, if there is one, between two stops that push as hard as they have to."""
    if slowest >= fastest:
        return [Piece(slowest)]
    if aim is None:
        law = [Piece(given=0.0, speeds=(slowest, fastest))]
        at_slowest = at_fastest = 0.0
    else:
        law = []
        if slowest <= aim <= fastest:
            law.append(Piece(aim, impulses=(-strength, strength)))
        if strength < INF:
            law.append(Piece(given=strength, speeds=(slowest, min(aim, fastest))))
            law.append(Piece(given=-strength, speeds=(max(aim, slowest), fastest)))
        at_slowest = -strength if aim < slowest else strength
        at_fastest = strength if aim > fastest else -strength
    if slowest > -INF and at_slowest < INF:
        law.append(Piece(slowest, impulses=(at_slowest, INF)))
    if fastest < INF and at_fastest > -INF:
        law.append(Piece(fastest, impulses=(-INF, at_fastest)))
    return law


def impulses(matrix: Array, speeds: Array, laws: list[Law]) -> Array | None:
    """The impulses that put every row on its law, if they are added to rows with those speeds."""
    size = 1.0 + float(np.max(np.abs(speeds), initial=0.0))
    for choice in product(*laws):
        found = _with_pieces(matrix, speeds, choice)
        if found is not None and _fits(matrix, speeds, choice, found, size):
            return found
    return None


def _with_pieces(matrix: Array, speeds: Array, choice: tuple[Piece, ...]) -> Array | None:
    given = np.array([piece.given is not None for piece in choice], bool)
    found = np.array([piece.given or 0.0 for piece in choice])
    aims = np.array([piece.aim for piece in choice])
    soft = np.diag([piece.softness for piece in choice])
    left = ~given
    if not np.all(np.isfinite(found)):
        return None
    if left.any():
        wanted = (aims - speeds - matrix @ found)[left]
        try:
            found[left] = np.linalg.solve((matrix + soft)[np.ix_(left, left)], wanted)
        except np.linalg.LinAlgError:
            return None
    return found


def _fits(matrix: Array, speeds: Array, choice: tuple[Piece, ...], found: Array, size: float) -> bool:
    after = speeds + matrix @ found
    strong = 1.0 + float(np.max(np.abs(found), initial=0.0))
    for piece, impulse, speed in zip(choice, found, after, strict=True):
        (low, high), (slow, fast) = piece.impulses, piece.speeds
        if not low - ROUNDING * strong <= impulse <= high + ROUNDING * strong:
            return False
        if not slow - ROUNDING * size <= speed <= fast + ROUNDING * size:
            return False
    return True
