"""Replaces expressions by the numbers that they come to."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from sandbox.scene.authoring.document import Document, Fault, Written
from sandbox.scene.authoring.expression import is_expression, parsed, plain_number
from sandbox.scene.authoring.mistake import MARK, ExpressionError
from sandbox.scene.finding import Finding, Path
from sandbox.scene.limits import MAX_DEPTH, MAX_FINDINGS

Numbers = Mapping[str, float]
BROKEN = math.nan
"""Stands for a number that could not be worked out; nothing is said of what asks for it."""
TEXTS = frozenset({"$schema", "title", "about", "win", "lose", "keys", "minus"})
"""Fields of free text, in which "=" means nothing."""
_STAND_IN = 1


class Evaluator:
    """Works out expressions; `faults` collects what is wrong with them, `broken` where numbers stand in for such."""

    def __init__(self) -> None:
        self.faults: list[Fault] = []
        self.broken: set[tuple[Document, Path]] = set()

    def resolved(self, written: Written, known: Numbers) -> Any:
        """The value with a number for every expression in it; the very same object if there is none."""
        if not written.document.calculates or not _has_expression(written.value, MAX_DEPTH):
            return written.value
        return self._resolved(written, known, MAX_DEPTH)

    def number(self, written: Written, known: Numbers) -> float:
        """What one expression comes to; `BROKEN` if it is wrong."""
        text: str = written.value
        try:
            return parsed(text).value(known)
        except ExpressionError as mistake:
            asked = any(math.isnan(known.get(name, 0.0)) for name in _names(text))
            if not asked and len(self.faults) < MAX_FINDINGS:
                lacks = ("vars",) if mistake.unknown else ()
                finding = Finding(written.path, mistake.message, mistake.hint, within=mistake.span, lacks=lacks)
                self.faults.append(Fault(written.document, finding))
            return BROKEN

    def _resolved(self, written: Written, known: Numbers, depth: int) -> Any:
        value = written.value
        if is_expression(value):
            result = self.number(written, known)
            if not math.isnan(result):
                return plain_number(result)
            self.broken.add((written.document, written.path))
            return _STAND_IN
        if depth == 0 or not isinstance(value, (dict, list, tuple)):
            return value
        if isinstance(value, dict):
            pairs = [(key, entry) for key, entry in value.items() if key not in TEXTS and not _is_plain(entry)]
        else:
            pairs = [(key, entry) for key, entry in enumerate(value) if not _is_plain(entry)]
        changed = {}
        for key, entry in pairs:
            made = self._resolved(Written(written.document, (*written.path, key), entry), known, depth - 1)
            if made is not entry:
                changed[key] = made
        return _replaced(value, changed) if changed else value


def _has_expression(value: Any, depth: int) -> bool:
    """Whether there may be an expression in a value: most have none, and are not looked into twice."""
    if isinstance(value, str):
        return value.startswith(MARK)
    if depth == 0 or not isinstance(value, (dict, list, tuple)):
        return False
    for entry in value.values() if isinstance(value, dict) else value:
        if not _is_plain(entry) and _has_expression(entry, depth - 1):
            return True
    return False


def names_asked_for(value: Any) -> set[str]:
    """The names that expressions in plain data ask for."""
    found: set[str] = set()
    nodes = [value]
    while nodes:
        node = nodes.pop()
        if isinstance(node, str) and node.startswith(MARK):
            found |= _names(node)
        elif isinstance(node, dict):
            nodes += [entry for key, entry in node.items() if key not in TEXTS]
        elif isinstance(node, (list, tuple)):
            nodes += node
    return found


def _is_plain(value: Any) -> bool:
    return type(value) in (float, int, bool) or value is None


def _replaced(value: Any, changed: Mapping[Any, Any]) -> Any:
    if isinstance(value, dict):
        return {**value, **changed}
    return [changed.get(index, entry) for index, entry in enumerate(value)]


def _names(text: str) -> frozenset[str]:
    try:
        return parsed(text).names
    except ExpressionError:
        return frozenset()
