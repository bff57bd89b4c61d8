"""How rows of the tables have to fit together: in which order they are, and what two fields say of each other."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.tables import Integers
from sandbox.world.joint_records import GEAR, KINDS, PRISMATIC, REVOLUTE, WHEEL
from sandbox.world.records import DYNAMIC, SEAMED
from sandbox.world.runs import run_starts

Rows = Mapping[str, NDArray[Any]]
"""The rows of every table by its name, as plain arrays. Each number by itself is one that its column may hold."""
Flags = NDArray[np.bool_]
_CAN_BE_COUPLED = np.isin(np.arange(len(KINDS)), (REVOLUTE, WHEEL, PRISMATIC))
"""By the kind of a joint."""


def broken_relations(rows: Rows, sound: Collection[str] = ()) -> Iterator[str]:
    """What does not fit together, in words, each with the first row in which it does not. The rows of tables that are
    `sound` fit each other."""
    for table, others, field, fits, rule in _RELATIONS:
        if len(rows[table]) and not (table in sound and all(other in sound for other in others)):
            fitting = fits(rows)
            if not fitting.all():
                row = int(np.argmin(fitting))
                yield f"{field} is {rows[table][field][row]} in row {row} of its {table} table, but {rule}"


def _owners_in_order(rows: Rows) -> Flags:
    return _not_less(rows["shape"]["body"])


def _cores_side_by_side(rows: Rows) -> Flags:
    shapes = rows["shape"]
    fits: Flags = shapes["vertex_start"] == run_starts(shapes["vertex_count"])
    fits[-1] &= shapes["vertex_start"][-1] + shapes["vertex_count"][-1] == len(rows["vertex"])
    return fits


def _sides_side_by_side(rows: Rows) -> Flags:
    regions = rows["region"]
    fits: Flags = regions["first_edge"] == run_starts(regions["edge_count"])
    fits[-1] &= regions["first_edge"][-1] + regions["edge_count"][-1] == len(rows["edge"])
    return fits


def _seams_inside(rows: Rows) -> Flags:
    shapes = rows["shape"]
    fits: Flags = (shapes["traits"] & SEAMED == 0) | (
        shapes["seam_start"] + shapes["vertex_count"] <= len(rows["seam"])
    )
    return fits


def _pairs_in_order(rows: Rows) -> Flags:
    a, b = _columns(rows["contact"], "shape_a", "shape_b")
    pair = a.astype(np.int64) * len(rows["shape"]) + b
    fits: Flags = a < b
    fits[1:] &= pair[1:] > pair[:-1]
    return fits


def _body_of_shape(side: str) -> Callable[[Rows], Flags]:
    def fits(rows: Rows) -> Flags:
        shape, body = _columns(rows["contact"], f"shape_{side}", f"body_{side}")
        found: Flags = np.ascontiguousarray(rows["shape"]["body"])[shape] == body
        return found

    return fits


def _own_bodies(rows: Rows) -> Flags:
    """A joint holds two different bodies, one of which can move; a gear none."""
    joints = rows["joint"]
    a, b = joints["body_a"], joints["body_b"]
    movable = np.append(rows["body"]["mass"] > 0.0, False)
    fits: Flags = np.where(joints["kind"] == GEAR, (a < 0) & (b < 0), (a != b) & (movable[a] | movable[b]))
    return fits


def _coupled(side: int) -> Callable[[Rows], Flags]:
    """A gear couples two joints that slide or turn; the others none."""

    def fits(rows: Rows) -> Flags:
        joints = rows["joint"]
        row = joints[f"joint_{side}"]
        kind = joints["kind"]
        turns = _CAN_BE_COUPLED[kind[row]] & (joints["joint_1"] != joints["joint_2"])
        found: Flags = np.where(kind == GEAR, (row >= 0) & turns, row < 0)
        return found

    return fits


def _sleepers_counted(rows: Rows) -> Flags:
    bodies = rows["body"]
    fits: Flags = rows["counters"]["asleep_count"] >= np.count_nonzero(
        (bodies["type"] == DYNAMIC) & (bodies["awake"] == 0)
    )
    return fits


def _columns(rows: NDArray[Any], *names: str) -> list[Integers]:
    """Some columns, each lying together: what is looked at several times is read from far apart only once."""
    return [np.ascontiguousarray(rows[name]) for name in names]


def _not_less(column: NDArray[Any]) -> Flags:
    fits = np.ones(len(column), np.bool_)
    fits[1:] = column[1:] >= column[:-1]
    return fits


_RELATIONS: tuple[tuple[str, tuple[str, ...], str, Callable[[Rows], Flags], str], ...] = (
    ("shape", (), "body", _owners_in_order, "shapes are in the order of their bodies"),
    ("shape", ("vertex",), "vertex_start", _cores_side_by_side, "cores lie one after the other"),
    ("shape", ("seam",), "seam_start", _seams_inside, "the seam table has too few rows"),
    ("region", ("edge",), "first_edge", _sides_side_by_side, "the half-planes of regions lie one after the other"),
    ("contact", ("shape",), "shape_b", _pairs_in_order, "contacts are in the order of their shapes"),
    ("contact", ("shape",), "body_a", _body_of_shape("a"), "shape_a is of another one"),
    ("contact", ("shape",), "body_b", _body_of_shape("b"), "shape_b is of another one"),
    ("joint", ("body",), "body_a", _own_bodies, "a joint holds two bodies, one of which can move, and a gear none"),
    ("joint", (), "joint_1", _coupled(1), "a gear couples two joints that turn or slide, and others none"),
    ("joint", (), "joint_2", _coupled(2), "a gear couples two joints that turn or slide, and others none"),
    ("counters", ("body",), "asleep_count", _sleepers_counted, "more bodies are asleep"),
)
"""Table, the others that are looked into, field, which rows fit, and the rule."""
