"""What `--collect` is written in: `max(body('crate').speed)`, `at(120, energy)`, `apex = max(body('ball').y)`.

    column      = [name "="] value
    value       = final | min | max | mean "(" reading ")"  |  "at" "(" step "," reading ")"  |  reading
    reading     = body "." field ["." ("x" | "y")]  |  joint "." ...  |  "counter" "(" text ")"  |  word
    body, joint = ("body" | "joint") "(" text ")"

Python's parser reads it, and what is not in this grammar is refused: nothing is evaluated.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from sandbox.arguments import shown
from sandbox.errors import ArgumentError
from sandbox.scene.near_names import did_you_mean
from sandbox.sweeps.readings import BODY, JOINT, WORLD, Reading

OVER_TIME = ("final", "min", "max", "mean")
_LONGEST = 500
_NAMED = re.compile(r"\s*([A-Za-z_][A-Za-z0-9_]*)\s*=(?!=)(.*)", re.DOTALL)
_TRY = "such as body('crate').position, max(body('crate').speed), joint('pin').force, counter('score') or energy"


@dataclass(frozen=True)
class Subject:
    """Whom a reading is of: `kind` is "body", "joint", "counter" or "world"."""

    kind: str
    id: str = ""


@dataclass(frozen=True)
class Collected:
    """One expression: what is read, which part of a vector (None: all), when, and what its columns are called."""

    text: str
    name: str
    subject: Subject
    field: str
    part: int | None
    when: str
    step: int = 0

    @property
    def reading(self) -> Reading:
        """How its subject is read."""
        kinds: Mapping[str, Mapping[str, Reading]] = {"body": BODY, "joint": JOINT, "world": WORLD}
        return kinds[self.subject.kind][self.field] if self.subject.kind in kinds else Reading(lambda value: (value,))

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of its columns."""
        parts = self.reading.parts if self.part is None else ("",)
        return tuple(f"{self.name}_{part}" if part else self.name for part in parts)


def read_expressions(texts: Sequence[str]) -> tuple[Collected, ...]:
    """The expressions of a sweep. Raises `ArgumentError` for what is none, and where two columns have one name."""
    found = tuple(map(read_expression, texts))
    seen: dict[str, str] = {}
    for each in found:
        for column in each.columns:
            if column in seen:
                mend = f"name one, such as other = {each.text}"
                raise ArgumentError(f"{seen[column]} and {each.text} both make a column {column!r}; {mend}")
            seen[column] = each.text
    return found


def read_expression(text: str) -> Collected:
    """One expression. Raises `ArgumentError`."""
    if not isinstance(text, str):
        raise ArgumentError(f"collect: takes expressions as texts, not {shown(text)}")
    if len(text) > _LONGEST:
        raise ArgumentError(f"collect: an expression of {len(text)} characters; at most {_LONGEST} are read")
    named = _NAMED.fullmatch(text)
    name, body = (named[1], named[2]) if named else ("", text)
    try:
        tree = ast.parse(body.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise _error(text, f"this is no expression; write one {_TRY}") from None
    return _collected(tree, text, name)


def _collected(node: ast.expr, text: str, name: str) -> Collected:
    when, step = "final", 0
    match node:
        case ast.Call(func=ast.Name(id=word), args=[inner], keywords=[]) if word in OVER_TIME:
            node, when = inner, word
        case ast.Call(func=ast.Name(id="at"), args=[ast.Constant(value=int(given)), inner], keywords=[]):
            node, when, step = inner, "at", given
        case ast.Call(func=ast.Name(id="at")):
            raise _error(text, "at takes a step and what is read then, such as at(120, energy)")
    subject, field, part = _reading(node, text)
    given_name = name or "_".join(filter(None, _words(subject, field, part, when, step)))
    found = Collected(text.strip(), given_name, subject, field, part, when, step)
    if part is not None and len(found.reading.parts) == 1:
        raise _error(text, f"{field} is one number; it has no .{'xy'[part]}")
    return found


def _reading(node: ast.expr, text: str) -> tuple[Subject, str, int | None]:
    """Whom it is of, the field, and the part of a vector."""
    part = None
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Attribute):
        if node.attr not in ("x", "y"):
            raise _error(text, f"a vector has .x and .y, not .{node.attr}")
        node, part = node.value, "xy".index(node.attr)
    match node:
        case ast.Attribute(value=ast.Call() as call, attr=field):
            subject = _subject(call, text)
            if subject.kind == "counter":
                raise _error(text, f"a counter is one number; it has no .{field}")
            _check_field(subject.kind, field, text)
            return subject, field, part
        case ast.Call():
            subject = _subject(node, text)
            if subject.kind == "counter":
                return subject, "", part
            fields = ", ".join(BODY if subject.kind == "body" else JOINT)
            raise _error(text, f"what of it? A {subject.kind} has {fields}")
        case ast.Name(id=word):
            _check_field("world", word, text)
            return Subject("world"), word, part
    raise _error(text, f"write an expression {_TRY}")


def _subject(call: ast.Call, text: str) -> Subject:
    match call:
        case ast.Call(func=ast.Name(id="body" | "joint" | "counter" as kind), args=[ast.Constant(value=str(name))]):
            if not call.keywords:
                return Subject(kind, name)
        case ast.Call(func=ast.Name(id="body" | "joint" | "counter" as kind)):
            raise _error(text, f"a {kind} is told by its id in quotes, such as {kind}('crate')")
        case ast.Call(func=ast.Name(id=word)):
            if word in ("at", *OVER_TIME):
                raise _error(text, f"{word}(...) stands outermost, around what is read, and once")
            known = ("body", "joint", "counter", "at", *OVER_TIME)
            raise _error(
                text, f"there is no {word}(...); {did_you_mean(word, known) or 'there are ' + ', '.join(known)}"
            )
    raise _error(text, f"write an expression {_TRY}")


def _check_field(kind: str, field: str, text: str) -> None:
    known = {"body": BODY, "joint": JOINT, "world": WORLD}[kind]
    if field not in known:
        hint = did_you_mean(field, known) or f"there are {', '.join(known)}"
        raise _error(text, f"a {kind} has no {field!r} to collect; {hint}")


def _words(subject: Subject, field: str, part: int | None, when: str, step: int) -> list[str]:
    """What a column is called that was given no name."""
    over = when if when in OVER_TIME[1:] else ""
    end = f"at_{step}" if when == "at" else ""
    return [over, subject.id, field, "" if part is None else "xy"[part], end]


def _error(text: str, words: str) -> ArgumentError:
    return ArgumentError(f"collect {shown(text.strip(), 100)}: {words}")
