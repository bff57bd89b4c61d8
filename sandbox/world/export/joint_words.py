"""A joint as an entry of `joints`: as its author wrote it, but at the pose of now, from which a scene measures."""

from __future__ import annotations

from collections.abc import Container
from math import isinf
from typing import Any

import numpy as np

from sandbox.scene.joints import JOINTS, Joint
from sandbox.world.export.joint_geometry import write_geometry
from sandbox.world.export.joint_settings import put, settings
from sandbox.world.export.numbers import pair
from sandbox.world.export.present import Present
from sandbox.world.joint_records import KINDS

Words = dict[str, Any]


def joint_words(present: Present, row: int) -> Words:
    """The entry of a joint of now; only what has changed differs from the one that it came with."""
    words = _first_words(present, row)
    if present.rejoined[row]:
        joint = present.state.joints[row]
        kind = KINDS[int(joint.kind)]
        for name, value in settings(kind, joint):
            put(present, words, name, value)
        write_geometry(present, words, row)
    return words


def written_joint(present: Present, row: int) -> Joint:
    """The same as a model; it is the author's own object if nothing has changed."""
    pointer = present.state.census.joints.items[row].pointer
    if pointer.startswith("/joints/") and not present.rejoined[row]:
        return present.scene.joints[_number(pointer)]
    words = joint_words(present, row)
    return JOINTS[words["type"]](**words)


def lasting(present: Present) -> list[int]:
    """The rows of the joints that can be written down: those that hold something that moves, and gears on such."""
    joints = present.state.joints
    left: set[int] = set()
    for gears in (False, True):
        for row in np.flatnonzero((joints.joint_1 >= 0) == gears).tolist():
            reason = _why_not(present, joints[row], left)
            if reason:
                present.remarks.note(reason, present.state.joint_names[row])
            else:
                left.add(row)
    return sorted(left)


def _why_not(present: Present, joint: Any, left: Container[int]) -> str:
    """Why a joint cannot be written down; empty if it can. `left` are those that can."""
    if joint.broken_step >= 0:
        return "broken joints are left out"
    if joint.joint_1 >= 0:
        there = int(joint.joint_1) in left and int(joint.joint_2) in left
        return "" if there else "gears on joints that are left out are left out too"
    fixed = present.is_fixed(int(joint.body_a)) and present.is_fixed(int(joint.body_b))
    return "joints of bodies that are static now are left out" if fixed else ""


def _first_words(present: Present, row: int) -> Words:
    """The entry that a joint came with: written, a hinge of a chain, or spawned."""
    census = present.state.census.joints
    flat = census.items[row]
    if flat.pointer.startswith("/joints/"):
        return present.scene.joints[_number(flat.pointer)].to_data()
    if not flat.pointer:
        return dict(census.words[census.serials[row]])
    bodies = [flat.body_b] if flat.body_a is None else [flat.body_a, flat.body_b]
    words: Words = {"id": flat.id, "type": "revolute", "bodies": bodies, "anchor": pair(*flat.anchor_a)}
    if not isinf(flat.break_force):
        words["break_force"] = flat.break_force
    return {**words, "collide": True} if flat.collide else words


def _number(pointer: str) -> int:
    return int(pointer.rsplit("/", 1)[1])
