"""A body as an entry of `bodies`: as its author wrote it, but where it is now and as it moves."""

from __future__ import annotations

from collections.abc import Mapping
from math import atan2
from typing import Any

from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.body import Body
from sandbox.scene.generators import kind_of
from sandbox.scene.prefab import Prefab
from sandbox.world.export.numbers import degrees, fitted, pair, shortest
from sandbox.world.export.path_words import path_words
from sandbox.world.export.present import Motion, Present
from sandbox.world.export.shape_words import shape_words
from sandbox.world.export.thruster_words import thruster_words

Words = dict[str, Any]

_MOST = 1e6
"""Largest angle (degrees) that a scene may have."""


def body_words(present: Present, row: int) -> Words:
    """The entry of a body of now; only what has changed differs from the one that it came with."""
    words = _first_words(present, row)
    if present.changed[row]:
        pattern = _pattern(present, words)
        body, first = (motions[row] for motions in present.motions)
        if row in present.paths:
            given = words["path"] if "path" in words else pattern["path"]
            words["path"] = path_words(present, present.paths[row], given)
        else:
            for name, value in _motion(body, first).items():
                _put(present, words, pattern, name, value)
        if present.resurfaced[row]:
            words["shapes"] = shape_words(present, row, words, pattern)
        if present.rethrust[row]:
            given = words["thrusters"] if "thrusters" in words else pattern["thrusters"]
            words["thrusters"] = thruster_words(present, row, given)
        if body.type != first.type:
            _freeze(present, words, pattern)
    return words


def written(present: Present, row: int) -> Body:
    """The same as a model; it is the author's own object if nothing has changed."""
    pointer = present.state.census.bodies.items[row].pointer
    if pointer.startswith("/bodies/") and not present.changed[row]:
        return present.scene.bodies[_number(pointer)]
    return Body(**body_words(present, row))


def _first_words(present: Present, row: int) -> Words:
    """The entry that a body came with: written, made by a generator, or spawned."""
    census = present.state.census.bodies
    flat = census.items[row]
    if flat.pointer.startswith("/bodies/"):
        return present.scene.bodies[_number(flat.pointer)].to_data()
    if not flat.pointer:
        return dict(census.words[census.serials[row]])
    generator = present.scene.generate[_number(flat.pointer)]
    prefab: str = getattr(generator, kind_of(generator))
    words: Words = {"id": flat.id, "prefab": prefab, "position": pair(*flat.position)}
    if present.scene.prefabs[prefab].angle * RADIANS_PER_DEGREE != flat.angle:
        words["angle"] = degrees(flat.angle)
    return words


def _number(pointer: str) -> int:
    return int(pointer.rsplit("/", 1)[1])


def _pattern(present: Present, words: Words) -> Words:
    """What holds for the fields that an entry does not give, as data."""
    name = words.get("prefab")
    prefab = Prefab() if name is None else present.scene.prefabs[name]
    return prefab.model_dump(mode="json", exclude={"shapes", "thrusters", "path"}) | {
        "path": None if prefab.path is None else prefab.path.to_data(),
        "shapes": [shape.to_data() for shape in prefab.shapes],
        "thrusters": [thruster.to_data() for thruster in prefab.thrusters],
        "position": [0.0, 0.0],
    }


def _motion(body: Motion, first: Motion) -> Words:
    """The fields of place and motion that are others than at first."""
    found: Words = {}
    if (body.center_x, body.center_y) != (first.center_x, first.center_y) or body.angle != first.angle:
        found["position"] = _position(body)
    if body.angle != first.angle:
        found["angle"] = _angle(body)
    if (body.velocity_x, body.velocity_y) != (first.velocity_x, first.velocity_y):
        found["velocity"] = pair(body.velocity_x, body.velocity_y)
    if body.angular_velocity != first.angular_velocity:
        found["angular_velocity"] = degrees(body.angular_velocity)
    return found


def _angle(body: Motion) -> float:
    """Degrees; without whole turns if it has turned farther than a scene may say."""
    angle = degrees(body.angle)
    return angle if abs(angle) <= _MOST else degrees(atan2(body.rotation_sin, body.rotation_cos))


def _position(body: Motion) -> list[float]:
    """Where the origin is, m: so that the centre of mass comes to lie where it is, to the bit if that can be."""
    c, s, x, y = body.rotation_cos, body.rotation_sin, body.local_center_x, body.local_center_y
    right, up = c * x - s * y, s * x + c * y
    return [
        shortest(body.position_x, body.center_x, lambda found: found + right),
        shortest(body.position_y, body.center_y, lambda found: found + up),
    ]


def _put(present: Present, words: Words, pattern: Mapping[str, Any], name: str, value: Any) -> None:
    """Write a field, unless the pattern says the same."""
    inside = fitted(Body, name, value)
    if inside != value:
        present.remarks.note(f"{name} past the limit of scene files is cut to it", words["id"])
    words.pop(name, None)
    if inside != pattern[name]:
        words[name] = inside


def _freeze(present: Present, words: Words, pattern: Mapping[str, Any]) -> None:
    """What bad numbers have frozen is static."""
    present.remarks.note("bodies that bad numbers froze are static for good", words["id"])
    if "path" in words:
        words["path"] = {**words["path"], "enabled": False}  # it waits where it is
        return
    words["type"] = "static"
    if words.get("thrusters", pattern["thrusters"]):
        words["thrusters"] = []
