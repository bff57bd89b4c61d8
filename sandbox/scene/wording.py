"""Pydantic's validation errors in the words of a scene's author."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from pydantic import BaseModel, ValidationError

from sandbox.scene.constraints import describe
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.limits import MAX_FINDINGS
from sandbox.scene.number_mend import number_mend
from sandbox.scene.other_words import did_you_mean_word, nearest_word
from sandbox.scene.report import sort_of
from sandbox.scene.union import TAGS
from sandbox.scene.unknown import belongs_elsewhere, model_at, names, no_kind, no_type, unknown_field

_WANTED = {
    "float_type": "must be a number",
    "int_type": "must be a whole number",
    "bool_type": "must be true or false",
    "string_type": "must be text",
    "model_type": "must be an object {...}",
    "model_attributes_type": "must be an object {...}",
    "dict_type": "must be an object {...}",
}
_AND_SO = "and likewise in those after it"


def findings(error: ValidationError, root: type[BaseModel]) -> list[Finding]:
    """The findings of a validation of `root`, in pydantic's order."""
    items = error.errors(include_url=False)[:MAX_FINDINGS]
    meant = _meant(items, root)
    found: list[Finding] = []
    for item in items:
        if _lacking(item) not in meant.values():
            found += _reworded(item, root, meant)
    return _runs_as_one(found)


def _meant(items: Sequence[Mapping[str, Any]], root: type[BaseModel]) -> dict[Any, Any]:
    """Where the fields would be that unknown ones are told to be meant for, by where these are.

    That is a field with a name like it; or else, of one that is known nowhere, the only one that its object lacks.
    """
    unknown = [item["loc"] for item in items if item["type"] == "extra_forbidden"]
    missing = [item["loc"] for item in items if item["type"] == "missing"]
    strays, gaps = (Counter(loc[:-1] for loc in places) for places in (unknown, missing))
    only = {loc[:-1]: loc for loc in missing if gaps[loc[:-1]] == strays[loc[:-1]] == 1}
    meant = {}
    for loc in unknown:
        near = nearest_word(str(loc[-1]), names(model_at(loc[:-1], root)))
        if near is not None:
            meant[loc] = (*loc[:-1], near)
        elif loc[:-1] in only and not belongs_elsewhere(str(loc[-1])):
            meant[loc] = only[loc[:-1]]
    return meant


def _lacking(item: Mapping[str, Any]) -> tuple[Any, ...]:
    """Where the field would be that is missing, or without which a value is wrong (`without`); () if there is none."""
    without = item.get("ctx", {}).get("without")
    return item["loc"] if item["type"] == "missing" else (*item["loc"][:-1], without) if without else ()


def _runs_as_one(found: list[Finding]) -> list[Finding]:
    """Where a list has wrong entries from its first one on, that one is told for all: they are one mistake."""
    kept: list[Finding] = []
    last: Path = ()
    for finding in found:
        is_next = bool(kept) and _is_next(finding.path, last) and kept[-1].path[-1] == 0
        last = finding.path
        if not (is_next and sort_of(finding) == sort_of(kept[-1])):
            kept.append(finding)
        elif not kept[-1].hint.endswith(_AND_SO):
            kept[-1] = replace(kept[-1], hint=f"{kept[-1].hint}; {_AND_SO}".removeprefix("; "))
    return kept


def _is_next(path: Path, before: Path) -> bool:
    """Whether two paths lead to entries of one list that follow each other."""
    if not path or not before or path[:-1] != before[:-1]:
        return False
    return isinstance(path[-1], int) and isinstance(before[-1], int) and path[-1] == before[-1] + 1


def _reworded(item: Mapping[str, Any], root: type[BaseModel], meant: Mapping[Any, Any]) -> list[Finding]:
    loc = item["loc"]
    path: Path = tuple(part for part in loc if part not in TAGS)
    kind = item["type"]
    if kind == "extra_forbidden":
        place = tuple(part for part in loc[:-1] if part not in TAGS)
        return [unknown_field((*place, loc[-1]), names(model_at(loc[:-1], root)), meant.get(loc, ("",))[-1])]
    if kind == "missing":
        return [Finding(path[:-1], f'"{path[-1]}" is missing')]
    if kind == "kind":
        return no_kind(path, item)
    if kind == "kind_value":
        return no_type(path, item)
    if path and path[-1] == "[key]":
        return [Finding(path[:-1], f"the name {quoted(str(path[-2]))} {item['msg']}", on_key=True, once=True)]
    if kind == "name":
        return [Finding(path, f"the name {quoted(item['input'])} {item['msg']}", once=True)]
    message, hint = _message(item)
    if kind == "drawing":
        return [Finding(path, message, within=item["ctx"]["span"])]
    if kind in ("polygon", "ends"):
        return [Finding((*path, *item["ctx"]["place"]), message)]
    return [Finding(path, f"{_label(path)}{message}", hint)]


def _message(item: Mapping[str, Any]) -> tuple[str, str]:
    kind, value, context = item["type"], item["input"], item.get("ctx", {})
    if kind in _WANTED:
        wanted = _WANTED[kind]
        if kind == "float_type" and isinstance(value, int) and not isinstance(value, bool):
            return "must be a finite number", ""  # a whole one beyond all floats
        same = kind == "int_type" and isinstance(value, float)
        return (wanted, "") if same else (f"{wanted}, not {describe(value)}", _mend_of_text(kind, value))
    if kind == "literal_error":
        return _not_a_choice(value, context["expected"])
    if kind == "choice":
        shown = str(value) if isinstance(value, float) else describe(value)
        return f"must be {item['msg']}, not {shown}", ""
    fixed = {
        "finite_number": "must be a finite number",
        "int_from_float": "must be a whole number",
        "string_unicode": "is not valid text",
        "string_too_short": "must not be empty",
        "string_too_long": f"must have at most {context.get('max_length')} characters",
    }
    return fixed.get(kind, str(item["msg"])), ""


def _mend_of_text(kind: str, value: object) -> str:
    if kind == "bool_type":
        return "take the quotes away" if isinstance(value, str) and value in ("true", "false") else ""
    return number_mend(value) if kind in ("float_type", "int_type") and isinstance(value, str) else ""


def _not_a_choice(value: object, expected: str) -> tuple[str, str]:
    names = re.findall(r"'([^']*)'", expected)
    listed = ", ".join(f'"{name}"' for name in names)
    return f"must be one of {listed}", did_you_mean_word(value, names) if isinstance(value, str) else ""


def _label(path: Path) -> str:
    """How to name the value at a path: its field's name, with indices behind it."""
    keys = [i for i, part in enumerate(path) if isinstance(part, str)]
    if not keys:
        return ""
    return f"{path[keys[-1]]}{''.join(f'[{part}]' for part in path[keys[-1] + 1 :])} "
