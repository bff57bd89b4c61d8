"""All numbers of a scene that have a unit, with their places."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any, get_args

from pydantic import BaseModel

from sandbox.scene.constraints import Range
from sandbox.scene.finding import Path


def quantities(model: BaseModel, path: Path = ()) -> Iterator[tuple[Path, float, str]]:
    """Path, value and unit of each number that a model, or one inside it, was given."""
    units = _units(type(model))
    for name in type(model).model_fields:
        if name in model.model_fields_set:
            alias = type(model).model_fields[name].alias or name
            yield from _inside(getattr(model, name), (*path, alias), units[name])


def _inside(value: Any, path: Path, unit: str) -> Iterator[tuple[Path, float, str]]:
    if isinstance(value, BaseModel):
        yield from quantities(value, path)
    elif isinstance(value, Mapping):
        for key, item in value.items():
            yield from _inside(item, (*path, key), unit)
    elif isinstance(value, (tuple, list)):
        for number, item in enumerate(value):
            yield from _inside(item, (*path, number), unit)
    elif unit and isinstance(value, float):
        yield path, value, unit


@cache
def _units(model: type[BaseModel]) -> dict[str, str]:
    """The unit of each field of a model, empty where it has none."""
    return {
        name: next((unit for part in (*field.metadata, field.annotation) if (unit := _unit(part))), "")
        for name, field in model.model_fields.items()
    }


def _unit(hint: Any) -> str:
    """The unit within a type hint or what annotates it."""
    if isinstance(hint, Range):
        return hint.unit
    found = [unit for part in (*get_args(hint), *getattr(hint, "__metadata__", ())) if (unit := _unit(part))]
    return found[0] if found else ""
