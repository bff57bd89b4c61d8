"""Bars of progress leave nothing behind where none is shown."""

from __future__ import annotations

import io
from collections.abc import Callable
from contextlib import AbstractContextManager

import pytest
from rich.console import Console
from rich.progress import Progress

from sandbox.cli.picture_progress import PictureProgress
from sandbox.cli.progress import SceneProgress


@pytest.mark.parametrize("make", [lambda: SceneProgress(Console(file=io.StringIO()), 1), PictureProgress])
def test_a_bar_that_is_not_shown_prints_nothing_with_any_rich(
    make: Callable[[], AbstractContextManager[object]], monkeypatch: pytest.MonkeyPatch
):
    stopped = []
    monkeypatch.setattr(Progress, "stop", stopped.append)  # up to rich 14, that ends a line even of a disabled bar
    monkeypatch.setattr("sys.stderr", io.StringIO())
    with make():
        pass
    assert stopped == []


@pytest.mark.parametrize("command", [("sat", "--step", "40"), ("solver", "--step", "3")])
def test_steps_before_what_is_looked_at_are_shown(
    cli: Callable, write_scene: Callable, monkeypatch: pytest.MonkeyPatch, command: tuple[str, ...]
) -> None:
    """Thousands of steps may come before, and without a word nobody knows whether it hangs."""
    heard: list[int] = []
    monkeypatch.setattr(SceneProgress, "done", lambda _, steps: heard.append(steps))
    name, *options = command
    assert cli(name, write_scene("a.scene.json"), *options).code == 0
    assert len(heard) > 2
    assert heard == sorted(heard)
