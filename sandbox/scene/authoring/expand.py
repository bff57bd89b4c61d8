"""From what an author wrote to a scene without numbers by name, parameters and includes, still as plain data."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from typing import Any

from sandbox.scene import plain
from sandbox.scene.authoring.blame import Expansion
from sandbox.scene.authoring.copies import Setting
from sandbox.scene.authoring.document import Document, Fault, Written
from sandbox.scene.authoring.evaluate import TEXTS, Evaluator, Numbers
from sandbox.scene.authoring.expression import plain_number
from sandbox.scene.authoring.generate import Generators
from sandbox.scene.authoring.include import Reader
from sandbox.scene.authoring.library import PARTS, Library, gathered
from sandbox.scene.authoring.output import Origin, Output, TooMuchError
from sandbox.scene.authoring.prefabs import Prefabs, has_parameters
from sandbox.scene.authoring.variables import numbers
from sandbox.scene.declarations import is_misspelt, without_follow_ups
from sandbox.scene.finding import Path
from sandbox.scene.scene_fields import SceneFields

_MADE = ("include", "vars", "materials", "prefabs", "bodies", "joints", "generate")


def expanded(main: Document) -> Expansion:
    """The expansion of a document. It raises nothing: what is wrong is in it, and told with what the models find."""
    if not isinstance(main.data, dict):
        return Expansion(main, main.data)
    reader, evaluator = Reader(main), Evaluator()
    library = gathered(main, reader)
    known = numbers(library.vars, {}, evaluator)
    output = Output(main)
    prefabs = Prefabs(library.prefabs, known, evaluator, output)
    data = _rest(main, evaluator, known)
    if "vars" in data or library.vars:
        worked_out = {name: plain_number(value) for name, value in known.items() if not math.isnan(value)}
        data["vars"] = worked_out if isinstance(data.get("vars", {}), dict) else data["vars"]
    _write_materials(main, data, library, prefabs)
    try:
        prefabs.write_all()
        _write_bodies(main, data, prefabs)
        _write_generated(main, data, prefabs)
    except TooMuchError:
        pass
    for name, made in (("prefabs", output.prefabs), ("bodies", output.bodies), ("joints", output.joints)):
        if made and isinstance(data.get(name, made), type(made)):
            data[name] = made
    lacking: tuple[str, ...] = PARTS if reader.faults or reader.problems or _includes_more(data) else ()
    faults = (*reader.faults, *_without_follow_ups(evaluator.faults, main, lacking), *output.faults)
    if not output.is_whole or any("generate" in path for _, path in evaluator.broken):
        lacking = (*lacking, "generate")
    return Expansion(main, data, output.origins, lacking, faults, evaluator.broken, tuple(reader.problems), library)


def _includes_more(data: dict[str, Any]) -> bool:
    """Whether files are included that nobody has looked for, as the field is wrong."""
    return "include" in data or is_misspelt("include", data, SceneFields.model_fields)


def _without_follow_ups(faults: list[Fault], main: Document, lacking: Collection[str]) -> Iterator[Fault]:
    """The faults but those about numbers whose names may be in what cannot be read."""
    told = set(map(id, without_follow_ups([fault.finding for fault in faults], main.data, lacking)))
    for fault in faults:
        readable = has_parameters(fault.document.value(fault.finding.path[:2]))
        if id(fault.finding) in told and (readable or not fault.finding.lacks):
            yield fault


def _rest(main: Document, evaluator: Evaluator, known: Numbers) -> dict[str, Any]:
    """All fields, with numbers for the expressions in those that nothing else is made of."""
    top = Written(main, (), main.data)
    data = dict(main.data)
    names = [name for name in data if name in SceneFields.model_fields and name not in (*_MADE, *TEXTS)]
    data.update((name, evaluator.resolved(top.at(name), known)) for name in names)
    include = data.get("include")
    if isinstance(include, (list, tuple)) and all(isinstance(entry, str) for entry in include):
        del data["include"]
    return data


def _write_materials(main: Document, data: dict[str, Any], library: Library, prefabs: Prefabs) -> None:
    if not isinstance(data.get("materials", {}), dict) or not library.materials:
        return
    data["materials"] = {}
    for name, written in library.materials.items():
        data["materials"][name] = prefabs.evaluator.resolved(written, prefabs.known)
        if written.document is not main:
            prefabs.output.origins[("materials", name)] = Origin(written.document, written.path, ("include",))


def _write_bodies(main: Document, data: dict[str, Any], prefabs: Prefabs) -> None:
    """The author's own bodies and joints, and the bodies that rules bring, with their prefabs filled in."""
    top, output = Written(main, (), main.data), prefabs.output
    for key, made in (("bodies", output.bodies), ("joints", output.joints)):
        if isinstance(data.get(key), (list, tuple)):
            made += prefabs.evaluator.resolved(top.at(key), prefabs.known)
    for k, body in enumerate(output.bodies):
        if isinstance(body, dict) and "prefab" in body:
            output.bodies[k] = _filled(body, top.at("bodies", k), prefabs)
    for path, body in list(plain.spawns(data)):
        if "params" in body:
            _put(data, path, _filled(body, top.at(*path), prefabs))


def _filled(body: dict[str, Any], written: Written, prefabs: Prefabs) -> dict[str, Any]:
    """A body whose prefab has its parameters."""
    if not isinstance(body.get("params", {}), dict):
        return body
    name = prefabs.one_of(written, prefabs.known)
    if name is None:
        return body
    return {key: value for key, value in {**body, "prefab": name}.items() if key != "params"}


def _put(data: dict[str, Any], path: Path, value: Any) -> None:
    """Put a value at a path of `data`, with copies of what leads there: the rest may be the author's."""
    node: Any = data
    for part in path[:-1]:
        inner = node[part]
        node[part] = dict(inner) if isinstance(inner, dict) else list(inner)
        node = node[part]
    node[path[-1]] = value


def _write_generated(main: Document, data: dict[str, Any], prefabs: Prefabs) -> None:
    entries = data.get("generate")
    if not isinstance(entries, (list, tuple)):
        return
    generators, written = Generators(prefabs), Written(main, ("generate",), entries)
    try:
        for k in range(len(entries)):
            generators.generate(written.at(k), Setting(prefabs.known))
    finally:
        data["generate"] = prefabs.output.generate
