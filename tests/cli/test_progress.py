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
