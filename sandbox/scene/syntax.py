"""Mistakes in JSON itself, in plain words."""

from __future__ import annotations

import re
from json import JSONDecodeError

from sandbox.errors import SceneError
from sandbox.scene.brackets import CLOSING, open_brackets
from sandbox.scene.excerpt import line_column
from sandbox.scene.locate import Span
from sandbox.scene.report import syntax_error

_OPEN_TEXT = "text must end on the line it begins"
_CURLY = "“”„‘’‚«»"
_WORD = re.compile(r"[A-Za-z_$][\w$]*")


_SURROGATE = re.compile(r"\\u[dD][89a-fA-F]")
_ESCAPE = re.compile(r"\\(?:u[dD][89abAB][0-9a-fA-F]{2}\\u[dD][c-fC-F]|(u[dD][89a-fA-F])|.)", re.DOTALL)
"""A backslash and what it stands before: both halves of a character, in the group one of them alone, or anything."""


def lone_surrogate(text: str) -> Span | None:
    """Where a JSON text has the escape of one half of a character without the other; no encoding can say it."""
    if _SURROGATE.search(text) is None:
        return None
    found = next((match for match in _ESCAPE.finditer(text) if match[1]), None)
    return None if found is None else (found.start(), found.start() + len("\\ud800"))


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
        return "the file ends too early", _unclosed(text, pos)[1] or "a closing bracket is missing"
    if here == "#" or text[pos : pos + 2] in ("//", "/*"):
        return "JSON has no comments", 'an object may have one as a field, "$comment": "..."'
    if here == "'":
        return "text stands in double quotes", ""
    if here and here in _CURLY:
        return "text stands in straight double quotes", ""
    if "property name" in msg and here in CLOSING:
        return "a field's name is due here", f"{_unclosed(text, pos)[1]}, or objects are to stand in a list [...]"
    if "property name" in msg and before == "," and text[:pos].rstrip()[-2:-1].isdigit() and here.isdigit():
        return "a field's name is due here", "if this is a decimal, it has a point, as in 1.5"
    if "property name" in msg:
        return "a field's name is due here", "in double quotes" if word else ""
    return _explain_value(text, pos, msg, word.group() if word else "")


def _explain_value(text: str, pos: int, msg: str, word: str) -> tuple[str, str]:
    if "control character" in msg and text[pos] not in "\r\n":
        return "a control character within text", "write it with a backslash: a tab is \\t"
    if "Unterminated" in msg:
        return "the file ends too early", 'the text that begins here has no closing "'
    if "control character" in msg:
        return _OPEN_TEXT, 'close it with " (a line break inside is \\n)'
    if "escape" in msg:
        return "not a valid \\ escape", "a backslash itself is \\\\"
    if "Extra data" in msg:
        return "the scene has ended before this", "a file holds one object"
    if "':'" in msg:
        return 'a ":" is missing after the field\'s name', ""
    if "','" in msg:
        return _explain_end(text, pos, word)
    known = {"true": "true", "false": "false", "none": "null", "nan": "", "inf": "", "infinity": ""}
    if word.lower() in known and known[word.lower()]:
        return f"{word} is not JSON", f'did you mean "{known[word.lower()]}"?'
    if word:
        return "a value is due here", "text stands in double quotes"
    if text[pos : pos + 1] in ("+", ".", "-"):
        return "not a valid number", "a number begins with a digit or -, as in 0.5 or -0.5"
    return "a value is due here", ""


def _explain_end(text: str, pos: int, word: str) -> tuple[str, str]:
    """What is wrong where an entry has ended, and neither a comma nor the right bracket follows."""
    here, before = text[pos : pos + 1], text[pos - 1 : pos]
    if before == "0" and here.isdigit():
        return "a number must not begin with 0", ""
    if before.isdigit() and here and (here in "._/*+" or here.isalpha()):
        return "not a valid number", _mend_number(here)
    if word and before == '"':
        return "the text ends before this", 'a " is missing or too much; within a text it is \\"'
    if here in CLOSING.values():
        closing, mend = _unclosed(text, pos)
        return (f'a "{closing}" is missing before this', mend) if closing else ("nothing is open here", "")
    return "a comma is missing before this", ""


def _mend_number(here: str) -> str:
    """What is to be done about a letter or sign that goes on from a digit."""
    if here in "/*+":
        return 'an expression is text that begins with "=", as in "=1 / 2"'
    if here == ".":
        return "a point has digits on both sides, and there is one"
    return "a number is decimal and stands without its unit, as in 16 or 1.6e3"


def _unclosed(text: str, pos: int) -> tuple[str, str]:
    """The bracket that is due at `pos`, and which one it is to close; empty if none is open."""
    opened = open_brackets(text, pos)
    if not opened:
        return "", ""
    line, column = line_column(text, opened[-1])
    bracket = text[opened[-1]]
    return CLOSING[bracket], f'the "{bracket}" at {line}:{column} is not closed by a "{CLOSING[bracket]}"'
