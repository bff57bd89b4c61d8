"""From text to plain data, with syntax errors in plain words."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from sandbox.errors import SceneError
from sandbox.scene.limits import MAX_DEPTH
from sandbox.scene.locate import Span, too_deep
from sandbox.scene.report import syntax_error

_OPEN_TEXT = "text must end on the line it begins"
_WORD = re.compile(r"[A-Za-z_$][\w$]*")


@dataclass(frozen=True)
class Parsed:
    """Plain data of a JSON text; `repeats` tells whether some object gives a key twice."""

    data: Any
    repeats: bool


def parse(text: str, source: str) -> Parsed:
    """Parse JSON. NaN and infinities come through as floats for the models to refuse. Raises `SceneError`."""
    if not text.strip():
        raise syntax_error(
            source, text, (0, 0), "the file is empty", 'a scene is an object: {"bodies": [...]}'
        )
    try:
        parsed = _load(text)
    except json.JSONDecodeError as error:
        raise _reworded(source, text, error) from None
    except RecursionError:
        parsed = None
    if parsed is None or _depth_exceeds(parsed.data, MAX_DEPTH):
        span = too_deep(text, MAX_DEPTH) or (0, 1)
        raise syntax_error(source, text, span, f"nested deeper than {MAX_DEPTH} levels")
    return parsed


def _load(text: str) -> Parsed:
    repeats = False

    def to_dict(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        nonlocal repeats
        made = dict(pairs)
        repeats = repeats or len(made) < len(pairs)
        return made

    try:
        data = json.loads(text, object_pairs_hook=to_dict)
    except json.JSONDecodeError:
        raise
    except ValueError:  # Python refuses to read whole numbers of thousands of digits
        data = json.loads(text, object_pairs_hook=to_dict, parse_int=float)
    return Parsed(data, repeats)


def _depth_exceeds(data: Any, limit: int) -> bool:
    level = [data] if isinstance(data, (dict, list)) else []
    for _ in range(limit):
        level = [child for node in level for child in _children(node) if isinstance(child, (dict, list))]
    return bool(level)


def _children(node: Any) -> Iterable[Any]:
    return node.values() if isinstance(node, dict) else node


def _reworded(source: str, text: str, error: json.JSONDecodeError) -> SceneError:
    message, hint = _explain(text, error.pos, error.msg)
    pos = error.pos
    if message.startswith("a trailing comma"):
        pos = pos if text[pos : pos + 1] == "," else text.rindex(",", 0, pos)
    if message == _OPEN_TEXT:
        pos = text.rindex('"', 0, pos + 1)
    return syntax_error(source, text, _token(text, pos), message, hint)


def _token(text: str, pos: int) -> Span:
    word = _WORD.match(text, pos)
    return (pos, word.end()) if word else (pos, pos + 1)


def _explain(text: str, pos: int, msg: str) -> tuple[str, str]:
    """Message and mend for what `json` says at `pos`."""
    here, before = text[pos : pos + 1], text[:pos].rstrip()[-1:]
    word = _WORD.match(text, pos)
    if "trailing comma" in msg or (before == "," and here and here in "]}"):
        return "a trailing comma", "take it away: nothing follows it"
    if text[pos:].strip() == "" and "tring" not in msg:
        return "the file ends too early", "a closing bracket is missing"
    if here in ("/", "#"):
        return "JSON has no comments", 'a scene has the field "about" for words'
    if here == "'":
        return "text stands in double quotes", ""
    if "property name" in msg:
        return "a field's name is due here", "in double quotes" if word else ""
    return _explain_value(text, pos, msg, word.group() if word else "")


def _explain_value(text: str, pos: int, msg: str, word: str) -> tuple[str, str]:
    if "control character" in msg and text[pos] not in "\r\n":
        return "a control character within text", "write it with a backslash: a tab is \\t"
    if "Unterminated" in msg or "control character" in msg:
        return _OPEN_TEXT, 'close it with " (a line break inside is \\n)'
    if "escape" in msg:
        return "not a valid \\ escape", "a backslash itself is \\\\"
    if "Extra data" in msg:
        return "the scene has ended before this", "a file holds one object"
    if "':'" in msg:
        return 'a ":" is missing after the field\'s name', ""
    if "','" in msg:
        leading = text[pos - 1 : pos] == "0" and text[pos : pos + 1].isdigit()
        return ("a number must not begin with 0", "") if leading else ("a comma is missing before this", "")
    known = {"true": "true", "false": "false", "none": "null", "nan": "", "inf": "", "infinity": ""}
    if word.lower() in known and known[word.lower()]:
        return f"{word} is not JSON", f'did you mean "{known[word.lower()]}"?'
    if word:
        return "a value is due here", "text stands in double quotes"
    if text[pos : pos + 1] in ("+", ".", "-"):
        return "not a valid number", "a number begins with a digit or -, as in 0.5 or -0.5"
    return "a value is due here", ""
