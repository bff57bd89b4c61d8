"""Which rows the joints of a world need, what hangs together, and in which order it is eliminated."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.joints.components import components
from sandbox.engine.joints.elimination import NOBODY, WORLD
from sandbox.engine.joints.more_parts import with_more_pairs, with_more_parts
from sandbox.engine.joints.pair_filter import NO_BOND, JointFilter, note_first
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.joints.part_tables import Parts, joint_work
from sandbox.engine.joints.records import BOND, JointWork
from sandbox.engine.joints.wiring import movable
from sandbox.tables import Integers, Records, plain
from sandbox.world import joint_records as kinds

Flags = NDArray[np.bool_]


def holding(joints: Records) -> Flags:
    """Which joints have an effect: neither broken nor switched off, nor a gear on such a joint."""
    works: Flags = (np.asarray(joints.enabled) != 0) & (joints.broken_step < 0)
    gear = joints.kind == kinds.GEAR
    works &= ~gear | (works[joints.joint_1] & works[joints.joint_2])
    return works


def assemble(joints: Records, bodies: Records, layouts: PartLayouts, room: int) -> tuple[JointFilter, JointWork | None]:
    """The pairs of bodies that joints keep from colliding, and scratch memory for all joints that hold.

    The memory is None where no joint holds: kernels are given `no_joints` then. Both are functions of the two tables
    alone, and of no more of them than `wiring` tells: a world that goes on and one that is restored solve in the same
    order. `layouts` are those of the last time, so that only parts of a new kind are laid out; `room` is for how many
    bodies there is to be memory.
    """
    held = np.flatnonzero(holding(joints))
    bonds, work = _assembled(joints, bodies, layouts, room, (held, _sides(joints, held)))
    return note_first(JointFilter(bonds, np.full(room, NO_BOND))), work


def assemble_more(
    joints: Records, bodies: Records, layouts: PartLayouts, known: tuple[JointFilter, JointWork | None], first: int
) -> tuple[JointFilter, JointWork | None] | None:
    """The same after joints have come from row `first` on, made of what is `known` of the others.

    None if they hold bodies that others hold as well, or may hold, or that joints cannot move.
    """
    joint_filter, work = known
    held = first + np.flatnonzero(holding(joints)[first:])
    sides = _sides(joints, held)
    seen = sides[sides > WORLD]
    if not movable(bodies, seen).all() or (work is not None and (work.part_of[seen] >= 0).any()):
        return None
    room = len(joint_filter.first)
    bonds, more = _assembled(joints, bodies, layouts, room, (held, sides), others=work is not None)
    joint_filter = with_more_pairs(joint_filter, bonds)
    if work is not None:
        return joint_filter, work._replace(joints=joints) if more is None else with_more_parts(work, more, joints)
    return joint_filter, more


def _assembled(
    joints: Records,
    bodies: Records,
    layouts: PartLayouts,
    room: int,
    holding: tuple[Integers, Integers],
    others: bool = False,
) -> tuple[Records, JointWork | None]:
    """The bonds and the memory of some joints that hold, given with the bodies on their sides."""
    held, sides = holding
    gear, collide = joints.kind[held] == kinds.GEAR, joints.collide[held] != 0
    bonds = _bonds(sides[~gear & ~collide], len(bodies))
    if not len(held):
        return bonds, None
    moves = sides > WORLD
    moves[moves] = movable(bodies, sides[moves])
    parts = _parts(held, sides, moves)
    return bonds, joint_work(joints, parts, _bonds(sides, len(bodies)), room, layouts, others)


def _sides(joints: Records, held: Integers) -> Integers:
    """The bodies of each joint, -1 for the world: two, or the four of the joints that a gear couples; else -2."""
    rows = plain(joints)
    sides = np.full((len(held), 4), NOBODY)
    sides[:, 0], sides[:, 1] = rows["body_a"][held], rows["body_b"][held]
    gears = np.flatnonzero(rows["kind"][held] == kinds.GEAR)
    for k, name in ((0, "joint_1"), (2, "joint_2")):
        coupled = rows[name][held[gears]]
        sides[gears, k], sides[gears, k + 1] = rows["body_a"][coupled], rows["body_b"][coupled]
    return sides


def _parts(held: Integers, sides: Integers, moves: Flags) -> Parts:
    """Joints that hang together by bodies they move, each set in ascending order."""
    joint, _ = np.nonzero(moves)
    order = np.argsort(sides[moves], kind="stable")
    body, joint = sides[moves][order], joint[order]
    same = body[1:] == body[:-1]
    root = components(len(held), joint[:-1][same], joint[1:][same])
    order = np.argsort(root, kind="stable")
    first = np.flatnonzero(np.diff(root[order], prepend=-1))
    return Parts(held[order], sides[order], moves[order], np.append(first[1:], len(held)))


def _bonds(sides: Integers, bodies: int) -> Records:
    """All pairs of bodies on different sides of a joint, each once, sorted."""
    gears = sides[sides[:, 3] > NOBODY]
    pairs = [sides[:, :2], *(gears[:, pair] for pair in combinations(range(4), 2))]
    one, two = np.concatenate(pairs).T
    low, high = np.minimum(one, two), np.maximum(one, two)
    bound = (low > WORLD) & (low < high)
    keys = np.sort(low[bound] * bodies + high[bound])
    keys = keys[np.diff(keys, prepend=-1) > 0]
    table = BOND.zeros(len(keys))
    table.low, table.high = keys // max(bodies, 1), keys % max(bodies, 1)
    return table
