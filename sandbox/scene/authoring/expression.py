"""Expressions: `=2 * rows + 1` where a number is allowed.

An expression is parsed by recursive descent (the grammar is that of Python) into a list of steps for a stack, once
however often it is worked out. Nothing of it is ever given to Python to run.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from sandbox.scene.authoring.arithmetic import CONSTANTS, FUNCTIONS, INDICES, OPERATORS, UndefinedError
from sandbox.scene.authoring.grammar import Parser, Step
from sandbox.scene.authoring.mistake import MARK, ExpressionError
from sandbox.scene.locate import Span
from sandbox.scene.near_names import did_you_mean

_EXACT = 2.0**53


@dataclass(frozen=True)
class Expression:
    """A parsed expression; `names` are those it asks for."""

    steps: tuple[Step, ...]
    names: frozenset[str]

    def value(self, known: Mapping[str, float]) -> float:
        """What it comes to, with numbers by name. Raises `ExpressionError`."""
        stack: list[float] = []
        for kind, what, count, span in self.steps:
            if kind == "number":
                stack.append(what)
            elif kind == "name":
                stack.append(_looked_up(what, known, span))
            else:
                stack[len(stack) - count :] = [_applied(what, stack[len(stack) - count :], span)]
        return stack[0]


def is_expression(value: object) -> bool:
    """Whether a value of a file is an expression: a text that begins with "="."""
    return isinstance(value, str) and value.startswith(MARK)


@lru_cache(maxsize=4096)
def parsed(text: str) -> Expression:
    """The expression in a text that begins with `MARK`. Raises `ExpressionError`."""
    steps = Parser(text, len(MARK)).steps()
    return Expression(tuple(steps), frozenset(step[1] for step in steps if step[0] == "name"))


def plain_number(value: float) -> int | float:
    """A number as a file would hold it: whole ones without a point."""
    return int(value) if value.is_integer() and abs(value) <= _EXACT else value


def _looked_up(name: str, known: Mapping[str, float], span: Span) -> float:
    if name in known:
        return known[name]
    if name in CONSTANTS:
        return CONSTANTS[name]
    if name in INDICES:
        raise ExpressionError(f'there is no "{name}" here', "only what a generator copies is counted", span)
    hint = did_you_mean(name, [*known, *CONSTANTS, *FUNCTIONS])
    raise ExpressionError(f'no number is named "{name}"', hint or 'give it in "vars"', span, unknown=True)


def _applied(name: str, values: list[float], span: Span) -> float:
    function: Callable[..., Any] = OPERATORS[name] if name in OPERATORS else FUNCTIONS.get(name, _negative)
    try:
        result = function(*values)
    except UndefinedError as error:
        raise ExpressionError(str(error), "", span) from None
    except OverflowError:
        result = math.inf
    if not math.isfinite(result):
        raise ExpressionError("the result is too large", "", span)
    return float(result)


def _negative(x: float) -> float:
    return -x
