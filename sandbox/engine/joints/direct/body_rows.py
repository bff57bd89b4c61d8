"""The rows of bodies that stay in the system of a part (`augmented`): what joints do to them, and less their masses."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sandbox._vectors import WIDTH
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import BODY, OF_INERTIA, OF_JACOBIAN, OF_MASS
from sandbox.engine.joints.elimination import NOBODY
from sandbox.engine.joints.symbolic import Pattern
from sandbox.tables import Integers


class Terms(NamedTuple):
    """What is added up in entries of the factor: in which, and what a `PRODUCT` says of it; seats are numbers."""

    entry: Integers
    one: Integers
    other: Integers
    linear: Integers
    seat: Integers


def sides_without(kind: Integers, sides: Integers) -> Integers:
    """The sides of joints, and of bodies that stay in the system, with `NOBODY` in the place of those bodies."""
    inner: Integers = np.where(_stay(kind, sides), NOBODY, sides)
    return inner


def is_augmented(kind: Integers, sides: Integers) -> NDArray[np.bool_]:
    """Which joints act on bodies that stay in the system, and on others that do not."""
    stay = _stay(kind, sides)
    others = (sides >= 0) & ~stay
    both: NDArray[np.bool_] = np.any(stay, axis=1) & np.any(others, axis=1)
    return both


def terms_of_bodies(kind: Integers, sides: Integers, joint: Integers, slot: Integers, pattern: Pattern) -> Terms:
    """The terms of their entries; joints and bodies have kinds and sides, and each row is of one of them."""
    is_body = kind[joint] == BODY
    own = np.zeros(len(joint), np.bool_)
    own[pattern.row_of] = True
    first = np.zeros(int(sides.max(initial=-1)) + 1, np.int64)
    first[sides[joint[is_body & (slot == 0)], 0]] = np.flatnonzero(is_body & (slot == 0))
    at_row, side = np.nonzero(_stay(kind, sides)[joint] & (own & ~is_body)[:, None])
    row, side, axis = np.repeat(at_row, 3), np.repeat(side, 3), np.tile(np.arange(3), len(at_row))
    seat = sides[joint[row], side]
    of_body = first[seat] + axis
    jacobian = row * at.ROW_SIZE + at.JACOBIAN + side * at.SIDE + axis * WIDTH
    diagonal = np.flatnonzero(is_body)
    place = np.append(jacobian, diagonal * at.ROW_SIZE)
    return Terms(
        pattern.entries(np.append(np.minimum(row, of_body), diagonal), np.append(np.maximum(row, of_body), diagonal)),
        place,
        place,
        np.append(np.full(len(row), OF_JACOBIAN), np.where(slot[diagonal] == 2, OF_INERTIA, OF_MASS)),
        np.append(seat, sides[joint[diagonal], 0]),
    )


def _stay(kind: Integers, sides: Integers) -> NDArray[np.bool_]:
    """On which sides there is a body that stays in the system."""
    stay: NDArray[np.bool_] = np.isin(sides, sides[kind == BODY, 0])
    return stay
