"""Mistakes in JSON itself, in plain words."""

from __future__ import annotations

import re
from json import JSONDecodeError

from sandbox.errors import SceneError
from sandbox.scene.locate import Span
from sandbox.scene.report import syntax_error

_OPEN_TEXT = "text must end on the line it begins"
_WORD = re.compile(r"[A-Za-z_$][\w$]*")


def explained(source: str, text: str, error: JSONDecodeError) -> SceneError:
    """The error for text that is no JSON, at the place to look at."""
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
