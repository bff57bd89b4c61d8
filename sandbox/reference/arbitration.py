"""Two judges disagree on a pair of shapes: who is right?"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.geometry.mass import edge_normals
from sandbox.reference.answer import Answer
from sandbox.reference.decide import decide
from sandbox.reference.exact_referee import Truth, judge, overlap_along
from sandbox.reference.pair import Pair, Point
from sandbox.reference.poses import Poses
from sandbox.reference.tolerance import allowed_error, touch_tolerance
from sandbox.reference.traps import Trap, recognise
from sandbox.world import records


@dataclass(frozen=True)
class Ruling:
    """The outcome: what is wrong with our answer and with theirs (nothing: it is right), and pymunk's trap if known."""

    truth: Truth
    faults: tuple[str, ...]
    their_faults: tuple[str, ...]
    trap: Trap | None


def arbitrate(pair: Pair, ours: Answer, theirs: Answer) -> Ruling:
    """Hold both answers against exact arithmetic."""
    truth = judge(pair)
    their_faults = tuple(faults_of(pair, theirs, truth))
    trap = recognise(pair, theirs, truth, *size_and_reach(pair)) if their_faults else None
    return Ruling(truth, tuple(faults_of(pair, ours, truth)), their_faults, trap)


def faults_of(pair: Pair, answer: Answer | None = None, truth: Truth | None = None) -> list[str]:
    """How an answer (that of the narrow phase if None) differs from the truth; empty if it is right.

    Touching shapes may be called either. A gap may be smaller than the distance, for it is that of one axis.
    """
    answer = answer or our_answer(pair)
    truth = truth or judge(pair)
    tolerance, error = touch_tolerance(*size_and_reach(pair)), allowed_error(*size_and_reach(pair))
    separation, hit = answer.separation, answer.hit
    touching = abs(truth.separation) <= tolerance
    if hit != truth.overlap and not touching:
        return [f"it says {answer}, but the shapes are {'overlapping' if truth.overlap else 'apart'}"]
    if separation is not None and (
        separation > truth.separation + error or (hit and separation < truth.separation - error)
    ):
        return [f"it says {answer}, but the separation is {truth.separation!r} m"]
    return _faults_of_axis(pair, answer, truth, error) if truth.overlap and not touching else []


def _faults_of_axis(pair: Pair, answer: Answer, truth: Truth, error: float) -> list[str]:
    faults: list[str] = []
    if answer.normal is None or answer.normal == (0.0, 0.0):
        return ["it names no axis"]
    along = overlap_along(pair, answer.normal)
    if along > truth.depth + error:
        faults.append(f"along its normal b has to go {along!r} m, but {truth.depth!r} m is enough")
    return faults


def our_answer(pair: Pair) -> Answer:
    """What the narrow phase says of two shapes."""
    separation, normal = decide(poses_of(pair), np.array([[0, 1]]))
    return Answer.ours(float(separation[0]), (float(normal[0, 0]), float(normal[0, 1])))


def size_and_reach(pair: Pair) -> tuple[float, float]:
    """As `Poses.size` and `Poses.reach`."""
    poses, both = poses_of(pair), np.array([[0, 1]])
    return float(poses.size(both)[0]), float(poses.reach(both)[0])


def poses_of(pair: Pair) -> Poses:
    """Two bodies with a shape each, where the pair has them."""
    cores = (pair.a, pair.b)
    bodies, shapes = records.BODY.zeros(2), records.SHAPE.zeros(2)
    vertices = records.VERTEX.zeros(sum(len(core.points) for core in cores))
    start = 0
    for k, (core, center) in enumerate(zip(cores, (pair.center_a, pair.center_b), strict=True)):
        bodies[k].center_x, bodies[k].center_y = center
        bodies[k].rotation_cos, bodies[k].extent = 1.0, extent_of(core.points) + core.radius
        shapes[k].body, shapes[k].radius = k, core.radius
        shapes[k].vertex_start, shapes[k].vertex_count = start, len(core.points)
        for point, normal in zip(core.points, edge_normals(core.points), strict=True):
            vertices[start] = (*point, *normal)
            start += 1
    return Poses.of(bodies, shapes, vertices)


def extent_of(points: tuple[Point, ...]) -> float:
    """Largest distance of a point from the centre."""
    return float(max(np.hypot(x, y) for x, y in points))
