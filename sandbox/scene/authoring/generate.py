"""Works through generators: copies of prefabs of several bodies, and copies that differ."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

from pydantic import ConfigDict, TypeAdapter, ValidationError

from sandbox.scene.arrange import placings
from sandbox.scene.authoring.arithmetic import INDICES
from sandbox.scene.authoring.copies import ONE, Copy, Setting, put_copy, put_hinges
from sandbox.scene.authoring.document import Written
from sandbox.scene.authoring.evaluate import Numbers
from sandbox.scene.authoring.expression import is_expression, parsed
from sandbox.scene.authoring.frame import Entry, Frame
from sandbox.scene.authoring.least_bodies import least_bodies
from sandbox.scene.authoring.mistake import ExpressionError
from sandbox.scene.authoring.output import TooMuchError
from sandbox.scene.authoring.prefabs import Parameters, Prefabs
from sandbox.scene.authoring.variables import way_round
from sandbox.scene.finding import quoted
from sandbox.scene.generators import (
    GENERATORS,
    AnyGenerator,
    Chain,
    Generator,
    Place,
    body_count,
    body_names,
    kind_of,
    spacing_field,
)
from sandbox.scene.limits import MAX_NESTING
from sandbox.scene.near_names import did_you_mean
from sandbox.scene.plain import is_several

_GENERATOR: TypeAdapter[Generator] = TypeAdapter(AnyGenerator, config=ConfigDict(defer_build=True))
_SAMPLE = dict.fromkeys(INDICES, 1.0)


@dataclass(frozen=True)
class Generators:
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
            return
        self.prefabs.output.is_whole = False
        if isinstance(named.value, str) and named.value not in self.prefabs.written:
            text = f"no prefab is named {quoted(named.value)}"
            hint = did_you_mean(named.value, self.prefabs.written)
            self.prefabs.output.faults.append(named.fault(text, hint))

    def _is_sound(self, name: str, named: Written, setting: Setting) -> bool:
        """Whether prefabs end somewhere."""
        if name in setting.nesting:
            told = way_round(setting.nesting[setting.nesting.index(name) :])
            self._refuse(named, f"these prefabs contain each other: {told}")
        elif len(setting.nesting) >= MAX_NESTING:
            self._refuse(named, f"prefabs in prefabs, deeper than {MAX_NESTING} levels")
            raise TooMuchError  # every copy would say so again
        else:
            return True
        return False

    def _model(self, written: Written, setting: Setting) -> Generator | None:
        """The generator as the first copy sees it, under its full id; None if it has mistakes of its own."""
        counts = "count" in written.value or not written.value.keys() <= Place.model_fields.keys()
        sample = self._resolved(written, {**setting.known, **_SAMPLE} if counts else setting.known)
        try:
            found = _GENERATOR.validate_python(sample)
            return _GENERATOR.validate_python({**sample, "id": setting.named(found.id)})
        except ValidationError:
            return None

    def _place(self, model: Place, written: Written, setting: Setting) -> None:
        """Copies that each say where they stand."""
        pose = Written(written.document, written.path, {key: written.value.get(key) for key in ("at", "angle")})
        fill = self._filling(model.place, written, setting)
        self._ask_room(model.place, body_count(model), setting)
        for number, name in enumerate(body_names(model), 1):
            counted = {} if model.count is None else {"i": float(number)}
            at = self._resolved(pose, {**setting.known, **counted})
            x, y = at["at"] or (0.0, 0.0)
            frame = Frame(x, y, at["angle"] or 0.0).within(setting.frame)
            self._put(Copy(model.place, fill(counted), name, frame), setting)

    def _spread(self, model: Generator, written: Written, setting: Setting) -> None:
        """Copies that stand where the generator says."""
        kind = kind_of(model)
        name: str = written.value[kind]
        field = spacing_field(model)
        if is_several(self.prefabs.written[name].value) and isinstance(model, Chain):
            text = f"a chain links bodies, and the prefab {quoted(name)} has several"
            self._refuse(written.at(kind), text)
            return
        if getattr(model, field) is None:
            text = f'"{field}" is needed: neighbours just touch only where all are the same single body'
            self._refuse(written.at(kind), text)
            return
        fill = self._filling(name, written, setting)
        self._ask_room(name, body_count(model), setting)
        places = placings(model, (), 0.0)
        for (x, y, degrees), counted, copy in zip(places, _counted(model), body_names(model), strict=False):
            frame = Frame(x, y, degrees or 0.0).within(setting.frame)
            self._put(Copy(name, fill(counted), copy, frame, degrees is None), setting)
        if isinstance(model, Chain):
            put_hinges(self.prefabs, model, written, setting)

    def _refuse(self, named: Written, text: str) -> None:
        """Make nothing, so that nobody knows what there would be."""
        self.prefabs.output.faults.append(named.fault(text))
        self.prefabs.output.is_whole = False

    def _filling(self, name: str, written: Written, setting: Setting) -> Callable[[Numbers], Parameters]:
        """The parameters of each copy, by the numbers that count it."""
        if _varies(written.value.get("params")):
            return lambda counted: self.prefabs.parameters(name, written, {**setting.known, **counted})
        same = self.prefabs.parameters(name, written, setting.known)
        return lambda counted: same

    def _ask_room(self, name: str, count: int, setting: Setting) -> None:
        """Refuse copies that are too many before one is made."""
        assert setting.asked is not None
        self.prefabs.output.ask_values(count * ONE, setting.asked)
        least = least_bodies(self.prefabs.written, name)
        if least:
            self.prefabs.output.ask_room(count * least, setting.asked)

    def _put(self, copy: Copy, setting: Setting) -> None:
        """A copy, and what the generators in it make."""
        for nested, inner in put_copy(self.prefabs, copy, setting):
            self.generate(nested, inner)


def _varies(params: object) -> bool:
    """Whether parameters differ from copy to copy."""
    texts = params.values() if isinstance(params, dict) else ()
    try:
        return any(parsed(text).names & {*INDICES} for text in texts if is_expression(text))
    except ExpressionError:
        return False


def _counted(model: Generator) -> Iterator[Mapping[str, float]]:
    """The numbers that the parameters of each copy may ask for."""
    for number, name in enumerate(body_names(model), 1):
        place = name.removeprefix(model.id + "-").split("-")
        both = {"row": float(place[0]), "column": float(place[1])} if len(place) == 2 else {}
        yield {"i": float(number), **both}
