"""What the pipeline for numba promises: one version of a kernel, and machine code for entry points alone."""

from __future__ import annotations

import gc
from typing import Any

import pytest

from sandbox import _jit
from sandbox._jit import entry_point, kernel, kernel_argument
from sandbox._machine_code import Version
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
