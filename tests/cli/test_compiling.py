"""What the command line tells of compiling: one line in place on a terminal, few lines elsewhere."""

from __future__ import annotations

import io
from collections.abc import Iterator
from typing import Any

import pytest

from sandbox import _compiling
from sandbox.cli.compiling import announce_compilation
from sandbox.cli.progress import SceneProgress


class Terminal(io.StringIO):
    """Says that it is one."""

    def isatty(self) -> bool:
        return True


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    """A clock that is put on by hand, and nobody listening before and after."""

    class Clock:
        now = 100.0

    monkeypatch.setattr(_compiling.time, "perf_counter", lambda: Clock.now)
    monkeypatch.setattr(_compiling, "on_change", lambda: None)
    yield Clock
    _compiling.here.work = None


def compile_one(clock: Any, name: str) -> None:
    _compiling.here.hear(f"begin {name} 100")
    for _ in range(10):
        clock.now += 1.0
        _compiling.here.hear("kernel 10")
    clock.now += 1.0
    _compiling.here.hear("end")


def test_a_file_gets_a_line_when_the_time_is_known_and_one_at_the_end(
    clock: Any, capsys: pytest.CaptureFixture[str]
) -> None:
    announce_compilation()
    compile_one(clock, "sandbox.engine.step.solve")
    compile_one(clock, "sandbox.engine.fields.apply.apply_fields")
    out, err = capsys.readouterr()
    assert out == ""
    first, done, second, again = err.splitlines()
    # 2 of 10 kernels are done after 3 s, the second and third in 1 s each.
    assert first == "sandbox: compiling, once for this machine and version: solver, about 10 s more"
    assert second == first.replace("solver", "fields")
    assert done == again == "sandbox: compiled in 11.0 s"


def test_a_terminal_gets_one_line_that_goes_again(clock: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    screen = Terminal()
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr("sys.stderr", screen)
    announce_compilation()
    _compiling.here.hear("begin sandbox.engine.step.solve 100")
    assert "compiling, once: solver" in screen.getvalue()
    _compiling.here.hear("end")
    assert screen.getvalue().endswith("\x1b[1A\x1b[2K")  # a line up, and that line away


def test_a_bar_makes_room_for_it(clock: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    from rich.console import Console

    screen = Terminal()
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr("sys.stderr", screen)
    announce_compilation()
    with SceneProgress(Console(stderr=True), 1) as progress:
        progress.begin("one.scene.json", 10)
        _compiling.here.hear("begin sandbox.engine.step.solve 100")
        assert not progress._bar.live.is_started
        _compiling.here.hear("end")
        assert progress._bar.live.is_started
    assert not progress._bar.live.is_started
