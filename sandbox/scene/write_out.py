"""A scene without prefabs and generators: every body and hinge written out, as plain data of a file."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sandbox.scene.arrange import Placing, chain_step, placings
from sandbox.scene.flat import FlatJoint, FlatShape
from sandbox.scene.flat_joints import chain_joints
from sandbox.scene.generators import Chain, Generator, body_names, kind_of
from sandbox.scene.plain import spawns
from sandbox.scene.prefab import Prefab
from sandbox.scene.scene import Scene

Words = dict[str, Any]


def written_out(scene: Scene) -> Words:
    """The data of a scene that comes down to the same flat scene, with all bodies and joints listed in their order.

    What rules and controls bring no longer names a prefab either. Raises `SceneError` if the scene has mistakes.
    """
    data = scene.to_data()
    data.pop("vars", None)
    prefabs: Words = data.pop("prefabs", {})
    generators = data.pop("generate", [])
    for _, entry in spawns(data):
        entry.update(_merged(prefabs, entry))
        entry.pop("prefab", None)
    bodies = [_merged(prefabs, entry) for entry in data.get("bodies", [])]
    joints: list[Words] = data.get("joints", [])
    shapes_of = {body.id: body.shapes for body in scene.flatten().bodies}
    for number, generator in enumerate(scene.generate):
        shapes = shapes_of[body_names(generator)[0]]
        prefab = generators[number][kind_of(generator)]
        bodies += _bodies(generator, scene.prefabs[prefab], prefabs[prefab], shapes)
        joints += _hinges(generator, number, shapes)
    lists = {"bodies": bodies, "joints": joints}
    order = dict.fromkeys([*data, *lists]) if generators else dict.fromkeys(data)
    return {key: lists.get(key, data.get(key)) for key in order if key in data or lists.get(key)}


def _merged(prefabs: Words, entry: Words) -> Words:
    """A body's own words before those of its prefab. Thrusters of a prefab push nothing that is not dynamic."""
    words = {key: value for key, value in entry.items() if key != "prefab"}
    given = prefabs.get(entry.get("prefab", ""), {})
    merged = words | {key: value for key, value in given.items() if key not in words}
    if merged.get("type", "dynamic") != "dynamic":
        merged.pop("thrusters", None)
    return merged


def _bodies(generator: Generator, prefab: Prefab, words: Words, shapes: tuple[FlatShape, ...]) -> Iterator[Words]:
    places: list[Placing] = placings(generator, shapes, prefab.angle)
    for name, (x, y, degrees) in zip(body_names(generator), places, strict=True):
        turned = {} if degrees is None else {"angle": degrees}
        yield {"id": name, "position": [x, y], **words, **turned}


def _hinges(generator: Generator, number: int, shapes: tuple[FlatShape, ...]) -> Iterator[Words]:
    if isinstance(generator, Chain):
        own = generator.to_data()
        shared: Words = {key: own[key] for key in ("collide", "break_force") if key in own}
        for joint in chain_joints(generator, chain_step(generator, shapes), number):
            yield {**_hinge(joint), **shared}


def _hinge(joint: FlatJoint) -> Words:
    return {
        "id": joint.id,
        "type": "revolute",
        "bodies": [joint.body_a, joint.body_b],
        "anchor": list(joint.anchor_a),
    }
