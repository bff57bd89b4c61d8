"""Our answers and pymunk's, side by side for all pairs of a step; what is left open goes to the third referee."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from sandbox.reference.ask_pymunk import Answers
from sandbox.reference.poses import Poses
from sandbox.reference.tolerance import allowed_error, touch_tolerance
from sandbox.tables import Floats, Integers, Records

_SAME_AXIS = 1e-3
"""Radians. The depth tolerance lets equal axes differ by 1e-4 at most; what differs by more is another axis."""

Mask = np.ndarray[Any, np.dtype[np.bool_]]


@dataclass(frozen=True)
class ComparedPairs:
    """Masks over the pairs of a step. Every pair is `agreed`, `touching` or neither, that is, open.

    `no_contact` pairs overlap, but the step has no contact for them; the contacts of `wrong_axis` ones push along an
    axis that is worse than the best by more than the step's preference for a face allows; parts of concave polygons are
    neither. `depth_error` (m) and `normal_error` (rad) are the worst differences among agreed pairs, `other_axis`
    counts those with another, equally good axis.
    """

    agreed: Mask
    touching: Mask
    no_contact: Mask
    wrong_axis: Mask
    depth_error: float
    normal_error: float
    other_axis: int


def compare_answers(
    poses: Poses,
    pairs: Integers,
    separation: Floats,
    normal: Floats,
    theirs: Answers,
    contacts: Records,
    face_bias: float,
) -> ComparedPairs:
    """Compare the narrow phase's `separation` and `normal` and the step's `contacts` with pymunk's answers.

    By so much (m) at most an axis that the step has kept may be worse than the best one.
    """
    size, reach = poses.size(pairs), poses.reach(pairs)
    touch, error = touch_tolerance(size, reach), allowed_error(size, reach)
    ours = separation < 0.0
    both = ours & theirs.hit
    depth_error = np.where(both, np.abs(separation + theirs.depth), 0.0)
    # A normal is right if the overlap along it is the least there is, whichever of several such axes it is.
    excess = poses.overlap_along(pairs, theirs.normal) + separation
    is_unit = np.abs((theirs.normal**2).sum(axis=1) - 1.0) < 1e-9
    agreed = (~ours & ~theirs.hit) | (both & (depth_error <= error) & (excess <= error) & is_unit)
    touching = ~agreed & (np.abs(separation) <= touch) & (~theirs.hit | (np.abs(theirs.depth) <= touch))
    no_contact, wrong_axis = _of_the_step(poses, pairs, separation, contacts, touch, error + face_bias)
    agreed &= ~(no_contact | wrong_axis)
    angles = _angles(normal, theirs.normal)
    single = agreed & both & (angles <= _SAME_AXIS)
    return ComparedPairs(
        agreed=agreed,
        touching=touching,
        no_contact=no_contact,
        wrong_axis=wrong_axis,
        depth_error=float(depth_error[agreed].max(initial=0.0)),
        normal_error=float(angles[single].max(initial=0.0)),
        other_axis=int((agreed & both & ~single).sum()),
    )


def _of_the_step(
    poses: Poses, pairs: Integers, separation: Floats, contacts: Records, touch: Floats, most: Floats
) -> tuple[Mask, Mask]:
    """(no_contact, wrong_axis): the overlapping pairs without a contact, and those that it would push the wrong way, by
    more than `most` (m) worse than the best one."""
    # Of the parts of something larger, the step keeps only the contacts that the whole has
    # (`engine/narrow_phase/internal_edges.py`), and of what is solid from one side only, those that come from there.
    deep = (separation < -touch) & (poses.shapes.traits[pairs] == 0).all(axis=1)
    rows = find_rows(pairs, np.stack([contacts.shape_a, contacts.shape_b], axis=1), len(poses.shapes))
    normals = np.zeros((len(pairs), 2))
    there = rows >= 0
    normals[there, 0], normals[there, 1] = contacts.normal_x[rows[there]], contacts.normal_y[rows[there]]
    excess = poses.overlap_along(pairs, normals) + separation
    return deep & ~there, deep & there & (excess > most)


def find_rows(pairs: Integers, among: Integers, shapes: int) -> Integers:
    """For each of `pairs` its row in `among` (sorted by both columns), or -1."""
    among, pairs = among.astype(np.int64), pairs.astype(np.int64)  # from columns of four bytes
    keys, wanted = among[:, 0] * shapes + among[:, 1], pairs[:, 0] * shapes + pairs[:, 1]
    rows = np.searchsorted(keys, wanted)
    found = rows < len(keys)
    found[found] = keys[rows[found]] == wanted[found]
    return np.where(found, rows, -1)


def _angles(first: Floats, second: Floats) -> Floats:
    """(n,) rad between directions; by the arc tangent, which is exact for small ones."""
    cross = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    angles: Floats = np.abs(np.arctan2(cross, (first * second).sum(axis=1)))
    return angles
