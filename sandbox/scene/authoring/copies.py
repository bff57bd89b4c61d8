"""Puts copies of prefabs into a scene, those of several bodies and those whose parameters differ from copy to copy."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from pydantic import ConfigDict, TypeAdapter, ValidationError

from sandbox.scene.arrange import placings
from sandbox.scene.authoring.arithmetic import INDICES
from sandbox.scene.authoring.document import Written
from sandbox.scene.authoring.evaluate import Numbers
from sandbox.scene.authoring.expression import is_expression, parsed
from sandbox.scene.authoring.frame import HERE, Entry, Frame, placed_body, placed_joint
from sandbox.scene.authoring.mistake import ExpressionError
from sandbox.scene.authoring.prefabs import Parameters, Prefabs
from sandbox.scene.finding import quoted
from sandbox.scene.flat_joints import chain_joints
from sandbox.scene.generators import GENERATORS, AnyGenerator, Chain, Generator, Place, body_names, spacing_field
from sandbox.scene.limits import MAX_NESTING
from sandbox.scene.near_names import did_you_mean
from sandbox.scene.plain import is_several

_GENERATOR: TypeAdapter[Generator] = TypeAdapter(AnyGenerator, config=ConfigDict(defer_build=True))
_SAMPLE = dict.fromkeys(INDICES, 1.0)
_TURNING = ("angle", "velocity", "path")
_ONE = 8
"""Values that a copy of one body takes."""


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
class Copies:
    """Works through generators; what they make goes to the output of the prefabs."""

    prefabs: Prefabs

    def generate(self, written: Written, setting: Setting) -> None:
        """What one generator makes, or the generator itself where it need not be worked out here."""
        entry = written.value
        kinds = [kind for kind in GENERATORS if isinstance(entry, dict) and kind in entry]
        name = entry[kinds[0]] if len(kinds) == 1 else None
        prefab = self.prefabs.written.get(name) if isinstance(name, str) else None
        if prefab is None or not isinstance(prefab.value, dict) or not isinstance(entry.get("params", {}), dict):
            self._keep(written, setting, written.at(kinds[0]) if kinds else written)
            return
        if not self._is_sound(str(name), written.at(kinds[0]), setting):
            return
        model = self._model(written, setting)
        if model is None:
            self._keep(written, setting, written)
        elif isinstance(model, Place):
            self._place(model, written, replace(setting, asked=setting.asked or written))
        elif setting.prefix or is_several(prefab.value) or _varies(entry.get("params")):
            self._spread(model, written, replace(setting, asked=setting.asked or written))
        else:
            parameters = self.prefabs.parameters(str(name), written, setting.known)
            kept = {**self._resolved(written, setting.known), kinds[0]: self.prefabs.single(str(name), parameters)}
            self.prefabs.output.add_generator({key: kept[key] for key in kept if key != "params"}, written)

    def _resolved(self, written: Written, known: Numbers) -> Entry:
        found: Entry = self.prefabs.evaluator.resolved(written, known)
        return found

    def _keep(self, written: Written, setting: Setting, named: Written) -> None:
        """Leave a generator with mistakes to the models; of one in a prefab the prefab itself is told."""
        if not setting.prefix:
            known = {**setting.known, **_SAMPLE}
            self.prefabs.output.add_generator(self.prefabs.evaluator.resolved(written, known), written)
        elif isinstance(named.value, str) and named.value not in self.prefabs.written:
            text = f"no prefab is named {quoted(named.value)}"
            hint = did_you_mean(named.value, self.prefabs.written)
            self.prefabs.output.faults.append(named.fault(text, hint))

    def _is_sound(self, name: str, named: Written, setting: Setting) -> bool:
        """Whether prefabs end somewhere."""
        if name in setting.nesting:
            told = " > ".join([*setting.nesting[setting.nesting.index(name) :], name])
            self.prefabs.output.faults.append(named.fault(f"these prefabs contain each other: {told}"))
        elif len(setting.nesting) >= MAX_NESTING:
            self.prefabs.output.faults.append(named.fault(f"prefabs in prefabs, deeper than {MAX_NESTING} levels"))
        else:
            return True
        return False

    def _model(self, written: Written, setting: Setting) -> Generator | None:
        """The generator as the first copy sees it, under its full id; None if it has mistakes of its own."""
        counts = "place" not in written.value or "count" in written.value
        sample = self._resolved(written, {**setting.known, **_SAMPLE} if counts else setting.known)
        try:
            found = _GENERATOR.validate_python(sample)
            return _GENERATOR.validate_python({**sample, "id": setting.named(found.id)})
        except ValidationError:
            return None

    def _place(self, model: Place, written: Written, setting: Setting) -> None:
        """Copies that each say where they stand."""
        pose = Written(written.document, written.path, {key: written.value.get(key) for key in ("at", "angle")})
        for number, name in enumerate(body_names(model), 1):
            counted = {} if model.count is None else {"i": float(number)}
            known = {**setting.known, **counted}
            at = self._resolved(pose, known)
            x, y = at["at"] or (0.0, 0.0)
            frame = Frame(x, y, at["angle"] or 0.0)
            self._copy(model.place, written, replace(setting, known=known, prefix=name), frame.within(setting.frame))

    def _spread(self, model: Generator, written: Written, setting: Setting) -> None:
        """Copies that stand where the generator says."""
        kind = next(kind for kind in GENERATORS if kind in written.value)
        name = written.value[kind]
        several = is_several(self.prefabs.written[name].value)
        field = spacing_field(model)
        if several and isinstance(model, Chain):
            text = f"a chain links bodies, and the prefab {quoted(name)} has several"
            self.prefabs.output.faults.append(written.at(kind).fault(text))
            return
        if getattr(model, field) is None:
            text = f'"{field}" is needed: neighbours just touch only where all are the same single body'
            self.prefabs.output.faults.append(written.fault(text))
            return
        places = placings(model, (), 0.0)
        for (x, y, degrees), counted, copy in zip(places, _counted(model), body_names(model), strict=False):
            inner = replace(setting, known={**setting.known, **counted}, prefix=copy)
            frame = Frame(x, y, degrees or 0.0).within(setting.frame)
            self._copy(name, written, inner, frame, keeps_angle=degrees is None)
        if isinstance(model, Chain):
            self._hinges(model, written, setting)

    def _hinges(self, chain: Chain, written: Written, setting: Setting) -> None:
        assert chain.step is not None
        assert setting.asked is not None
        for flat in chain_joints(chain, chain.step, 0):
            joint: Entry = {"id": flat.id, "type": "revolute", "bodies": [flat.body_a, flat.body_b]}
            joint |= {"anchor": flat.anchor_a, "collide": chain.collide}
            joint |= {} if chain.break_force is None else {"break_force": chain.break_force}
            self.prefabs.output.add_joint(placed_joint(joint, setting.frame), written, setting.asked)

    def _copy(self, name: str, written: Written, setting: Setting, frame: Frame, keeps_angle: bool = True) -> None:
        """One copy of a prefab, under the id `setting.prefix`."""
        parameters = self.prefabs.parameters(name, written, setting.known)
        if is_several(self.prefabs.written[name].value):
            self._several(name, parameters, written, replace(setting, frame=frame))
            return
        assert setting.asked is not None
        single = self.prefabs.single(name, parameters)
        base = self.prefabs.output.prefabs[single]
        own = {key: base[key] for key in _TURNING if key in base and (keeps_angle or key != "angle")}
        self.prefabs.output.spend(_ONE, setting.asked)
        body = placed_body({"id": setting.prefix, "prefab": single, **own}, frame)
        if not keeps_angle:
            body["angle"] = frame.degrees
        self.prefabs.output.add_body(body, setting.asked, setting.asked)

    def _several(self, name: str, parameters: Parameters, written: Written, setting: Setting) -> None:
        template, output = self.prefabs.template(name, parameters), self.prefabs.output
        assert setting.asked is not None
        output.spend(template.size, setting.asked)
        for body, part in template.bodies:
            output.add_body(_renamed(placed_body(body, setting.frame), setting), part, setting.asked)
        for joint, part in template.joints:
            output.add_joint(_renamed(placed_joint(joint, setting.frame), setting), part, setting.asked)
        inner = replace(setting, known=template.known, nesting=(*setting.nesting, name))
        for nested in template.generate:
            self.generate(nested, inner)


def _varies(params: object) -> bool:
    """Whether parameters differ from copy to copy."""
    texts = params.values() if isinstance(params, dict) else ()
    try:
        return any(parsed(text).names & {*INDICES} for text in texts if is_expression(text))
    except ExpressionError:
        return False


def _renamed(entry: Entry, setting: Setting) -> Entry:
    """An entry of a prefab with all its ids those of one copy."""
    renamed: Entry = {"id": setting.named(entry["id"])} if isinstance(entry.get("id"), str) else {}
    for key in ("bodies", "joints"):
        if isinstance(entry.get(key), (list, tuple)):
            renamed[key] = [setting.named(one) if isinstance(one, str) else one for one in entry[key]]
    return {**entry, **renamed}


def _counted(model: Generator) -> Iterator[Mapping[str, float]]:
    """The numbers that the parameters of each copy may ask for."""
    for number, name in enumerate(body_names(model), 1):
        place = name.removeprefix(model.id + "-").split("-")
        both = {"row": float(place[0]), "column": float(place[1])} if len(place) == 2 else {}
        yield {"i": float(number), **both}
