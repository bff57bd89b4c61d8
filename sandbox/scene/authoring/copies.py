"""Puts one copy of a prefab into a scene."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from sandbox.scene.authoring.document import Written
from sandbox.scene.authoring.evaluate import Numbers
from sandbox.scene.authoring.frame import HERE, Entry, Frame, placed_body, placed_joint
from sandbox.scene.authoring.prefabs import Parameters, Prefabs
from sandbox.scene.flat_joints import chain_joints
from sandbox.scene.generators import Chain
from sandbox.scene.plain import is_several

_TURNING = ("angle", "velocity", "path")
ONE = 10
"""Values that a copy takes beside what is in it."""
_NESTED = 60
"""As long as so many values takes a generator in a copy, which is read anew for each."""


@dataclass(frozen=True)
class Setting:
    """Where generators stand: in the scene, or in a prefab, a copy of which `prefix` names.

    `asked` is the entry of the scene that brought it about, `nesting` the prefabs that it is in.
    """

    known: Numbers
    frame: Frame = HERE
    prefix: str = ""
    asked: Written | None = None
    nesting: tuple[str, ...] = ()

    def named(self, name: Any) -> str:
        """An id as it is in the scene."""
        return f"{self.prefix}.{name}" if self.prefix else str(name)


@dataclass(frozen=True)
class Copy:
    """One copy of a prefab: its parameters, its id, and where it is; it `keeps_angle` of the prefab besides."""

    prefab: str
    parameters: Parameters
    id: str
    frame: Frame
    keeps_angle: bool = True


Nested = list[tuple[Written, Setting]]
"""Generators that stand in a prefab, and where."""


def put_copy(prefabs: Prefabs, copy: Copy, setting: Setting) -> Nested:
    """Put one copy into the output; the generators in it are left to be worked through."""
    output = prefabs.output
    assert setting.asked is not None
    output.spend(ONE, setting.asked)
    if is_several(prefabs.written[copy.prefab].value):
        return _several(prefabs, copy, replace(setting, frame=copy.frame, prefix=copy.id))
    single = prefabs.single(copy.prefab, copy.parameters)
    base = output.prefabs[single]
    own = {key: base[key] for key in _TURNING if key in base and (copy.keeps_angle or key != "angle")}
    body = placed_body({"id": copy.id, "prefab": single, **own}, copy.frame)
    if not copy.keeps_angle:
        body["angle"] = copy.frame.degrees
    output.add_body(body, setting.asked, setting.asked)
    return []


def _several(prefabs: Prefabs, copy: Copy, setting: Setting) -> Nested:
    template, output = prefabs.template(copy.prefab, copy.parameters), prefabs.output
    assert setting.asked is not None
    output.spend(template.size + _NESTED * len(template.generate), setting.asked)
    for body, part in template.bodies:
        output.add_body(_renamed(placed_body(body, setting.frame), setting), part, setting.asked)
    for joint, part in template.joints:
        output.add_joint(_renamed(placed_joint(joint, setting.frame), setting), part, setting.asked)
    inner = replace(setting, known=template.known, nesting=(*setting.nesting, copy.prefab))
    return [(nested, inner) for nested in template.generate]


def put_hinges(prefabs: Prefabs, chain: Chain, written: Written, setting: Setting) -> None:
    """Put the hinges of a chain, whose bodies are there, into the output."""
    assert chain.step is not None
    assert setting.asked is not None
    for flat in chain_joints(chain, chain.step, 0):
        joint: Entry = {"id": flat.id, "type": "revolute", "bodies": [flat.body_a, flat.body_b]}
        joint |= {"anchor": flat.anchor_a, "collide": chain.collide}
        joint |= {} if chain.break_force is None else {"break_force": chain.break_force}
        prefabs.output.add_joint(placed_joint(joint, setting.frame), written, setting.asked)


def _renamed(entry: Entry, setting: Setting) -> Entry:
    """An entry of a prefab with all its ids those of one copy."""
    renamed: Entry = {"id": setting.named(entry["id"])} if isinstance(entry.get("id"), str) else {}
    for key in ("bodies", "joints"):
        if isinstance(entry.get(key), (list, tuple)):
            renamed[key] = [setting.named(one) if isinstance(one, str) else one for one in entry[key]]
    return {**entry, **renamed}
