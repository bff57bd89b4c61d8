"""Which brackets of a JSON text are open at a place."""

from __future__ import annotations

import re

CLOSING = {"{": "}", "[": "]"}
_TOKEN = re.compile(r'"(?:[^"\\\n]|\\.)*"|[][{}]')


def open_brackets(text: str, end: int) -> list[int]:
    """Where the brackets begin that are open before `end`, outermost first; those within texts are none."""
    opened: list[int] = []
    for token in _TOKEN.finditer(text, 0, end):
        if token.group() in CLOSING:
            opened.append(token.start())
        elif token.group() in CLOSING.values() and opened:
            opened.pop()
    return opened
