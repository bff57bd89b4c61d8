"""Expressions: held against Python's own arithmetic, and against whatever somebody may type."""

from __future__ import annotations

import json
import math
import re
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.errors import SceneError
from sandbox.scene import Scene, loads_scene
from sandbox.scene.authoring.arithmetic import UndefinedError, power
from sandbox.scene.authoring.expression import parsed
from sandbox.scene.authoring.mistake import ExpressionError
from tests.examples import examples
from tests.scene.scene_helpers import one

KNOWN = {"a": 2.5, "rows": 10.0, "b": -0.125}
ATOMS = st.one_of(
    st.integers(0, 50).map(str),
    st.floats(0, 1e6, allow_nan=False).map(repr).filter(lambda text: "inf" not in text),
    st.sampled_from([*KNOWN, "pi"]),
)


def _joined(inner):
    return st.one_of(
        st.tuples(inner, st.sampled_from([" + ", "-", " * ", "/", " % "]), inner).map("".join),
        st.tuples(st.sampled_from(["-", "+"]), inner).map("".join),
        inner.map(lambda text: f"({text})"),
        st.tuples(st.sampled_from(["abs", "floor", "ceil", "round"]), inner).map(lambda pair: f"{pair[0]}({pair[1]})"),
        st.tuples(st.sampled_from(["min", "max"]), inner, inner).map(
            lambda three: f"{three[0]}({three[1]}, {three[2]})"
        ),
        st.tuples(inner, st.sampled_from(["**2", "**-1", "**0", "**0.5"])).map("".join),
    )


FUNCTIONS = {
    "abs": abs, "min": min, "max": max, "pi": math.pi, "floor": lambda x: float(math.floor(x)),
    "ceil": lambda x: float(math.ceil(x)), "round": lambda x: float(round(x)),
}  # fmt: skip


def value(text: str) -> float | None:
    """What an expression comes to; None if it is refused."""
    try:
        return parsed(text).value(KNOWN)
    except ExpressionError:
        return None


@given(st.recursive(ATOMS, _joined, max_leaves=6))
@examples(150)
def test_the_same_as_python(text):
    floats = {**FUNCTIONS, **KNOWN}
    try:
        expected = eval(_with_points(text), {"__builtins__": {}}, floats)
    except (ZeroDivisionError, OverflowError, TypeError):  # the last of complex numbers
        expected = None
    found = value("=" + text)
    if found is None:
        fails = expected is None or isinstance(expected, complex) or not math.isfinite(expected)
        assert fails or "**" in text or len(text) > 499
    else:
        assert expected is not None
        assert found == pytest.approx(expected, rel=1e-15, abs=0) or "**" in text


def _with_points(text: str) -> str:
    """Whole numbers as floats, as all numbers of a scene are."""
    return re.sub(r"[0-9.]+(e[+-]?[0-9]+)?", lambda match: repr(float(match[0])), text)


@given(st.floats(-1e6, 1e6, allow_nan=False), st.integers(-300, 300))
@examples(100)
def test_powers_are_rounded_once(base, exponent):
    try:
        exact = float(Fraction(base) ** exponent)
    except (OverflowError, ZeroDivisionError):
        with pytest.raises(UndefinedError):
            power(base, float(exponent))
        return
    found = power(base, float(exponent))
    assert found == exact or abs(exact) < 2.3e-308


@pytest.mark.parametrize(
    ("text", "expected"),
    [("=2+3*4", 14), ("=(2+3)*4", 20), ("=-2**2", -4), ("=2**3**2", 512), ("=2**-1", 0.5), ("=10%-3", -2),
     ("=7/2", 3.5), ("=sin(30)", 0.5), ("=cos(60)", 0.5), ("=tan(45)", 1), ("=cos(90)", 0),
     ("=sqrt(2)**2", 2.0000000000000004), ("=round(2.5)", 2), ("=min(3, rows, 2)", 2), ("= - - 1", 1),
     ("=.5e1", 5), ("=rows", 10)],
)  # fmt: skip
def test_values(text, expected):
    assert value(text) == expected


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("=1/0", "2:23: division by zero"),
        ("=1 % (a - a)", "2:24: division by zero"),
        ("=raws * 2", '2:22: no number is named "raws": did you mean "rows"?'),
        ("=i", '2:22: there is no "i" here: only what a generator copies is counted'),
        ("=2 ^ 3", '2:24: "^" is no part of an expression: a power is written **'),
        ("=7 // 2", '2:25: a number is due before "/": floor(a / b) is what you may mean'),
        ("=(1", '2:22: a ")" is missing for this'),
        ("=", "2:21: the expression ends too early"),
        ("=1 2", '2:24: "2" is not expected here'),
        ("=sqr(4)", '2:22: there is no function "sqr": did you mean "sqrt"?'),
        ("=sin", "2:22: sin is a function: write sin(...)"),
        ("=min(1)", "2:22: min takes two numbers or more, not 1"),
        ("=sqrt(0 - 1)", "2:22: the square root of a negative number"),
        ("=9**9**9", "2:23: an exponent must be a whole number from -1000 to 1000, or 0.5"),
        ("=10**999", "2:24: the result is too large"),
        ("=1e308 * 10", "2:28: the result is too large"),
        ("=tan(90)", "2:22: there is no tangent of 90 degrees"),
        ("=" + "(" * 400, "2:54: nested deeper than 32 levels"),
        ("=" + "-" * 400 + "1", "2:54: nested deeper than 32 levels"),
        ("=" + "1+" * 300 + "1", "2:21: an expression has at most 500 characters"),
        ("=__import__('os')", '2:33: "\'" is no part of an expression'),
    ],
)
def test_mistakes_are_told_with_their_place(text, said):
    assert one('{"vars": {"rows": 10, "a": 1},\n "gravity":    [0, ' + json.dumps(text) + "]}") == said


@given(st.text("0123456789.+-*/%() ,abrowsinpe^=\"\\'_\u00e9", max_size=40))
@examples(200)
def test_whatever_is_typed(text):
    problems = []
    try:
        loads_scene(json.dumps({"vars": KNOWN, "gravity": [0, "=" + text]}))
    except SceneError as error:
        problems = error.problems
    assert all(problem.line for problem in problems)


def test_vars_may_be_made_of_each_other_in_any_order():
    scene = loads_scene('{"vars": {"c": "=a+b", "b": "=2*a", "a": 3}}')
    assert scene.vars == {"a": 3, "b": 6, "c": 9}


def test_a_long_chain_of_vars_needs_no_stack():
    chain = {f"a{k}": f"=a{k + 1}+1" for k in range(999)}
    assert loads_scene(json.dumps({"vars": {**chain, "a999": 0}})).vars["a0"] == 999


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('{"vars": {"a": "=b", "b": "=a"}}', "1:27: these numbers are made of each other: a > b > a"),
        ('{"vars": {"a": "=a+1"}}', "1:16: these numbers are made of each other: a > a"),
        ('{"vars": {"g": "9.81 / 6"}}',
         '1:16: must be a number, not text: an expression begins with "=", as in "=9.81 / 6"'),
        ('{"vars": {"sin": 1}}', '1:11: the name "sin" means something already'),
        ('{"vars": {"a-b": 1}}', '1:11: the name "a-b" must be letters, digits and _, and begin with no digit'),
        ('{"vars": {"a": []}}', "1:16: must be a number, not a list"),
        ('{"vars": {"a": 1e999}}', "1:16: must be a finite number"),
        ('{"vars": [1]}', "1:10: vars must be an object {...}, not a list"),
        ('{"vars": {"a": "=1/0"}, "gravity": ["=a", "=a"]}', "1:19: division by zero"),
    ],
)  # fmt: skip
def test_mistakes_in_vars(text, said):
    assert one(text) == said


def test_a_value_past_a_limit_says_what_it_comes_to():
    assert one('{"vars": {"v": 9e8}, "gravity": [0, "=10*v"]}') == (
        '1:37: gravity[1] must not be above 1e+06 m/s^2: "=10*v" is 9e+09'
    )
    assert one('{"vars": {"n": 7}, "settings": {"steps": "=n/2"}}') == (
        '1:42: steps must be a whole number: "=n/2" is 3.5'
    )


def test_texts_are_left_alone():
    scene = loads_scene('{"title": "=1", "about": "= or not", "vars": {"x": 1}, "gravity": ["=x", 0]}')
    assert (scene.title, scene.about, scene.gravity) == ("=1", "= or not", (1, 0))


def test_a_key_of_the_keyboard_is_no_expression():
    scene = loads_scene(
        '{"counters": {"n": 0}, "controls": [{"id": "c", "keys": ["="], "press": [{"counter": "n", "add": "=1+1"}]}]}'
    )
    assert scene.controls[0].keys == ("=",)


def test_an_escaped_sign_is_one_too():
    assert loads_scene('{"gravity": ["\\u003d1+1", 0]}').gravity == (2, 0)


def test_python_takes_expressions_too():
    scene = Scene(vars={"g": "=9.81/6"}, gravity=(0, "=-g"))
    assert scene.gravity == (0, -9.81 / 6)
    assert scene.written() == {"vars": {"g": "=9.81/6"}, "gravity": [0, "=-g"]}
