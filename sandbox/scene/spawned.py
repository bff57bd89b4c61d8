"""Bodies, joints and regions that come into a running world, in the words of a scene file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from itertools import chain
from typing import Any

from pydantic import ValidationError

from sandbox.scene.base import Model
from sandbox.scene.effort import one_effort
from sandbox.scene.finding import Finding
from sandbox.scene.flat import FlatBody, FlatJoint, FlatRegion
from sandbox.scene.flat_joints import joint_faults
from sandbox.scene.flatten import Flattener
from sandbox.scene.joint_references import joint_references
from sandbox.scene.known import Known
from sandbox.scene.limits import MAX_BODIES, MAX_JOINTS, MAX_REGIONS, MAX_SHAPES
from sandbox.scene.names import BodyNames
from sandbox.scene.report import scene_error
from sandbox.scene.rules import cross_checks
from sandbox.scene.scene import Scene
from sandbox.scene.templates import Templates
from sandbox.scene.wording import findings

_SHARED = ("categories", "materials", "prefabs")


@dataclass(frozen=True)
class Spawned:
    """Flat bodies, joints and regions, and for each the entry that it can be read from again, as a file holds it."""

    bodies: tuple[FlatBody, ...]
    joints: tuple[FlatJoint, ...]
    body_words: tuple[dict[str, Any], ...]
    joint_words: tuple[dict[str, Any], ...]
    regions: tuple[FlatRegion, ...] = ()
    region_words: tuple[dict[str, Any], ...] = ()

    @classmethod
    def joined(cls, parts: Sequence[Spawned]) -> Spawned:
        """Some of them, one after the other."""
        if len(parts) == 1:
            return parts[0]
        return cls(*(tuple(chain.from_iterable(getattr(part, item.name) for part in parts)) for item in fields(cls)))


class Spawning:
    """Reads entries of `bodies`, `joints` and `regions` with the prefabs, materials and categories of one scene."""

    def __init__(self, scene: Scene | None) -> None:
        self._parts: dict[str, Any] = {name: getattr(scene, name) for name in _SHARED} if scene else {}
        self._templates = Templates()
        self._plain = scene.model_dump(mode="json", exclude_unset=True, include=set(_SHARED)) if scene else {}

    @one_effort()
    def read(
        self, bodies: Sequence[Any], joints: Sequence[Any], known: Known, source: str, regions: Sequence[Any] = ()
    ) -> Spawned:
        """Read regions, and bodies and joints that may refer to each other and to what is `known`.

        Raises `SceneError` with every mistake and its place, such as `/bodies/0/shapes`; `source` begins the message.
        """
        spawned = None if regions else self.read_known(bodies, joints, known)
        if spawned is not None:
            return spawned
        data = {"bodies": bodies, "joints": joints, **({"regions": regions} if regions else {})}
        found = [*cross_checks({**self._plain, **data}, known), *_too_many("joints", joints, known)]
        found += _too_many("regions", regions, known)
        try:
            scene = Scene.model_validate({**self._parts, **data})
        except ValidationError as error:
            raise scene_error(source, findings(error, Scene) + found, None) from None
        spawned = _flat(scene, known, source, found)
        self._templates.learn(bodies, spawned.bodies, spawned.body_words)
        return spawned

    def read_known(self, bodies: Any, joints: Any, known: Known) -> Spawned | None:
        """The same for bodies of known templates; None unless nothing is wrong."""
        if not (isinstance(bodies, (list, tuple)) and isinstance(joints, (list, tuple))):
            return None
        found = self._templates.read(bodies)
        if found is None:
            return None
        flat, words = tuple(body for body, _ in found), tuple(entry for _, entry in found)
        ids = BodyNames({body.id: () for body in flat}, known=known.types)
        fits = known.shapes + sum(len(body.shapes) for body in flat) <= MAX_SHAPES
        if not fits or len(known.types) + len(flat) > MAX_BODIES or len(ids.origins) < len(flat):
            return None
        if any(body.id in known.types for body in flat):
            return None
        if not joints:
            return Spawned(flat, (), words, ())
        held = _joints(joints, flat, ids, known)
        return None if held is None else Spawned(flat, held[0], words, held[1])


def _joints(
    entries: Any, bodies: Sequence[FlatBody], ids: BodyNames, known: Known
) -> tuple[tuple[FlatJoint, ...], tuple[dict[str, Any], ...]] | None:
    """Joints and their words; None unless nothing is wrong with any of them."""
    try:
        scene = Scene.model_validate({"joints": entries})
    except ValidationError:
        return None
    if _too_many("joints", entries, known) or any(joint_references({"joints": entries}, ids, known.kinds)):
        return None
    flat = tuple(joint.flat() for joint in scene.joints)
    return None if any(joint_faults(flat, bodies, known)) else (flat, _words(scene.joints))


def _too_many(what: str, entries: object, known: Known) -> list[Finding]:
    there, most = {"joints": (len(known.kinds), MAX_JOINTS), "regions": (known.region_count, MAX_REGIONS)}[what]
    total = there + (len(entries) if isinstance(entries, (list, tuple)) else 0)
    text = f"the world would have {total} {what}; {most} is the limit"
    return [Finding((what,), text)] if total > most else []


def _flat(scene: Scene, known: Known, source: str, found: list[Finding]) -> Spawned:
    if not found:
        flattener = Flattener(scene, known)
        flat = flattener.flat()
        found = flattener.findings
    if found:
        raise scene_error(source, found, None)
    bodies = tuple(replace(body, pointer="") for body in flat.bodies)
    joints = tuple(replace(joint, pointer="") for joint in flat.joints)
    words = _words(scene.bodies), _words(scene.joints)
    return Spawned(bodies, joints, *words, flat.regions, _words(scene.regions))


def _words(parts: Sequence[Model]) -> tuple[dict[str, Any], ...]:
    return tuple(part.to_data() for part in parts)
