"""Prefabs with their parameters filled in."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

from sandbox.scene.authoring.arithmetic import INDICES
from sandbox.scene.authoring.document import Document, Fault, Written
from sandbox.scene.authoring.evaluate import Evaluator, Numbers
from sandbox.scene.authoring.output import Output, size_of
from sandbox.scene.authoring.variables import numbers
from sandbox.scene.declarations import is_misspelt
from sandbox.scene.finding import Path, quoted
from sandbox.scene.near_names import did_you_mean
from sandbox.scene.plain import is_several, mapping
from sandbox.scene.prefab import Prefab

_POSE = ("id", "prefab", "params", "position", "angle", "velocity", "angular_velocity", "path")
"""What differs between copies of one body; the rest is a prefab that they share."""
_SHOWN = 8
_SAMPLE = dict.fromkeys(INDICES, 1.0)

Parameters = tuple[tuple[str, float], ...]
Entry = dict[str, Any]


@dataclass(frozen=True)
class Template:
    """A prefab of several bodies with its parameters filled in; `size` counts the values that a copy takes."""

    bodies: list[tuple[Entry, Written]]
    joints: list[tuple[Entry, Written]]
    generate: list[Written]
    known: Numbers
    size: int


@dataclass
class Prefabs:
    """The prefabs of a scene; each is worked out once for the same parameters."""

    written: Mapping[str, Written]
    known: Numbers
    evaluator: Evaluator
    output: Output
    _strays: set[tuple[Document, Path]] = field(default_factory=set)
    _defaults: dict[str, dict[str, float]] = field(default_factory=dict)
    _singles: dict[tuple[str, Parameters], str] = field(default_factory=dict)
    _templates: dict[tuple[str, Parameters], Template] = field(default_factory=dict)

    def write_all(self) -> None:
        """Put every prefab, with its defaults, into the output."""
        for name, written in self.written.items():
            defaults = self.defaults(name)
            prefab = written.value
            if isinstance(prefab, dict):
                sample = _SAMPLE if is_several(prefab) else {}
                params = prefab.get("params")
                rest = {key: value for key, value in prefab.items() if key != "params"}
                known = {**self.known, **defaults, **sample}
                prefab = self.evaluator.resolved(Written(written.document, written.path, rest), known)
                if params is not None:
                    values = {key: defaults[key] for key in defaults}
                    prefab = {"params": values if isinstance(params, dict) else params, **prefab}
            self.output.add_prefab(name, prefab, written)

    def defaults(self, name: str) -> dict[str, float]:
        """The parameters of a prefab, and what they are where nobody says otherwise."""
        if name not in self._defaults:
            params = self.written[name].at("params")
            given = params.value if isinstance(params.value, dict) else {}
            self._defaults[name] = numbers({key: params.at(key) for key in given}, self.known, self.evaluator)
        return self._defaults[name]

    def parameters(self, name: str, asked: Written, known: Numbers) -> Parameters:
        """All parameters for a use of a prefab; `asked` is the entry that may give some in "params"."""
        defaults = self.defaults(name)
        params = asked.at("params")
        given = params.value if isinstance(params.value, dict) else {}
        for key in given:
            place = params.at(key)
            if (
                key not in defaults
                and has_parameters(self.written[name].value)
                and (place.document, place.path) not in self._strays
            ):
                self._strays.add((place.document, place.path))
                hint = did_you_mean(str(key), defaults) or _listed(defaults)
                text = f"the prefab {quoted(name)} has no parameter {quoted(str(key))}"
                self.output.faults.append(place.fault(text, hint, on_key=True))
        own = numbers({key: params.at(key) for key in given if key in defaults}, known, self.evaluator)
        return tuple({**defaults, **own}.items())

    def single(self, name: str, parameters: Parameters) -> str:
        """The name of a prefab of one body with its parameters filled in."""
        if dict(parameters) == self.defaults(name):
            return name
        key = (name, parameters)
        if key not in self._singles:
            written = self.written[name]
            self.output.spend(size_of(written.value), written)
            known = {**self.known, **dict(parameters)}
            rest = {key: value for key, value in written.value.items() if key != "params"}
            filled = self.evaluator.resolved(Written(written.document, written.path, rest), known)
            self._singles[key] = self.output.free_name(name)
            self.output.add_prefab(self._singles[key], filled, written)
        return self._singles[key]

    def template(self, name: str, parameters: Parameters) -> Template:
        """A prefab of several bodies with its parameters filled in."""
        key = (name, parameters)
        if key not in self._templates:
            written = self.written[name]
            self.output.spend(size_of(written.value), written)
            known = {**self.known, **dict(parameters)}
            bodies = [(self._part(name, part, known), part) for part in _listed_in(written, "bodies")]
            joints = [(self.evaluator.resolved(part, known), part) for part in _listed_in(written, "joints")]
            generate = list(_listed_in(written, "generate"))
            places = [(part.value, part) for part in generate if "place" in part.value and "count" not in part.value]
            self.output.faults += (*_repeated([*bodies, *places]), *_repeated(joints))
            size = 1 + sum(size_of(entry) for entry, _ in (*bodies, *joints)) + len(generate)
            self._templates[key] = Template(bodies, joints, generate, known, size)
        return self._templates[key]

    def one_of(self, asked: Written, known: Numbers) -> str | None:
        """The prefab of one body that an entry of bodies names, filled in; None if there is none to fill in."""
        name = asked.value.get("prefab")
        written = self.written.get(name) if isinstance(name, str) else None
        if written is None or not isinstance(written.value, dict) or is_several(written.value):
            return None
        return self.single(str(name), self.parameters(str(name), asked, known))

    def _part(self, home: str, part: Written, known: Numbers) -> Entry:
        """A body of a prefab: what is its own, and a prefab made of the rest of it."""
        entry: Entry = self.evaluator.resolved(part, known)
        name = self.one_of(part, known)
        base = self.output.prefabs.get(name, {}) if name is not None else {}
        both = {**{key: value for key, value in base.items() if key != "params"}, **entry}
        if entry.get("prefab") is not None and name is None:
            return entry  # a name that means nothing, which is told of the body made
        shared = {key: value for key, value in both.items() if key not in _POSE}
        local = entry.get("id")
        made = self.output.free_name(f"{home}.{local}" if isinstance(local, str) else home)
        self.output.add_prefab(made, shared, part)
        own = {key: value for key, value in both.items() if key in _POSE and key not in ("params", "prefab")}
        return {**own, "prefab": made}


def has_parameters(prefab: object) -> bool:
    """Whether all parameters of a prefab can be read."""
    home = mapping(prefab)
    return isinstance(home.get("params", {}), dict) and not is_misspelt("params", home, Prefab.model_fields)


def _repeated(parts: list[tuple[Entry, Written]]) -> Iterator[Fault]:
    """Ids that are given twice in a prefab, told there rather than of each copy."""
    seen: dict[str, Path] = {}
    for entry, part in parts:
        name = entry.get("id")
        if isinstance(name, str) and name in seen:
            kind, number = seen[name][-2:]
            yield part.at("id").fault(f"the id {quoted(name)} is taken by {kind}[{number}] of the prefab")
        elif isinstance(name, str):
            seen[name] = part.path


def _listed_in(written: Written, key: str) -> list[Written]:
    """The objects of a list of a prefab; what is none is told by the models."""
    entries = written.value.get(key)
    if not isinstance(entries, (list, tuple)):
        return []
    return [written.at(key, k) for k, entry in enumerate(entries) if isinstance(entry, dict)]


def _listed(defaults: Mapping[str, float]) -> str:
    shown = [*islice(defaults, _SHOWN), *(["..."] if len(defaults) > _SHOWN else [])]
    return f"it has {', '.join(shown)}" if defaults else 'a prefab names its parameters in "params"'
