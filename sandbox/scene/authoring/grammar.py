"""The grammar of expressions, that of Python:

sum     = term {("+" | "-") term}
term    = factor {("*" | "/" | "%") factor}
factor  = ("-" | "+") factor | power
power   = atom ["**" factor]
atom    = number | name | name "(" sum {"," sum} ")" | "(" sum ")"
"""

from __future__ import annotations

import math
import re
from typing import Any

from sandbox.scene.authoring.arithmetic import FUNCTIONS, MANY
from sandbox.scene.authoring.mistake import ExpressionError
from sandbox.scene.limits import MAX_EXPRESSION, MAX_EXPRESSION_DEPTH
from sandbox.scene.locate import Span
from sandbox.scene.near_names import did_you_mean

Step = tuple[str, Any, int, Span]
"""What to do: "number", "name" or "apply"; the number or name; how many values it takes; which characters say so."""

_TOKEN = re.compile(
    r"[ \t]*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?P<name>[A-Za-z_][A-Za-z_0-9]*)"
    r"|(?P<sign>\*\*|[-+*/%(),]))"
)
_MEANT = {"^": "a power is written **", "//": "floor(a / b) is what you may mean"}


class Parser:
    """Reads one text from `start` on."""

    def __init__(self, text: str, start: int) -> None:
        self._text = text
        self._depth = 0
        self._out: list[Step] = []
        if len(text) > MAX_EXPRESSION:
            raise ExpressionError(f"an expression has at most {MAX_EXPRESSION} characters", "", (0, len(text)))
        self._tokens = self._read(start)
        self._next = 0

    def steps(self) -> list[Step]:
        """The steps of the whole text. Raises `ExpressionError`."""
        self._sum()
        kind, token, span = self._peek()
        if kind != "end":
            hint = _MEANT["//"] if token == "/" else ""
            raise ExpressionError(f'"{token}" is not expected here', hint, span)
        return self._out

    def _read(self, start: int) -> list[tuple[str, str, Span]]:
        found, position = [], start
        end = len(self._text.rstrip(" \t"))
        while position < end:
            match = _TOKEN.match(self._text, position)
            if match is None:
                raise self._stray(position)
            kind = str(match.lastgroup)
            found.append((kind, match[kind], match.span(kind)))
            position = match.end()
        return [*found, ("end", "", (max(end - 1, 0), max(end, 1)))]

    def _stray(self, position: int) -> ExpressionError:
        while self._text[position] in " \t":
            position += 1
        sign = self._text[position]
        message = f'"{sign}" is no part of an expression'
        return ExpressionError(message, _MEANT.get(sign, ""), (position, position + 1))

    def _peek(self) -> tuple[str, str, Span]:
        return self._tokens[self._next]

    def _take(self, *signs: str) -> tuple[str, Span] | None:
        kind, token, span = self._peek()
        if kind != "sign" or token not in signs:
            return None
        self._next += 1
        return token, span

    def _deeper(self, span: Span) -> None:
        self._depth += 1
        if self._depth > MAX_EXPRESSION_DEPTH:
            raise ExpressionError(f"nested deeper than {MAX_EXPRESSION_DEPTH} levels", "", span)

    def _apply(self, name: str, count: int, span: Span) -> None:
        self._out.append(("apply", name, count, span))

    def _sum(self) -> None:
        self._term()
        while taken := self._take("+", "-"):
            self._term()
            self._apply(taken[0], 2, taken[1])

    def _term(self) -> None:
        self._factor()
        while taken := self._take("*", "/", "%"):
            self._factor()
            self._apply(taken[0], 2, taken[1])

    def _factor(self) -> None:
        taken = self._take("-", "+")
        if taken is None:
            self._power()
            return
        self._deeper(taken[1])
        self._factor()
        self._depth -= 1
        if taken[0] == "-":
            self._apply("negative", 1, taken[1])

    def _power(self) -> None:
        self._atom()
        taken = self._take("**")
        if taken:
            self._deeper(taken[1])
            self._factor()
            self._depth -= 1
            self._apply("**", 2, taken[1])

    def _atom(self) -> None:
        kind, token, span = self._peek()
        if kind == "end":
            raise ExpressionError("the expression ends too early", "", span)
        self._next += 1
        if kind == "number":
            self._number(token, span)
        elif kind == "name":
            self._name(token, span)
        elif token == "(":
            self._deeper(span)
            self._sum()
            self._close(span)
        else:
            hint = _MEANT["//"] if token == "/" else ""
            raise ExpressionError(f'a number is due before "{token}"', hint, span)

    def _number(self, token: str, span: Span) -> None:
        value = float(token)
        if math.isinf(value):
            raise ExpressionError("the number is too large", "", span)
        self._out.append(("number", value, 0, span))

    def _name(self, name: str, span: Span) -> None:
        opened = self._take("(")
        if opened is None:
            if name in FUNCTIONS:
                raise ExpressionError(f"{name} is a function", f"write {name}(...)", span)
            self._out.append(("name", name, 0, span))
            return
        if name not in FUNCTIONS:
            hint = did_you_mean(name, FUNCTIONS) or f"there are {', '.join(FUNCTIONS)}"
            raise ExpressionError(f'there is no function "{name}"', hint, span)
        self._deeper(opened[1])
        count = 1
        self._sum()
        while self._take(","):
            self._sum()
            count += 1
        self._close(opened[1])
        if (count < 2) if name in MANY else (count != 1):
            wanted = "two numbers or more" if name in MANY else "one number"
            raise ExpressionError(f"{name} takes {wanted}, not {count}", "", span)
        self._apply(name, count, span)

    def _close(self, opened: Span) -> None:
        if not self._take(")"):
            raise ExpressionError('a ")" is missing for this', "", opened)
        self._depth -= 1
