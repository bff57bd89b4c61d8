"""Commands as words of a recording, `[step, "ApplyImpulse", {...}]`, and back: every one of the registry."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from functools import cache
from types import UnionType
from typing import Annotated, Any, TypeAlias, Union, get_args, get_origin, get_type_hints

import numpy as np
from pydantic import AfterValidator, ValidationError, create_model
from pydantic_core import PydanticCustomError

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.registry import COMMAND_CLASSES
from sandbox.errors import CommandError
from sandbox.scene.base import Model
from sandbox.scene.constraints import Listed, describe
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.near_names import did_you_mean
from sandbox.scene.wording import findings

TimedCommand: TypeAlias = tuple[int, Command]
"""How many steps come before the command, and the command."""

_FORM = 'a command is [step, "NAME", {...}]'


def plain_command(command: Any) -> Command:
    """The same command with Python's own numbers, texts, tuples, lists and dicts inside: what a file can hold.

    Raises `CommandError` for anything else.
    """
    kind = type(command)
    if COMMAND_CLASSES.get(kind.__name__) is not kind:
        raise CommandError(f"{kind.__name__} is no command; there are {', '.join(sorted(COMMAND_CLASSES))}")
    given = {item.name: getattr(command, item.name) for item in dataclasses.fields(command)}
    plain: Command = kind(**{name: _plain(value, f"{kind.__name__}: {name}") for name, value in given.items()})
    return plain


def encode(command: Command) -> list[Any]:
    """Name and fields of a plain command, as JSON has them."""
    return [type(command).__name__, command.to_words()]


def decode(entry: Any, path: Path) -> tuple[TimedCommand | None, list[Finding]]:
    """The command that `entry` at `path` of a file stands for, or what is wrong with it."""
    if not isinstance(entry, list) or len(entry) != 3:
        return None, [Finding(path, f"{_FORM}, not {describe(entry)}" if not isinstance(entry, list) else _FORM)]
    step, name, given = entry
    found = []
    if not isinstance(step, int) or isinstance(step, bool) or step < 0:
        found.append(Finding((*path, 0), "a command begins with a step, a whole number from 0"))
    if not isinstance(name, str) or name not in COMMAND_CLASSES:
        hint = did_you_mean(name, COMMAND_CLASSES) if isinstance(name, str) else ""
        shown = quoted(name) if isinstance(name, str) else describe(name)
        return None, [*found, Finding((*path, 1), f"there is no command {shown}", hint)]
    try:
        model = _model(name).model_validate(given)
    except ValidationError as error:
        wrong = findings(error, _model(name))
        return None, found + [dataclasses.replace(one, path=(*path, 2, *one.path)) for one in wrong]
    return (None, found) if found else ((step, COMMAND_CLASSES[name].from_words(model.given())), [])


@cache
def _model(name: str) -> type[Model]:
    """The model of a command's fields, made of the dataclass itself."""
    kind = COMMAND_CLASSES[name]
    hints = get_type_hints(kind)
    given: dict[str, Any] = {
        item.name: (_checked(hints[item.name]), ... if _is_needed(item) else item.default)
        for item in dataclasses.fields(kind)
    }
    return create_model(name, __base__=Model, **given)


def _is_needed(item: dataclasses.Field[Any]) -> bool:
    return item.default is dataclasses.MISSING and item.default_factory is dataclasses.MISSING


def _checked(hint: Any) -> Any:
    """A type as a file can give it: tuples are lists there."""
    if get_origin(hint) in (Union, UnionType) and {dict, Sequence} <= set(map(get_origin, get_args(hint))):
        return Annotated[Any, AfterValidator(_check_entries)]  # `Spawn` reads them in the words of a scene file
    if get_origin(hint) in (Union, UnionType):
        return Union[tuple(_checked(part) for part in get_args(hint))]  # noqa: UP007
    if get_origin(hint) is not tuple:
        return hint
    parts = tuple(part if part is Ellipsis else _checked(part) for part in get_args(hint))
    count = 0 if Ellipsis in parts else len(parts)
    most = count or 1_000_000
    return Annotated[tuple[parts], Listed(f"of {count}" if count else "", count, most)]  # type: ignore[valid-type]


def _check_entries(value: Any) -> Any:
    entries = [value] if isinstance(value, dict) else value
    if not isinstance(entries, (list, tuple)) or not all(isinstance(entry, dict) for entry in entries):
        raise PydanticCustomError("entries", "must be an object or a list of objects")
    return value


def _plain(value: Any, place: str) -> Any:
    if value is None or isinstance(value, (bool, str)):
        return value
    if isinstance(value, (np.bool_, np.number)):
        return value.item()
    if isinstance(value, (int, float)):
        return value
    if isinstance(value, Mapping):
        return {str(key): _listed(_plain(entry, place)) for key, entry in value.items()}
    if isinstance(value, (tuple, list, np.ndarray)):
        return (list if isinstance(value, list) else tuple)(_plain(entry, place) for entry in value)
    raise CommandError(f"{place} must be a number, text, list or dict, not {type(value).__name__}")


def _listed(value: Any) -> Any:
    """In the words of a scene file, rows of values are lists."""
    return [_listed(entry) for entry in value] if isinstance(value, (tuple, list)) else value
