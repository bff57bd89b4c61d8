"""Bodies and joints that come into a running world, in the words of a scene file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from pydantic import ValidationError

from sandbox.scene.base import Model
from sandbox.scene.finding import Finding
from sandbox.scene.flat import FlatBody, FlatJoint
from sandbox.scene.flatten import Flattener
from sandbox.scene.known import Known
from sandbox.scene.limits import MAX_JOINTS
from sandbox.scene.report import scene_error
from sandbox.scene.rules import cross_checks
from sandbox.scene.scene import Scene
from sandbox.scene.wording import findings

_SHARED = ("categories", "materials", "prefabs")


@dataclass(frozen=True)
class Spawned:
    """Flat bodies and joints, and for each the entry that it can be read from again, as a file holds it."""

    bodies: tuple[FlatBody, ...]
    joints: tuple[FlatJoint, ...]
    body_words: tuple[dict[str, Any], ...]
    joint_words: tuple[dict[str, Any], ...]


class Spawning:
    """Reads entries of `bodies` and `joints` with the prefabs, materials and categories of one scene."""

    def __init__(self, scene: Scene | None) -> None:
        self._parts: dict[str, Any] = {name: getattr(scene, name) for name in _SHARED} if scene else {}
        self._plain = scene.model_dump(mode="json", exclude_unset=True, include=set(_SHARED)) if scene else {}

    def read(self, bodies: Sequence[Any], joints: Sequence[Any], known: Known, source: str) -> Spawned:
        """Read bodies and joints that may refer to each other and to what is `known`.

        Raises `SceneError` with every mistake and its place, such as `/bodies/0/shapes`; `source` begins the message.
        """
        data = {"bodies": bodies, "joints": joints}
        found = [*cross_checks({**self._plain, **data}, known), *_too_many(joints, known)]
        try:
            scene = Scene.model_validate({**self._parts, **data})
        except ValidationError as error:
            raise scene_error(source, findings(error, Scene) + found, None) from None
        return _flat(scene, known, source, found)


def _too_many(joints: object, known: Known) -> list[Finding]:
    total = len(known.kinds) + (len(joints) if isinstance(joints, (list, tuple)) else 0)
    text = f"the world would have {total} joints; {MAX_JOINTS} is the limit"
    return [Finding(("joints",), text)] if total > MAX_JOINTS else []


def _flat(scene: Scene, known: Known, source: str, found: list[Finding]) -> Spawned:
    if not found:
        flattener = Flattener(scene, known)
        flat = flattener.flat()
        found = flattener.findings
    if found:
        raise scene_error(source, found, None)
    bodies = tuple(replace(body, pointer="") for body in flat.bodies)
    joints = tuple(replace(joint, pointer="") for joint in flat.joints)
    return Spawned(bodies, joints, _words(scene.bodies), _words(scene.joints))


def _words(parts: Sequence[Model]) -> tuple[dict[str, Any], ...]:
    return tuple(part.to_data() for part in parts)
