"""What is told of compiling: the weight of an entry point, how far it is, and how long it takes."""

from __future__ import annotations

import dis
from typing import Any

import pytest

from sandbox import _compiling
from sandbox._compiling import FRONT, Process, Work, weight, weight_of
from sandbox._jit import entry_point, interpreted, jit_enabled, kernel
from sandbox.engine import compile_status
from sandbox.engine.restitution.jointed.strike import strike_through_joints
from sandbox.engine.restitution.strike_batch import strike_batch

compiled = pytest.mark.skipif(not jit_enabled(), reason="there is no machine code without the compiler")


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Any:
    """A clock that is put on by hand."""

    class Clock:
        now = 100.0

    monkeypatch.setattr(_compiling.time, "perf_counter", lambda: Clock.now)
    return Clock


@pytest.fixture
def other(monkeypatch: pytest.MonkeyPatch) -> Process:
    """Another process that is waited for."""
    process = Process()
    monkeypatch.setattr(_compiling, "processes", [_compiling.here, process])
    return process


@kernel
def leaf(number: int) -> int:
    return number + 1


@kernel
def middle(number: int) -> int:
    return leaf(number) * leaf(2)


@entry_point
def top(number: int) -> int:
    return middle(number) + leaf(number)


def test_time_is_judged_by_what_came_after_the_first_kernel(clock: Any) -> None:
    work = Work("a", 1000)
    assert work.seconds is None
    clock.now += 3.0  # numba readies itself
    work.note(100)
    clock.now += 1.0
    work.note(50)
    assert work.seconds is None  # too little to judge by
    clock.now += 3.0
    work.note(150)
    # A fifth of the kernels in 4 s; the first tenth counts as no more than what it is.
    assert work.seconds == pytest.approx(3.0 + 4.0 * (1.0 - 0.1 * FRONT) / (0.2 * FRONT))
    assert work.spent == 7.0


def test_more_kernels_than_were_foreseen_are_no_more_than_all(clock: Any) -> None:
    work = Work("a", 20)
    for _ in range(3):
        clock.now += 1.0
        work.note(9)
    assert work.seconds is not None
    assert work.seconds > 3.0


@compiled
def test_an_entry_point_weighs_what_all_below_it_do_once() -> None:
    assert weight_of(top) == sum(weight(each.py_func) for each in (top, middle, leaf))  # type: ignore[attr-defined]


def test_room_for_what_python_caches_weighs_nothing() -> None:
    body: Any = interpreted(top)
    assert weight(body) == len(list(dis.get_instructions(body)))
    assert 2 * weight(body) < len(body.__code__.co_code)


@compiled
def test_what_only_joints_need_weighs_nothing_without_them() -> None:
    """Not even where its kernels are mentioned, as those that pass on impacts are."""
    assert weight_of(strike_batch) < 0.7 * weight_of(strike_through_joints)


@compiled
def test_each_kernel_is_told_of_and_the_weights_add_up(monkeypatch: pytest.MonkeyPatch) -> None:
    lines: list[str] = []
    monkeypatch.setattr(_compiling, "tell", lines.append)
    monkeypatch.setattr("sandbox._linking.tell", lines.append)
    monkeypatch.setattr("sandbox._jit.kept_file", lambda *_: None)
    fresh = entry_point(top.py_func)  # type: ignore[attr-defined]
    assert fresh(3) == 16
    begin, *kernels, end = lines
    assert begin == f"begin {__name__}.top {weight_of(fresh)}"
    assert sum(int(line.removeprefix("kernel ")) for line in kernels) == weight_of(fresh)
    assert end == "end"


def test_the_last_of_two_processes_says_how_long(clock: Any, other: Process) -> None:
    assert compile_status.compile_status() is None
    _compiling.here.hear("begin sandbox.engine.step.solve 100")
    other.hear("begin sandbox.engine.step.collide 100")
    try:
        assert compile_status.compile_status() == "solver, collision detection"
        for _ in range(2):
            clock.now += 1.0
            _compiling.here.hear("kernel 50")
        for _ in range(2):
            other.hear("kernel 25")
            clock.now += 1.0
        # `solve` has its kernels after 2 s; `collide` has half of its own in 4, and its second quarter took 1.
        rest = (1.0 - 0.5 * FRONT) / (0.25 * FRONT)
        assert compile_status.seconds_left(_compiling.under_way()) == pytest.approx(3.0 + rest - 4.0)
        text = f"solver, collision detection: {400 / (3.0 + rest):.0f} %, about {rest - 1.0:.0f} s left"
        assert compile_status.compile_status() == text
        other.show(False)
        assert compile_status.parts(_compiling.under_way()) == "solver"
    finally:
        _compiling.here.hear("end")
    other.show(True)
    assert compile_status.parts(_compiling.under_way()) == "collision detection"
    other.hear("end")
    assert compile_status.compile_status() is None


def test_a_name_without_words_of_its_own_is_told_as_it_is(other: Process) -> None:
    other.hear("begin mine.of_my_own 1")
    assert compile_status.compile_status() == "of my own"
