"""How Python calls machine code: what goes in and comes out, how it is kept, and that numba stays out of it."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import _kernel_cache
from sandbox._jit import Call, Door, entry_point, interpreted, jit_enabled, kernel
from sandbox.engine.world import World
from sandbox.scene import Scene
from sandbox.tables import Field, Table

compiled = pytest.mark.skipif(not jit_enabled(), reason="there is no machine code without the compiler")
WHOLE = st.integers(-(2**63), 2**63 - 1)
FLOATS = st.floats()


@entry_point
def mixed(table: Any, whole: int, number: float, truth: bool, nested: Any) -> Any:
    """Something of every kind, and a word written to the table."""
    table[1, 2] = table[0, 1] + nested[1][0]
    return whole, (number, truth, None), not nested[0], table.shape[0] * 100 + table.shape[1]


@entry_point
def number_of(number: float) -> float:
    return number


@entry_point
def whole_of(whole: int) -> int:
    return whole


@entry_point
def truth_of(whole: int) -> bool:
    return whole > 3


@entry_point
def fill(table: Any, number: float) -> None:
    table[0] = number


@entry_point
def add_count(row: Any, number: float) -> float:
    row.x += row.count + number
    return row.x


@entry_point
def parts(number: float, exponent: int) -> tuple[float, int, float]:
    return math.frexp(number)[0], math.frexp(number)[1], math.ldexp(number, exponent)


@entry_point
def last_of(table: Any) -> int:
    return table[table.shape[0] - 1, 1]


class Inner(NamedTuple):
    square: Any
    nothing: None
    single: Any


class Outer(NamedTuple):
    """One of each kind, so that a word too many or too few anywhere moves all that comes after it."""

    truth: bool
    line: Any
    nothing: None
    inner: Inner
    whole: int
    number: float
    row: Any


@kernel
def within(inner: Inner, number: float) -> float:
    """Reads a tuple in a tuple by its own address."""
    inner.square[1, 0] += number
    return float(inner.square[1, 0] + inner.single[0])


@entry_point
def by_name(outer: Outer) -> Any:
    """Asks for all that is in a tuple, for one thing after it was written to as well."""
    outer.row.x = outer.number
    sum_ = within(outer.inner, 0.5)
    absent = outer.nothing is None and outer.inner.nothing is None
    lengths = outer.line.shape[0] * 100 + outer.inner.square.shape[0] * 10 + outer.inner.square.shape[1]
    return outer.truth, int(outer.line[0]), absent, sum_, outer.whole, outer.number, float(outer.row.x), lengths


@given(WHOLE, FLOATS, st.booleans(), st.integers(1, 3))
def test_what_is_in_named_tuples_is_found_by_its_name(whole: int, number: float, truth: bool, apart: int) -> None:
    rows = Table("lone", (Field("x", "1", "a number"),)).zeros(2)
    square = np.arange(60.0).reshape(6, 10)
    inner = Inner(square[::apart, ::2], None, np.full(2, 7.0))
    outer = Outer(truth, np.arange(9)[::apart], None, inner, whole, number, rows[1])
    first, lengths = float(square[apart, 0]), outer.line.shape[0] * 100 + inner.square.shape[0] * 10 + 5
    assert repr(by_name(outer)) == repr((truth, 0, True, first + 7.5, whole, number, number, lengths))
    assert square[apart, 0] == first + 0.5
    assert repr(float(rows.x[1])) == repr(number)


@given(WHOLE, FLOATS, st.booleans(), st.booleans(), st.integers(1, 3), st.integers(1, 3))
def test_what_goes_in_comes_out(whole: int, number: float, truth: bool, other: bool, down: int, across: int) -> None:
    memory = np.arange(600.0).reshape(20, 30)
    table = memory[::down, ::across]
    arguments = (table, whole, number, truth, (other, (0.5, None)))
    expected = interpreted(mixed)(*arguments)
    memory[:] = np.arange(600.0).reshape(20, 30)
    got = mixed(*arguments)
    assert repr(got) == repr(expected)  # NaN as well, and True is not 1
    assert table[1, 2] == table[0, 1] + 0.5
    assert repr(Call(mixed, arguments)()) == repr(expected)


def test_a_row_is_its_place_in_the_table() -> None:
    rows = Table("pair", (Field("x", "1", "a number"), Field("count", "1", "another", "i8"))).zeros(3)
    rows.x[:], rows.count[:] = (1.0, 2.0, 3.0), (4, 5, 6)
    assert add_count(rows[1], 0.5) == 7.5
    assert rows.x.tolist() == [1.0, 7.5, 3.0]


@given(WHOLE, FLOATS)
def test_single_values_come_back(whole: int, number: float) -> None:
    assert repr(number_of(number)) == repr(number)
    assert repr(whole_of(whole)) == repr(whole)
    assert truth_of(whole) is (whole > 3)


def test_a_door_takes_other_arguments_of_the_same_types() -> None:
    door, one, other = Door(fill), np.zeros(2), np.zeros(3)
    for table, number in ((one, 1.0), (one, 2.0), (other, 2.0), (one, 3.0)):
        assert door(table, number) is None
        assert table[0] == number
    assert other.tolist() == [2.0, 0.0, 0.0]


@given(FLOATS, st.integers(-1100, 1000))
def test_parts_of_floats_are_those_of_python(number: float, exponent: int) -> None:
    try:
        expected = (*math.frexp(number), math.ldexp(number, exponent))
    except OverflowError:
        expected = (*math.frexp(number), math.copysign(math.inf, number))
    assert repr(parts(number, exponent)) == repr(expected)


@compiled
@pytest.mark.slow
def test_what_a_kernel_cannot_take_is_refused() -> None:
    door = Door(fill)
    door(np.zeros(1), 1.0)
    with pytest.raises(TypeError, match="an entry point"):
        whole_of("3")  # type: ignore[arg-type]
    with pytest.raises(Exception, match=r"required argument|must be"):
        door(np.zeros(1), "1")


@compiled
def test_a_warm_process_does_not_import_numba() -> None:
    World(Scene()).step()
    code = "import sys, sandbox; sandbox.World(sandbox.Scene()).step(); print('numba' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"


def test_files_are_read_whole_or_not_at_all(tmp_path: Path) -> None:
    file = tmp_path / "a.code"
    assert _kernel_cache.read(file) is None
    _kernel_cache.write(file, ["q", "d"], b"\x00code\n\xff")
    assert _kernel_cache.read(file) == (["q", "d"], b"\x00code\n\xff")
    assert [each.name for each in tmp_path.iterdir()] == ["a.code"]
    whole = file.read_bytes()
    for damaged in (whole[:-1], whole.replace(b"code", b"cope"), whole.replace(b"q", b"d"), b""):
        file.write_bytes(damaged)
        assert _kernel_cache.read(file) is None


def test_functions_within_functions_are_not_kept() -> None:
    def inner() -> None:
        """May be another one at the next call."""

    assert _kernel_cache.kept_file(inner, ()) is None  # type: ignore[arg-type]
    kept = _kernel_cache.kept_file(interpreted(fill), ("kind",))  # type: ignore[arg-type]
    assert kept is not None
    assert kept != _kernel_cache.kept_file(interpreted(fill), ("another",))  # type: ignore[arg-type]


@compiled
def test_a_table_of_one_row_is_of_the_same_kind_as_others() -> None:
    fresh = entry_point(interpreted(last_of))
    assert [fresh(np.full((rows, 2), rows)) for rows in (1, 2)] == [1, 2]  # by rows and by columns; by rows
    assert len(fresh._versions) == 1  # type: ignore[attr-defined]


THREADS = """
import threading, sandbox
scene = sandbox.Scene(bodies=[{"id": "a", "shapes": [{"circle": 1}]}, {"id": "b", "shapes": [{"circle": 1}]}])
worlds = [sandbox.World(scene) for _ in range(8)]
start = threading.Barrier(len(worlds))

def run(world):
    start.wait()
    world.step(50)

threads = [threading.Thread(target=run, args=(world,)) for world in worlds]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
print(*{world.digest() for world in worlds})
"""


@pytest.mark.slow
def test_threads_of_a_fresh_process_may_step_their_worlds_at_once() -> None:
    for _ in range(3):
        done = subprocess.run([sys.executable, "-c", THREADS], capture_output=True, text=True)
        assert (done.returncode, done.stderr) == (0, "")
        assert len(done.stdout.split()) == 1
