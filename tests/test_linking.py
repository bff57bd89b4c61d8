"""What the pipeline for numba promises: one version of a kernel, and machine code for entry points alone."""

from __future__ import annotations

import gc
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sandbox import _jit
from sandbox._jit import entry_point, kernel, kernel_argument
from sandbox._machine_code import Version
from sandbox._vectors import load_fields, store_fields
from sandbox.tables import Field, Table

pytestmark = pytest.mark.skipif(not _jit.jit_enabled(), reason="there is no machine code without the compiler")


@pytest.fixture
def functions() -> tuple[Any, Any, Any]:
    """An entry point, a kernel that it calls and one that both call; functions within functions are not kept."""

    @kernel
    def leaf(number: int) -> int:
        return 2 * number

    @kernel
    def middle(number: int) -> int:
        return leaf(number) + leaf(5)

    @entry_point
    def top(number: int) -> int:
        return middle(number) + leaf(0)

    return top, middle, leaf


@pytest.mark.slow
def test_literals_make_no_versions_of_their_own(functions: tuple[Any, Any, Any]) -> None:
    assert functions[0](3) == 16
    assert [len(each.dispatcher.overloads) for each in functions] == [1, 1, 1]


def test_only_the_entry_point_becomes_machine_code(
    functions: tuple[Any, Any, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    from sandbox import _linking

    made, usual = [], _linking._Whole._finalize_final_module

    def noted(library: Any) -> None:
        made.append(library.name.split(".")[-1])
        usual(library)

    monkeypatch.setattr(_linking._Whole, "_finalize_final_module", noted)
    assert functions[0](4) == 18
    assert made == ["top"]


@pytest.mark.slow
def test_for_another_processor_numba_does_nothing_again(
    functions: tuple[Any, Any, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    from sandbox import _linking, _shipped_code

    lines: list[str] = []
    monkeypatch.setattr(_linking, "tell", lines.append)
    lowest = list(_shipped_code.levels() or pytest.skip("no level is known"))[-1]
    codes = [_linking.machine_code(functions[0].dispatcher, (4,), level) for level in ("", lowest)]
    assert len(lines) == len(functions)
    for returns, code in codes:
        version = Version(code, returns)
        block = version.block((4,))
        assert block.result(version.enter(block.address)) == 18


@pytest.mark.slow
def test_numba_is_asked_once_what_an_operator_gives(
    functions: tuple[Any, Any, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    from numba.core.types import Function

    asked, usual = [], Function.get_call_type

    def noted(function: Any, context: Any, arguments: Any, named: Any) -> Any:
        asked.append((function, arguments))
        return usual(function, context, arguments, named)

    monkeypatch.setattr(Function, "get_call_type", noted)
    assert functions[0](2) == 14
    assert len(asked) == len(set(asked)) == 3  # 2 * number; for a lack of such a rule a product; a sum, twice
    assert Function.get_call_type is noted


def test_garbage_of_compiling_goes_before_the_next_time_once_it_is_much(
    functions: tuple[Any, Any, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    from sandbox import _linking

    collected, usual = [], gc.collect
    monkeypatch.setattr(gc, "collect", lambda: collected.append(usual()))
    monkeypatch.setattr(_linking, "_garbage", _linking._Garbage())
    top, *_ = functions
    for _ in range(2):  # to look through all that is frozen takes longer than to compile so little
        assert entry_point(top.py_func)(1) == 12
    assert collected == []
    frozen = gc.get_freeze_count()
    assert frozen > 0
    monkeypatch.setattr(_linking, "_MANY", 0)
    assert entry_point(top.py_func)(1) == 12
    assert len(collected) == 1
    assert gc.get_freeze_count() < 1.5 * frozen


@pytest.mark.parametrize("on", [True, False])
@pytest.mark.slow
def test_garbage_is_collected_after_compiling_if_it_was_before(functions: tuple[Any, Any, Any], on: bool) -> None:
    (gc.enable if on else gc.disable)()
    try:
        assert functions[0](1) == 12
        assert gc.isenabled() == on
    finally:
        gc.enable()


@pytest.mark.parametrize("shorter_first", [False, True])
def test_rows_of_a_table_are_not_taken_for_those_of_a_shorter_one(
    shorter_first: bool, recwarn: pytest.WarningsRecorder
) -> None:
    short = Table("short", (Field("a", "-", "", "i4"),))
    long = Table("long", (Field("a", "-", "", "i4"), Field("b", "-", "", "i4")))

    @kernel
    def first_of(row: Any) -> int:
        return int(row.a)

    @entry_point
    def top(rows: Any) -> int:
        return first_of(rows[0])

    tables = short.zeros(2), long.zeros(2)
    for table in tables if shorter_first else tables[::-1]:
        table.a = 7
        assert top(kernel_argument(table)) == 7
    assert len(first_of.dispatcher.overloads) == 2
    assert [str(each.message) for each in recwarn] == []


unchecked = pytest.mark.skipif("SANDBOX_CHECK_ROWS" in os.environ, reason="what is looked for is not there then")


@unchecked
def test_no_index_is_asked_whether_it_counts_from_the_end() -> None:
    from sandbox import _linking

    @entry_point
    def number_of(numbers: Any, row: int) -> float:
        return float(numbers[row])

    text = str(_linking.linked(number_of.dispatcher, (np.arange(3.0), 1))[1]._final_module)
    assert "getelementptr" in text
    assert "icmp" not in text
    assert "select" not in text


@pytest.mark.slow(2)
@pytest.mark.parametrize("row", [-1, 3])
def test_rows_can_be_checked_by_name_of_the_kernel_that_asks(row: int, tmp_path: Path) -> None:
    program = tmp_path / "program.py"
    program.write_text(
        "import sys, numpy as np\n"
        "from sandbox._jit import entry_point\n"
        "@entry_point\n"
        "def number_of(numbers, row):\n"
        "    return numbers[row]\n"
        "print(number_of(np.arange(3.0), 2), flush=True)\n"
        "print(number_of(np.arange(3.0), int(sys.argv[1])))\n"
    )
    root = Path(__file__).parents[1]
    given = {"SANDBOX_CHECK_ROWS": "1", "SANDBOX_CACHE_DIR": str(tmp_path / "cache"), "PYTHONPATH": str(root)}
    command = [sys.executable, str(program), str(row)]
    done = subprocess.run(command, env=os.environ | given, capture_output=True, text=True)
    assert done.stdout == "2.0\n"
    assert re.search(r"there is no such row; number_of\S* asks for it\n", done.stderr)
    assert f'"{program}", line 7 in' in done.stderr
    assert done.returncode != 0


TABLE = Table("row", (*(Field(name, "-", "") for name in "abc"), Field("count", "-", "", "i8")))


@unchecked
def test_what_is_stored_of_one_type_is_not_read_again_as_another() -> None:
    from sandbox import _linking

    @entry_point
    def count_twice(rows: Any, numbers: Any) -> int:
        count = rows[0].count
        numbers[0] = 3.0
        return int(count + rows[0].count)

    table = kernel_argument(TABLE.zeros(2))
    text = str(_linking.linked(count_twice.dispatcher, (table, np.zeros(1)))[1]._final_module)
    assert text.count("= load i64") == 1


def test_fields_that_are_stored_side_by_side_may_be_of_any_type() -> None:
    @entry_point
    def copied(rows: Any, one: int, other: int) -> int:
        before = rows[one].count
        store_fields(rows, other, 0, load_fields(rows, 1, 0))
        return int(rows[one].count - before)

    table = TABLE.zeros(2)
    table.count = [3, 10]
    assert copied(kernel_argument(table), 0, 0) == 7


@pytest.mark.slow(1)
def test_other_functions_in_the_process_count_from_the_end_as_before(functions: tuple[Any, Any, Any]) -> None:
    import numba

    assert functions[0](3) == 16
    last = numba.njit(lambda numbers: numbers[-1] + numbers[-numbers.shape[0]])
    assert last(np.array([1.0, 5.0, 30.0])) == 31.0
