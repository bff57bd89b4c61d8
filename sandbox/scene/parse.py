"""From text to plain data."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.limits import MAX_DEPTH, MAX_FINDINGS
from sandbox.scene.locate import too_deep
from sandbox.scene.report import syntax_error
from sandbox.scene.syntax import explained, lone_surrogate

COMMENT = "$comment"
"""A key that any object may have, for whoever reads the file (JSON Schema, core, 8.3); nothing of it is read."""


@dataclass(frozen=True)
class Parsed:
    """Plain data of a JSON text without comments, and a finding for every key that an object gives more than once."""

    data: Any
    repeats: list[Finding]


def parse(text: str, source: str) -> Parsed:
    """Parse JSON. NaN and infinities come through as floats for the models to refuse. Raises `SceneError`."""
    if not text.strip():
        raise syntax_error(source, text, (0, 0), "the file is empty", 'a scene is an object: {"bodies": [...]}')
    try:
        parsed = _load(text)
    except json.JSONDecodeError as error:
        raise explained(source, text, error) from None
    except RecursionError:
        parsed = None
    half = lone_surrogate(text)
    if half is not None:
        pair = 'a character that takes two such halves has both: "\\ud83d\\ude00"'
        raise syntax_error(source, text, half, "half a character", pair)
    if parsed is None or _depth_exceeds(parsed.data, MAX_DEPTH):
        span = too_deep(text, MAX_DEPTH) or (0, 1)
        raise syntax_error(source, text, span, f"nested deeper than {MAX_DEPTH} levels")
    return parsed


def _load(text: str) -> Parsed:
    repeating: list[tuple[dict[str, Any], list[str]]] = []

    def to_dict(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        made = dict(pairs)
        if len(made) < len(pairs):
            counts = Counter(key for key, _ in pairs)
            repeating.append((made, [key for key, count in counts.items() if count > 1]))
        made.pop(COMMENT, None)
        return made

    try:
        data = json.loads(text, object_pairs_hook=to_dict)
    except json.JSONDecodeError:
        raise
    except ValueError:  # Python refuses to read whole numbers of thousands of digits
        repeating.clear()
        data = json.loads(text, object_pairs_hook=to_dict, parse_int=_whole)
    return Parsed(data, _repeats(data, repeating))


def _whole(digits: str) -> int | float:
    """A whole number of a JSON text; one of thousands of digits is infinite, as it is for floats."""
    try:
        return int(digits)
    except ValueError:
        return float(digits)


def _repeats(data: Any, repeating: list[tuple[dict[str, Any], list[str]]]) -> list[Finding]:
    """Findings for the objects of `data` that are in `repeating`, whose paths are not known yet."""
    keys = {id(node): names for node, names in repeating}
    found: list[Finding] = []
    level: list[tuple[Path, Any]] = [((), data)] if repeating and isinstance(data, (dict, list)) else []
    while level and len(level[0][0]) <= MAX_DEPTH:
        for path, node in level:
            names = keys.get(id(node), ())
            found += [Finding((*path, name), f"{quoted(name)} is given twice", on_key=True) for name in names]
        level = [((*path, key), child) for path, node in level for key, child in _items(node)]
    return found[:MAX_FINDINGS]


def _items(node: Any) -> Iterable[tuple[str | int, Any]]:
    pairs = node.items() if isinstance(node, dict) else enumerate(node)
    return ((key, child) for key, child in pairs if isinstance(child, (dict, list)))


def _depth_exceeds(data: Any, limit: int) -> bool:
    level = [data] if isinstance(data, (dict, list)) else []
    for _ in range(limit):
        level = [child for node in level for child in _children(node) if isinstance(child, (dict, list))]
    return bool(level)


def _children(node: Any) -> Iterable[Any]:
    return node.values() if isinstance(node, dict) else node
