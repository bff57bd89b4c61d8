"""Reads the roster of a snapshot: nothing that it says is taken on trust."""

from __future__ import annotations

import json
from collections.abc import Callable
from itertools import pairwise
from typing import Any, TypeVar

from sandbox.errors import SceneError, SnapshotError
from sandbox.scene.flat import FlatBody, FlatJoint, FlatRegion, FlatScene
from sandbox.scene.known import Known
from sandbox.scene.spawned import Spawned
from sandbox.world.roster import Register, Roster, Words

T = TypeVar("T", bound=FlatBody | FlatJoint | FlatRegion)
Reader = Callable[[list[Any], list[Any], Known, str, list[Any]], Spawned]
"""`Spawning.read`."""
_DAMAGED = "the snapshot is damaged: it does not say who is behind its rows"


def read_roster(text: bytes, scene: FlatScene, read: Reader) -> Roster:
    """The roster behind `Roster.text`, for a world that began as `scene`. Raises `SnapshotError`."""
    if not text:
        return Roster.of(scene)
    try:
        plain = json.loads(text)
        bodies, joints, regions = parts = plain["bodies"], plain["joints"], plain["regions"]
        left = _left(bodies, scene.bodies), _left(joints, scene.joints), _left(regions, scene.regions)
        words = [[entry[1] for entry in part["spawned"]] for part in parts]
        found = read(words[0], words[1], _known(*left), "snapshot", words[2])
        return Roster(
            scene, _whole(left[0], bodies, found.bodies, found.body_words),
            _whole(left[1], joints, found.joints, found.joint_words),
            _whole(left[2], regions, found.regions, found.region_words),
        )  # fmt: skip
    except SceneError as error:
        raise SnapshotError(f"the snapshot has what this scene cannot have; {error}") from None
    except (ValueError, TypeError, LookupError, RecursionError):
        raise SnapshotError(_DAMAGED) from None


def _known(bodies: Register[FlatBody], joints: Register[FlatJoint], regions: Register[FlatRegion]) -> Known:
    """What those that are spawned may refer to, and whose ids they may not take."""
    types, kinds = {body.id: body.type for body in bodies.items}, {joint.id: joint.kind for joint in joints.items}
    return Known(types, kinds, regions=frozenset(filter(None, regions.names)), region_count=len(regions.items))


def _left(plain: Any, items: tuple[T, ...]) -> Register[T]:
    """What is left of the scene."""
    whole = Register.of(items)
    rows: list[int] = []
    for first, end in plain["left"]:
        if not (rows[-1] if rows else -1) < first < end <= len(items):
            raise SnapshotError(_DAMAGED)
        rows += range(first, end)
    return whole.only(rows)


def _whole(left: Register[T], plain: Any, items: tuple[T, ...], words: tuple[Words, ...]) -> Register[T]:
    """With what was spawned since."""
    serials = [entry[0] for entry in plain["spawned"]]
    order = [left.next - 1, *serials, plain["next"]]
    if not all(type(number) is int for number in order) or any(a >= b for a, b in pairwise(order)):
        raise SnapshotError(_DAMAGED)
    spawned = dict(zip(serials, words, strict=True))
    return Register((*left.items, *items), (*left.serials, *serials), spawned, plain["next"])
