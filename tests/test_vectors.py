"""Vectors of numbers: each lane gets the bits that single numbers get, compiled and as arrays of numpy."""

from __future__ import annotations

import math
import operator
import struct
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import _jit
from sandbox._prefetch import prefetch_row
from sandbox._vectors import (
    WIDTH,
    absolute,
    any_lane,
    lane_numbers,
    load,
    load_fields,
    root,
    select,
    spread,
    store,
    store_fields,
    transpose,
)
from sandbox.tables import Field, Table, plain
from tests.examples import examples

NUMBERS = st.floats(allow_nan=True, allow_infinity=True) | st.sampled_from([0.0, -0.0, 1.0, -1.0, 5e-324, 1e300])
LANES = st.lists(NUMBERS, min_size=WIDTH, max_size=WIDTH)
OPERATORS = (operator.add, operator.sub, operator.mul, operator.truediv)
TESTS = (operator.lt, operator.le, operator.gt, operator.ge, operator.eq, operator.ne)


def _work(v: Any, number: float) -> bool:
    """`v` has vectors a and b, then room for what comes out."""
    a = load(v, 0 * WIDTH)
    b = load(v, 1 * WIDTH)
    store(v, 2 * WIDTH, a + b)
    store(v, 3 * WIDTH, a - b)
    store(v, 4 * WIDTH, a * b)
    store(v, 5 * WIDTH, a / b)
    store(v, 6 * WIDTH, -a)
    store(v, 7 * WIDTH, absolute(a))
    store(v, 8 * WIDTH, root(absolute(a)))
    store(v, 9 * WIDTH, a + number)
    store(v, 10 * WIDTH, number - a)
    store(v, 11 * WIDTH, number * a)
    store(v, 12 * WIDTH, a / number)
    store(v, 13 * WIDTH, select(a < b, 1.0, 0.0))
    store(v, 14 * WIDTH, select(a <= b, 1.0, 0.0))
    store(v, 15 * WIDTH, select(a > b, 1.0, 0.0))
    store(v, 16 * WIDTH, select(a >= b, 1.0, 0.0))
    store(v, 17 * WIDTH, select(a == b, 1.0, 0.0))
    store(v, 18 * WIDTH, select(a != b, 1.0, 0.0))
    store(v, 19 * WIDTH, select(a < b, a, b))
    store(v, 20 * WIDTH, select(number < 1.0, 2.0, 3.0) * spread(number))
    store(v, 21 * WIDTH, select((a < b) & ~(b > 0.0) | (a == 0.0), 1.0, spread(0.0)))
    return any_lane(a < b)


def single(a: float, b: float, number: float) -> list[float]:
    """The same for one lane, by single numbers; by those of numpy, which divide by zero."""
    one, two, three = np.float64(a), np.float64(b), np.float64(number)
    mixed = (one < two and not two > 0.0) or one == 0.0
    return [
        *(float(each(one, two)) for each in OPERATORS), -a, abs(a), math.sqrt(abs(a)),
        float(one + three), float(three - one), float(three * one), float(one / three),
        *(float(each(a, b)) for each in TESTS),
        a if a < b else b, (2.0 if number < 1.0 else 3.0) * number, float(mixed),
    ]  # fmt: skip


def bits(number: float) -> bytes:
    """NaN is one number, whatever its bits."""
    return b"nan" if math.isnan(number) else struct.pack("<d", number)


@pytest.fixture(scope="module")
def work() -> Any:
    """Compiled unless there is no compiler."""
    return _jit.entry_point(_work) if _jit.jit_enabled() else _work


@given(LANES, LANES, NUMBERS)
@examples(200)
def test_every_lane_gets_what_single_numbers_get(work, a, b, number):
    memory = np.zeros(22 * WIDTH)
    memory[:WIDTH], memory[WIDTH : 2 * WIDTH] = a, b
    with np.errstate(all="ignore"):
        some = work(memory, number)
        for k in range(WIDTH):
            found = memory[2 * WIDTH + k :: WIDTH].tolist()
            assert list(map(bits, found)) == list(map(bits, single(a[k], b[k], number)))
    assert some == any(x < y for x, y in zip(a, b, strict=True))


def test_vectors_begin_anywhere(work):
    """Not only where a register would like them to."""
    memory = np.zeros(22 * WIDTH + 1)[1:]
    memory[:WIDTH], memory[WIDTH : 2 * WIDTH] = range(WIDTH), 2.0
    work(memory, 1.0)
    assert memory[2 * WIDTH : 3 * WIDTH].tolist() == [2.0 + k for k in range(WIDTH)]


def test_plain_vectors_are_copies():
    """What is loaded does not change when its place does."""
    memory = np.arange(float(WIDTH))
    before = load(memory, 0)
    store(memory, 0, spread(3.0))
    assert before.tolist() == list(range(WIDTH))
    assert memory.tolist() == [3.0] * WIDTH


@given(LANES, LANES, NUMBERS)
def test_plain_functions_do_the_same(a, b, number):
    """Called from Python they are those that stand in for the compiled ones without the compiler."""
    one, two = np.array(a), np.array(b)
    truth = one < two
    assert any_lane(truth) == any(truth.tolist())
    chosen = select(truth, one, number).tolist()
    assert list(map(bits, chosen)) == [bits(x if t else number) for x, t in zip(a, truth.tolist(), strict=True)]
    assert select(True, 1.0, 2.0) == 1.0
    assert list(map(bits, root(abs(one)).tolist())) == [bits(math.sqrt(abs(x))) for x in a]


TABLE = Table("row", (*(Field(name, "-", "", "i4") for name in "ab"), *(Field(name, "-", "") for name in "qrstu")))
"""Two fields in the place of one, as rows of contacts begin."""


def _turn(table: Any, out: Any, first: int) -> None:
    a, b, c, d = transpose(
        load_fields(table, 0, first), load_fields(table, 1, first), load_fields(table, 2, first),
        load_fields(table, 3, first),
    )  # fmt: skip
    store(out, 0 * WIDTH, a)
    store(out, 1 * WIDTH, b)
    store(out, 2 * WIDTH, c)
    store(out, 3 * WIDTH, d)
    store(out, 4 * WIDTH, lane_numbers())
    prefetch_row(table, 4)
    store_fields(table, 4, first, c)


@pytest.mark.parametrize("first", [0, 1, 2])
def test_rows_of_a_table_become_columns(first):
    """Compiled or not: fields of four rows by field, and a column written to a row; what is no float keeps its bits."""
    turn = _jit.entry_point(_turn) if _jit.jit_enabled() else _turn
    table = TABLE.zeros(5)
    numbers = np.arange(30.0).reshape(5, 6)
    numbers.view(np.int64)[:, 0] = [-1, 7, 1 << 52, -2, 0]
    plain(table).view(np.float64).reshape(5, 6)[:] = numbers
    out = np.zeros(5 * WIDTH)
    turn(table, out, first)
    assert TABLE.places("qr", 8) == [1, 2]
    wanted = numbers[:4, first : first + WIDTH].T
    assert out[: 4 * WIDTH].tobytes() == wanted.tobytes()
    assert out[4 * WIDTH :].tolist() == [0.0, 1.0, 2.0, 3.0]
    numbers[4, first : first + WIDTH] = wanted[2]
    assert plain(table).tobytes() == numbers.tobytes()
