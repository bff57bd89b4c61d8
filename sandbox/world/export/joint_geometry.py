"""Where a joint holds its bodies at the pose of now: anchors, axes, and all that is measured from that pose.

The entry of a file has one anchor for both bodies. Limits, rests and targets count from the pose in which a scene
begins, so they are shifted by what the joint has slid or turned since.
"""

from __future__ import annotations

from collections.abc import Callable
from math import hypot
from typing import Any

from sandbox.world.export.joint_settings import Angle, finite, put
from sandbox.world.export.numbers import pair
from sandbox.world.export.present import Present
from sandbox.world.joint_pose import anchor, angle_between, coordinate, joint_axis, pulley_length, slide

Words = dict[str, Any]
Vec = tuple[float, float]

TORN = 1e-3
"""A joint whose bodies are farther from where it wants them (m or rad) is torn, and a scene begins without that."""
BENT = 1e-6
"""A soft weld that is bent by more (m or rad) is written as a motor, which can say so."""


def write_geometry(present: Present, words: Words, row: int) -> None:
    """Put anchors, axes, lengths and shifted limits into the words of a joint."""
    _WRITERS[words["type"]](present, words, row)


def _revolute(present: Present, words: Words, row: int) -> None:
    joint, still = present.state.joints[row], bool(present.held_still[row])
    if not still:
        _pin(present, words, row)
    turned = 0.0 if still else angle_between(present.state, joint)
    _limits(present, words, joint, lambda value: Angle(value - turned))
    _rest(present, words, row, lambda value: Angle(value - turned))


def _sliding(present: Present, words: Words, row: int) -> None:
    joint, still = present.state.joints[row], bool(present.held_still[row])
    moved = 0.0
    if not still:
        state = present.state
        moved = slide(state, joint)
        x, y = joint_axis(state, joint)
        (ax, ay), (bx, by) = anchor(state, joint, "a"), anchor(state, joint, "b")
        on_axis = ax + moved * x, ay + moved * y
        place = on_axis if present.is_fixed(int(joint.body_a)) else (bx, by)
        turn = angle_between(state, joint) if words["type"] == "prismatic" else 0.0
        _note_torn(present, words, hypot(bx - on_axis[0], by - on_axis[1]), turn)
        put(present, words, "anchor", pair(*place))
        if present.moved[joint.body_a] or joint.axis_x != present.start.joints[row].axis_x:
            put(present, words, "axis", pair(x, y))
    _limits(present, words, joint, lambda value: value - moved)
    _rest(present, words, row, lambda value: value - moved)


def _weld(present: Present, words: Words, row: int) -> None:
    if present.held_still[row]:
        return
    state, joint = present.state, present.state.joints[row]
    (ax, ay), (bx, by) = anchor(state, joint, "a"), anchor(state, joint, "b")
    turn = angle_between(state, joint)
    stretched = joint.hertz > 0.0 and hypot(bx - ax, by - ay) > BENT
    bent = joint.angular_hertz > 0.0 and abs(turn) > BENT
    if not (stretched or bent):
        _pin(present, words, row, turn)
        return
    present.remarks.note("soft welds that are bent become motors that drive to where the welds hold", words["id"])
    names = ("hertz", "damping_ratio", "angular_hertz", "angular_damping_ratio")
    words |= {"type": "motor", "anchor": pair(bx, by), **{name: float(joint[name]) for name in names}}
    put(present, words, "offset", pair(ax - bx, ay - by))
    put(present, words, "angle", Angle(-turn))


def _motor(present: Present, words: Words, row: int) -> None:
    state, joint, first = present.state, present.state.joints[row], present.start.joints[row]
    still = bool(present.held_still[row])
    (ax, ay), (bx, by) = anchor(state, joint, "a"), anchor(state, joint, "b")
    if not still:
        put(present, words, "anchor", pair(bx, by))
    if not still or (joint.point_ax, joint.point_ay) != (first.point_ax, first.point_ay):
        x, y = _turned(present, int(joint.body_a), float(joint.point_ax), float(joint.point_ay))
        put(present, words, "offset", pair(ax + x - bx, ay + y - by))
    if not still or joint.rest != first.rest:
        put(present, words, "angle", Angle(float(joint.rest) - angle_between(state, joint)))


def _target(present: Present, words: Words, row: int) -> None:
    joint = present.state.joints[row]
    if not present.held_still[row]:
        put(present, words, "anchor", pair(*anchor(present.state, joint, "b")))
    put(present, words, "target", pair(joint.point_ax, joint.point_ay))


def _friction(present: Present, words: Words, row: int) -> None:
    if not present.held_still[row]:
        put(present, words, "anchor", pair(*anchor(present.state, present.state.joints[row], "b")))


def _distance(present: Present, words: Words, row: int) -> None:
    joint, still = present.state.joints[row], bool(present.held_still[row])
    if not still:
        _anchors(present, words, joint)
    needed = not still and ("length" in words or joint.spring or not joint.limit)
    if needed or joint.length != present.start.joints[row].length:
        put(present, words, "length", float(joint.length))
    _limits(present, words, joint, float, ("min", "max"))


def _pulley(present: Present, words: Words, row: int) -> None:
    if present.held_still[row]:
        return
    state, joint = present.state, present.state.joints[row]
    _anchors(present, words, joint)
    length = pulley_length(state, joint, "a") + joint.ratio * pulley_length(state, joint, "b")
    _note_torn(present, words, float(length - joint.length))


def _gear(present: Present, words: Words, row: int) -> None:
    state, joint = present.state, present.state.joints[row]
    one, two = (coordinate(state, state.joints[joint[name]]) for name in ("joint_1", "joint_2"))
    _note_torn(present, words, float(one + joint.ratio * two - joint.length))


_WRITERS: dict[str, Callable[[Present, Words, int], None]] = {
    "distance": _distance, "revolute": _revolute, "prismatic": _sliding, "weld": _weld, "wheel": _sliding,
    "gear": _gear, "pulley": _pulley, "motor": _motor, "target": _target, "friction": _friction,
}  # fmt: skip


def _pin(present: Present, words: Words, row: int, turn: float = 0.0) -> None:
    """One anchor for both bodies: on the one that stays where it is, else between what are their anchors now."""
    joint = present.state.joints[row]
    (ax, ay), (bx, by) = anchor(present.state, joint, "a"), anchor(present.state, joint, "b")
    _note_torn(present, words, hypot(bx - ax, by - ay), turn)
    fixed_a, fixed_b = present.is_fixed(int(joint.body_a)), present.is_fixed(int(joint.body_b))
    share = 0.0 if fixed_a else 1.0 if fixed_b else 0.5
    put(present, words, "anchor", pair(ax + share * (bx - ax), ay + share * (by - ay)))


def _anchors(present: Present, words: Words, joint: Any) -> None:
    put(present, words, "anchors", [pair(*anchor(present.state, joint, side)) for side in "ab"])


def _limits(
    present: Present, words: Words, joint: Any, shifted: Callable[[float], Any], names: Vec | Any = ("lower", "upper")
) -> None:
    for name, column in zip(names, ("lower", "upper"), strict=True):
        limit = finite(joint[column]) if joint.limit else None
        put(present, words, name, None if limit is None else shifted(limit))


def _rest(present: Present, words: Words, row: int, shifted: Callable[[float], Any]) -> None:
    """Where a spring pulls to; a rest that nobody asked for stays unsaid."""
    joint = present.state.joints[row]
    if joint.spring or "rest" in words or joint.rest != present.start.joints[row].rest:
        put(present, words, "rest", shifted(float(joint.rest)))


def _turned(present: Present, body: int, x: float, y: float) -> Vec:
    """A direction in the frame of a body, in the world."""
    if body < 0:
        return x, y
    row: Any = present.state.bodies[body]
    c, s = float(row.rotation_cos), float(row.rotation_sin)
    return c * x - s * y, s * x + c * y


def _note_torn(present: Present, words: Words, gap: float, turn: float = 0.0) -> None:
    if max(abs(gap), abs(turn)) > TORN:
        present.remarks.note("torn joints begin with their bodies where they are now", words["id"])
