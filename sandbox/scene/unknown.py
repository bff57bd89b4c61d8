"""Mistakes in field names: unknown ones, and objects whose kind they do not tell."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import islice
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BaseModel, Tag

from sandbox.scene.constraints import describe
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.limits import MAX_FINDINGS
from sandbox.scene.objects import OBJECTS
from sandbox.scene.other_words import did_you_mean_word, meant_by, nearest_word
from sandbox.scene.union import TAGS, UNIONS

_FEW = 8
"""So many fields are listed where none is meant."""


def unknown_field(path: Path, known: list[str], instead: str = "") -> Finding:
    """The finding about a field that is none of those `known`. It may be there `instead` of one."""
    name = str(path[-1])
    return Finding(path, f"unknown field {quoted(name)}", _meant(name, known, instead), on_key=True)


def belongs_elsewhere(name: str) -> bool:
    """Whether another object has a field of this name."""
    return any(name in model.model_fields for model in OBJECTS.values())


def _meant(name: str, known: list[str], instead: str) -> str:
    """The hint: what the word means here, the same in the plural, an object in this one that has it, a name that it is
    part of, or a near one."""
    near = nearest_word(name, known)
    homes = [home for home, model in OBJECTS.items() if name in model.model_fields]
    inside = [home for home in homes if _word(home) in map(_word, known)]
    longer = [other for other in known if name in other.split("_")]
    if near is not None and _word(near) == _word(name):
        longer = [near]
    if meant_by(name, known):
        return f'did you mean "{near}"?'
    if longer and not inside:
        return f"did you mean {' or '.join(map(quoted, longer))}?"
    if homes:
        return f"it belongs in {' or '.join(inside or homes)}"
    if near is not None or instead:
        return f'did you mean "{near or instead}"?'
    return f"there are {', '.join(known)}" if len(known) <= _FEW else ""


def _word(text: str) -> str:
    """The last word of a name or of what an author calls an object, in the singular."""
    return text.split()[-1].strip('"').removesuffix("s")


def no_kind(path: Path, item: Mapping[str, Any]) -> list[Finding]:
    """An object of a union of which no kind, or more than one, can be told."""
    value, what = item["input"], item["msg"]
    kinds = list(UNIONS[what])
    fields = list(dict.fromkeys(name for kind in UNIONS[what].values() for name in kind.model_fields))
    article = "an" if what[0] in "aeiou" else "a"
    if not isinstance(value, dict):
        return [
            Finding(
                path,
                f'{article} {what} must be an object such as {{"{kinds[0]}": ...}}, not {describe(value)}',
            )
        ]
    given = [key for key in kinds if key in value]
    if not given and value.get("type") in kinds and "type" not in fields:
        hint = f'as in {{"{value["type"]}": ...}}'
        return [Finding((*path, "type"), f"the kind of {article} {what} is a key", hint, on_key=True)]
    if given:
        listed = " and ".join(f'"{key}"' for key in given)
        return [Finding((*path, given[-1]), f"{article} {what} has one kind, and this one has {listed}", on_key=True)]
    strays = [key for key in islice(value, MAX_FINDINGS) if key not in fields]
    unknown = [unknown_field((*path, key), fields) for key in strays]
    if any(did_you_mean_word(key, kinds) for key in strays):
        return unknown
    listed = ", ".join(f'"{key}"' for key in kinds)
    wanted = f"{article} {what} needs one of {listed}"
    if len(unknown) == 1 and not unknown[0].hint:  # one wrong word is one mistake
        return [replace(unknown[0], hint=wanted)]
    return [Finding(path, wanted), *unknown]


def no_type(path: Path, item: Mapping[str, Any]) -> list[Finding]:
    """A joint whose `type` is missing or unknown."""
    value, what = item["input"], item["msg"]
    if not isinstance(value, dict):
        return [Finding(path, f'a {what} must be an object such as {{"type": "revolute", ...}}, not {describe(value)}')]
    kinds = list(UNIONS[what])
    given = value.get("type")
    listed = ", ".join(f'"{key}"' for key in kinds)
    if isinstance(given, str):
        return [Finding((*path, "type"), f"type must be one of {listed}", did_you_mean_word(given, kinds))]
    if "type" in value:
        return [Finding((*path, "type"), f"type must be text, not {describe(given)}")]
    near = [key for key in islice(value, MAX_FINDINGS) if did_you_mean_word(key, ["type"])]
    if near:
        return [unknown_field((*path, near[0]), ["type"])]
    return [Finding(path, f'a {what} needs a "type", one of {listed}')]


def model_at(loc: Path, root: type[BaseModel]) -> type[BaseModel] | None:
    """The model that a pydantic location in a `root` lies in; None where it is none."""
    hint: Any = root
    for part in loc:
        hint = _hint_inside(hint, part)
    return next((kind for kind in _leaves(hint) if isinstance(kind, type) and issubclass(kind, BaseModel)), None)


def _hint_inside(hint: Any, part: str | int) -> Any:
    """The type hint of the value at `part` (a field, key, index or tag) of a value of type `hint`; maybe None."""
    origin, parts = get_origin(hint), get_args(hint)
    if origin is Annotated:
        return _hint_inside(parts[0], part)
    if origin in (Union, UnionType):
        if part in TAGS:
            return next((kind for kind in parts if _tag(kind) == part), None)
        return next((found for kind in parts if (found := _hint_inside(kind, part)) is not None), None)
    if origin is dict:
        return parts[1]
    if origin is tuple and isinstance(part, int):
        return parts[0] if Ellipsis in parts else parts[part] if part < len(parts) else None
    fields = getattr(hint, "model_fields", {})
    return next((field.annotation for name, field in fields.items() if part in (name, field.alias)), None)


def _leaves(hint: Any) -> Iterator[Any]:
    """The types of a hint without annotations and `| None`."""
    if get_origin(hint) is Annotated:
        yield from _leaves(get_args(hint)[0])
    elif get_origin(hint) in (Union, UnionType):
        for kind in get_args(hint):
            yield from _leaves(kind)
    else:
        yield hint


def _tag(hint: Any) -> str | None:
    return next((extra.tag for extra in get_args(hint)[1:] if isinstance(extra, Tag)), None)


def names(model: type[BaseModel] | None) -> list[str]:
    """The fields of a model by the names they have in a file."""
    fields = model.model_fields if model else {}
    return [field.alias or name for name, field in fields.items()]
