"""The tables of the joint solver for a whole world at once, joint by joint: the judge of `joints/assembly.py`.

All numbers are those of the world from the start.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from sandbox.engine.joints.augmented import MANY_ROWS
from sandbox.engine.joints.net_lanes import lay_lanes
from sandbox.engine.joints.pair_filter import NO_BOND, JointFilter
from sandbox.engine.joints.part_layout import UPDATES_A_ROW, slots_of
from sandbox.engine.joints.records import BOND, CONSTRAINT, MEMBER, PART, ROW
from sandbox.tables import Records
from sandbox.world import joint_records as kinds
from tests.naive.elimination import Pattern, minimum_degree, symbolic

Pair = tuple[int, int]


class Row(NamedTuple):
    """A row of a factorised part: whose it is, and the bodies on its sides, -1 the world. The velocities of a body that
    stays in the system are of joint -1."""

    joint: int
    slot: int
    bodies: tuple[int, ...]


class Product(NamedTuple):
    """What one body, on a side of a row and on a side of another, adds to an entry; or what a row does to a body that
    stays, along the axis `other_side`, where `other` is -1; or less the mass of that body, or its inertia (2),
    where it is -2."""

    row: int
    side: int
    other: int
    other_side: int
    body: int


class Factor(NamedTuple):
    """A factorised part: its rows, the rows of each column from the diagonal down, what each entry is the sum of, the
    entries from which each column subtracts, and whether some row may have bounds."""

    rows: list[Row]
    columns: list[list[int]]
    products: list[list[Product]]
    targets: list[int]
    bounded: bool


class NaiveWork(NamedTuple):
    """As `JointWork`, but for what parts share."""

    ties: Records
    part_of: Any
    members: Records
    constraints: Records
    rows: Records
    parts: Records
    side_by_side: Any
    factors: dict[int, Factor]


def slots_of_joint(joint: Any) -> tuple[int, ...]:
    """The rows a joint needs."""
    return slots_of(int(joint.kind), bool(joint.spring), bool(joint.limit), bool(joint.motor))


def _without_shared(slots: tuple[int, ...]) -> tuple[int, ...]:
    """Of the rows of a joint those with an equation: a limit and motor beside a spring share that one's."""
    return tuple(slot for slot in slots if not (slot == 4 and 3 in slots))


def _may_be_bounded(joint: Any, slot: int) -> bool:
    kind = int(joint.kind)
    brake = kind == kinds.WHEEL and slot == 2
    return slot == 4 or brake or kind in (kinds.MOTOR, kinds.TARGET, kinds.FRICTION)


def holding(joints: Records) -> list[bool]:
    """Which joints have an effect: neither broken nor switched off, nor a gear on such a joint."""
    works = [bool(joint.enabled) and joint.broken_step < 0 for joint in joints]
    return [
        works[j] and (int(joint.kind) != kinds.GEAR or (works[joint.joint_1] and works[joint.joint_2]))
        for j, joint in enumerate(joints)
    ]


def assemble(joints: Records, bodies: Records) -> tuple[JointFilter, NaiveWork | None]:
    """The pairs of bodies that joints keep from colliding, and scratch memory for all joints that hold.

    The memory is None where no joint holds, so that such worlds pay nothing. Both are functions of the two tables
    alone: a world that goes on and one that is restored solve in the same order.
    """
    layout = _Layout(joints, bodies)
    tied, bound = layout.pairs()
    first = np.full(len(bodies), NO_BOND)
    for k, (low, _) in reversed(list(enumerate(sorted(bound)))):
        first[low] = k
    work = layout.work(_pair_table(tied)) if layout.holding else None
    return JointFilter(_pair_table(bound), first), work


def _of_body(rows: list[Row], r: int, s: int) -> list[Product]:
    """The terms of an entry of a body that stays in the system."""
    of_body, other = (r, s) if rows[r].joint < 0 else (s, r)
    (body,), axis = rows[of_body].bodies, rows[of_body].slot
    if rows[other].joint < 0:
        return [Product(r, 0, -2, 2 * (axis == 2), body)] if r == s else []
    return [Product(other, side, -1, axis, body) for side, each in enumerate(rows[other].bodies) if each == body]


def _updates(later: dict[int, list[int]], weights: dict[int, int]) -> int:
    """Updates of the elimination of nodes with so many rows; each links all that it was linked to."""
    place = {node: k for k, node in enumerate(later)}
    filled = {node: set(each) for node, each in later.items()}
    total = 0
    for node in later:
        total += weights[node] * (weights[node] + sum(weights[k] for k in filled[node])) ** 2 // 2
        if filled[node]:
            first = min(filled[node], key=place.__getitem__)
            filled[first] |= filled[node] - {first}
    return total


class _Layout:
    def __init__(self, joints: Records, bodies: Records) -> None:
        self.joints = joints
        # A body that bad numbers froze keeps its mass, but moves no more.
        self.movable = (np.asarray(bodies.mass) > 0.0) & (np.asarray(bodies.frozen_step) < 0)
        self.holding = [j for j, holds in enumerate(holding(joints)) if holds]
        self.touched = {j: self._touched(joints[j]) for j in self.holding}

    def _touched(self, joint: Any) -> list[int]:
        """The bodies of a joint that it can move, in the order of its sides."""
        return [body for body in self._sides(joint) if body >= 0 and self.movable[body]]

    def _sides(self, joint: Any) -> list[int]:
        if int(joint.kind) != kinds.GEAR:
            return [int(joint.body_a), int(joint.body_b)]
        first, second = self.joints[joint.joint_1], self.joints[joint.joint_2]
        return [int(first.body_a), int(first.body_b), int(second.body_a), int(second.body_b)]

    def work(self, ties: Records) -> NaiveWork:
        """Everything, part after part."""
        self.ties = ties
        self.of_body: dict[int, list[int]] = {}
        for j, touched in self.touched.items():
            for body in dict.fromkeys(touched):
                self.of_body.setdefault(body, []).append(j)
        self.member_of = {-1: 0}
        self.members: list[tuple[int, int]] = [(-1, -1)]
        for j in self.holding:
            for body in self._sides(self.joints[j]):
                if body >= 0 and not self.movable[body]:
                    self._add_member(body, -1)
        self.constraints: list[int] = []
        self.rows: list[tuple[int, int, list[int]]] = []
        self.parts: list[dict[str, int]] = []
        self.factors: dict[int, Factor] = {}
        self.fixed = 0
        for number, part in enumerate(self._parts()):
            self._add_part(number, part)
        return self._tables()

    def _add_member(self, body: int, part: int) -> None:
        if body not in self.member_of:
            self.member_of[body] = len(self.members)
            self.members.append((body, part))

    def _parts(self) -> list[list[int]]:
        """Joints that hang together by bodies they move, each set in ascending order."""
        seen = set()
        found = []
        for start in self.holding:
            if start in seen:
                continue
            seen.add(start)
            part = [start]
            for j in part:  # grows while it is walked
                for body in self.touched[j]:
                    fresh = [k for k in self.of_body[body] if k not in seen]
                    part += fresh
                    seen.update(fresh)
            found.append(sorted(part))
        return found

    def _add_part(self, number: int, part: Sequence[int]) -> None:
        first_member, first_constraint, first_row = len(self.members), len(self.constraints), len(self.rows)
        for j in part:
            for body in self.touched[j]:
                self._add_member(body, number)
        slots = {j: slots_of_joint(self.joints[j]) for j in part}
        neighbours = {j: sorted({k for body in self.touched[j] for k in self.of_body[body]} - {j}) for j in part}
        weights = {j: len(_without_shared(slots[j])) for j in part}
        order, direct = minimum_degree(part, neighbours, weights, UPDATES_A_ROW)
        place = {j: k for k, j in enumerate(order)}
        later = {j: [k for k in neighbours[j] if place[k] > place[j]] for j in order}
        if not direct:
            later = self._augmented(part, weights) or {}
            order, direct = (list(later), True) if later else (order, False)
        if direct:
            bounded = any(_may_be_bounded(self.joints[j], slot) for j in part for slot in slots[j])
            self.factors[number] = self._factor(later, bounded)
        order = [j for j in order if j >= 0]
        for j in order:
            sides = [self.member_of[body] for body in self._sides(self.joints[j])]
            self.rows += [] if direct else [(len(self.constraints), slot, sides) for slot in slots[j]]
            self.constraints.append(j)
        fixed = sum(body not in self.touched[j] for j in part for body in self._sides(self.joints[j]))
        keeps = all(
            self.joints[j].kind in (kinds.REVOLUTE, kinds.WELD)
            or (self.joints[j].kind == kinds.DISTANCE and not self.joints[j].spring and not self.joints[j].limit)
            for j in part
        )
        self.parts.append(
            {
                "first_row": first_row, "row_end": len(self.rows), "first_constraint": first_constraint,
                "constraint_end": len(self.constraints), "first_member": first_member, "member_end": len(self.members),
                "direct": int(direct), "anchored": int(fixed > 0), "hung": int(fixed > 0 and keeps),
                "first_fixed": self.fixed,
            }
        )  # fmt: skip
        self.fixed += fixed

    def _augmented(self, part: Sequence[int], weights: dict[int, int]) -> dict[int, list[int]] | None:
        """Joints, and bodies that stay in the system, `~body` in their place, as they are eliminated, and what of those
        after it each is linked to at first; None if that takes too much."""
        rows_of: Counter[int] = Counter()
        for j in part:
            for body in self.touched[j]:
                rows_of[body] += weights[j]
        stay = sorted((body for body, rows in rows_of.items() if rows > MANY_ROWS), key=self.member_of.__getitem__)
        inner = {j: set(self.touched[j]) - set(stay) for j in part}
        early = [j for j in part if inner[j]]
        around = {j: [k for k in early if k != j and inner[j] & inner[k]] for j in early}
        order, pays = minimum_degree(early, around, weights, UPDATES_A_ROW)
        if not (stay and early and pays):
            return None
        place = {j: k for k, j in enumerate(order)}
        later = {
            j: [k for k in around[j] if place[k] > place[j]] + [~body for body in stay if body in self.touched[j]]
            for j in order
        }
        tail = [*(~body for body in stay), *(j for j in part if not inner[j])]
        later |= {node: tail[k + 1 :] for k, node in enumerate(tail)}
        budget = UPDATES_A_ROW * sum(weights.values()) + 2000
        return later if _updates(later, weights | dict.fromkeys((~body for body in stay), 3)) <= budget else None

    def _factor(self, later: dict[int, list[int]], bounded: bool) -> Factor:
        """Columns of the factor and the pairs of rows that add to it. `later` are the nodes as they are eliminated."""
        stay = {~node for node in later if node < 0}
        rows, numbers = [], {}
        for node in later:
            slots = (0, 1, 2) if node < 0 else slots_of_joint(self.joints[node])
            sides = (~node,) if node < 0 else tuple(self._sides(self.joints[node]))
            numbers[node] = [len(rows) + k for k, slot in enumerate(slots) if slot in _without_shared(slots)]
            rows += [Row(max(node, -1), slot, sides) for slot in slots]
        pattern = Pattern()
        columns_below = [[numbers[k] for k in sorted(each, key=list(later).index)] for each in later.values()]
        entry = symbolic(list(numbers.values()), columns_below, pattern)
        ends = [*pattern.starts, len(pattern.row_of)]
        products: list[list[Product]] = [[] for _ in pattern.row_of]
        for node, after in later.items():
            for r in numbers[node]:
                for s in (s for k in (node, *after) for s in numbers[k] if s >= r):
                    products[entry[r, s]] += self._products(rows, r, s, stay)
        own = sorted(r for each in numbers.values() for r in each)
        of_row = dict(zip(own, pairwise(ends), strict=True))
        columns = [pattern.row_of[slice(*of_row.get(r, (0, 0)))] for r in range(len(rows))]
        return Factor(rows, columns, products, pattern.targets, bounded)

    def _products(self, rows: list[Row], r: int, s: int, stay: set[int]) -> list[Product]:
        if rows[r].joint < 0 or rows[s].joint < 0:
            return _of_body(rows, r, s)
        return [
            Product(s, b, r, a, body)
            for a, body in enumerate(rows[r].bodies)
            for b, other in enumerate(rows[s].bodies)
            if body == other and body >= 0 and self.movable[body] and body not in stay
        ]

    def _tables(self) -> NaiveWork:
        members, constraints = MEMBER.zeros(len(self.members)), CONSTRAINT.zeros(len(self.constraints))
        rows, parts = ROW.zeros(len(self.rows)), PART.zeros(len(self.parts))
        members.body, members.part = (list(column) for column in zip(*self.members, strict=True))
        members.start_cos = members.cos = 1.0
        seat_of = {j: k for k, j in enumerate(self.constraints)}
        part_of_seat = [
            n for n, part in enumerate(self.parts) for _ in range(part["first_constraint"], part["constraint_end"])
        ]
        for k, (row, j) in enumerate(zip(constraints, self.constraints, strict=True)):
            joint = self.joints[j]
            row.joint, row.part = j, part_of_seat[k]
            row.constraint_1, row.constraint_2 = seat_of.get(joint.joint_1, -1), seat_of.get(joint.joint_2, -1)
            row.member_a, row.member_b = (self.member_of[body] for body in self._sides(joint)[:2])
        for r, (constraint, slot, sides) in enumerate(self.rows):
            rows[r].constraint, rows[r].slot, rows[r].sides = constraint, slot, len(sides)
            for k, member in enumerate(sides):
                rows[r][f"member_{k + 1}"] = member
            if constraints[constraint].row_count == 0:
                constraints[constraint].first_row = r
            constraints[constraint].row_count += 1
        for row, fields in zip(parts, self.parts, strict=True):
            for name, value in fields.items():
                row[name] = value
        part_of = np.full(len(self.movable), -1, np.int64)
        part_of[members.body[1:]] = members.part[1:]
        lanes = lay_lanes(self.joints, members, constraints, parts)
        return NaiveWork(self.ties, part_of, members, constraints, rows, parts, lanes, self.factors)

    def pairs(self) -> tuple[list[Pair], list[Pair]]:
        """Pairs of bodies with a joint, and those of them that do not collide, both sorted."""
        tied: set[Pair] = set()
        bound: set[Pair] = set()
        for j in self.holding:
            sides = sorted({body for body in self._sides(self.joints[j]) if body >= 0})
            tied |= {(a, b) for a in sides for b in sides if a < b}
            if not self.joints[j].collide and int(self.joints[j].kind) != kinds.GEAR:
                bound |= {(a, b) for a in sides for b in sides if a < b}
        return sorted(tied), sorted(bound)


def _pair_table(pairs: Sequence[Pair]) -> Records:
    table = BOND.zeros(len(pairs))
    if pairs:
        table.low, table.high = (list(column) for column in zip(*pairs, strict=True))
    return table
