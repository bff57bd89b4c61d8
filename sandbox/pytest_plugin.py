"""The pytest plugin: scenes that expect something, and recordings, are tests; fixtures for tests in Python.

Every test session with this package installed imports this file, so it imports nothing heavy; the engine is loaded
when the first of these tests runs.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from sandbox.testing.collected import Replays, Scenes, expects_something, is_asked_by_a_test
from sandbox.testing.fixtures import replay_check, world
from sandbox.testing.summary import WRITTEN, Judged, judged_files, write_page, written_files

__all__ = ["replay_check", "world"]

_UPDATES = ("missing", "changed", "all")
_REQUIRED = "every scene that expects something needs a recording beside it, as `sandbox replay` asks"


def pytest_addoption(parser: pytest.Parser) -> None:
    """The options of this plugin."""
    group = parser.getgroup("sandbox", "sandbox scenes and recordings")
    group.addoption(
        "--replay-update",
        nargs="?",
        const="changed",
        default=None,
        type=_update,
        metavar="missing|changed|all",
        help="record what is missing, or has changed as well (the default), or everything anew; never where CI is set",
    )
    group.addoption(
        "--replay-report",
        metavar="FILE",
        default=None,
        help="write one HTML page on the collected recordings, with a player for each that failed",
    )
    parser.addini("sandbox_recordings_required", _REQUIRED, type="bool", default=False)


def pytest_configure(config: pytest.Config) -> None:
    """Refuse to write where CI is set."""
    if config.getoption("replay_update") and os.environ.get("CI"):
        text = "--replay-update: CI is set, and recordings are never written there; run it on your machine"
        raise pytest.UsageError(text)


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Recordings, and scenes that expect something."""
    if file_path.name.endswith(".replay.json"):
        asked = is_asked_by_a_test(file_path) and not parent.session.isinitpath(file_path)
        return None if asked else Replays.from_parent(parent, path=file_path)
    if file_path.name.endswith(".scene.json") and expects_something(file_path):
        return Scenes.from_parent(parent, path=file_path)
    return None


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    """Name the recordings that were written; write the page that was asked for."""
    files = written_files(terminalreporter)
    if files:
        terminalreporter.section(WRITTEN)
        terminalreporter.write_line("\n".join(files))
    page = config.getoption("replay_report")
    if page:
        terminalreporter.write_line(_write_page(Path(page), judged_files(terminalreporter)))


def _write_page(page: Path, judged: Sequence[Judged]) -> str:
    """Write the page; a line that says so."""
    if not judged:
        return "no recording was judged: no page is written"
    try:
        write_page(page, judged)
    except OSError as error:
        return f"{page}: {error.strerror}"
    return f"page on recordings: {page}"


def _update(text: str) -> str:
    if text not in _UPDATES:
        hint = "before a path write --replay-update=changed"
        raise argparse.ArgumentTypeError(f"{text}: there are {', '.join(_UPDATES)}; {hint}")
    return text
