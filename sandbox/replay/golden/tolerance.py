"""Comparing by figures instead of bits: for engines whose arithmetic changed on purpose, or other engines."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields

from sandbox.arguments import checked_number
from sandbox.replay.golden.divergence import Divergence, Drift
from sandbox.replay.recording.checkpoint import Checkpoint
from sandbox.replay.recording.recording_fields import Pose


@dataclass(frozen=True)
class Tolerance:
    """How far apart figures may be.

    `energy` is a share of the highest energy at any checkpoint; `counts` a share of touching contacts and of bodies
    awake, which may always be off by two; `depth` (m) of the deepest overlap; `distance` (m) and `turn` (rad) of each
    body at the end. Raises `ArgumentError` for what is no number from 0.
    """

    energy: float = 0.01
    counts: float = 0.1
    depth: float = 0.001
    distance: float = 0.02
    turn: float = 0.02

    def __post_init__(self) -> None:
        for item in fields(self):
            checked_number("Tolerance", item.name, getattr(self, item.name), 0)


def compare_checkpoints(
    expected: Iterable[Checkpoint], got: Iterable[Checkpoint], rate: float, tolerance: Tolerance
) -> Divergence | None:
    """The first figure that left its tolerance."""
    expected = list(expected)
    scale = max((abs(row.energy) for row in expected), default=0.0)
    for old, new in zip(expected, got, strict=True):
        for name, a, b, room in _figures(old, new, scale, tolerance):
            if not abs(a - b) <= room:
                return Divergence(old.step, old.step / rate, name, f"{a:g} within {room:.2g}", f"{b:g}")
    return None


def compare_poses(drifts: Iterable[Drift], steps: int, rate: float, tolerance: Tolerance) -> Divergence | None:
    """The first body at the end that is out of its tolerance; `drifts` has the worst first."""
    for drift in drifts:
        if drift.distance > tolerance.distance:
            text = f"{drift.body} within {tolerance.distance:g} m"
            return Divergence(steps, steps / rate, "pose", text, f"{drift.distance:.3g} m away")
        if drift.turn > tolerance.turn:
            text = f"{drift.body} within {tolerance.turn:g} rad"
            return Divergence(steps, steps / rate, "pose", text, f"turned {drift.turn:.3g} rad away")
    return None


def drifts_of(expected: Mapping[str, Pose], got: Mapping[str, Pose]) -> list[Drift]:
    """Every body that is not exactly where it was, farthest first."""
    names = dict.fromkeys([*expected, *got])
    found = [_drift(name, expected.get(name), got.get(name)) for name in names if expected.get(name) != got.get(name)]
    return sorted(found, key=lambda drift: -max(drift.distance, drift.turn))


def _drift(body: str, a: Pose | None, b: Pose | None) -> Drift:
    if a is None or b is None:
        return Drift(body, a, b, math.inf, math.inf)
    return Drift(body, a, b, math.hypot(a[0] - b[0], a[1] - b[1]), abs(a[2] - b[2]))


def _figures(
    old: Checkpoint, new: Checkpoint, scale: float, tolerance: Tolerance
) -> list[tuple[str, float, float, float]]:
    counts = max(2.0, tolerance.counts * old.contacts), max(2.0, tolerance.counts * old.awake)
    return [
        ("energy", old.energy, new.energy, tolerance.energy * scale),
        ("contacts", old.contacts, new.contacts, counts[0]),
        ("awake", old.awake, new.awake, counts[1]),
        ("deepest", old.deepest, new.deepest, tolerance.depth),
    ]
