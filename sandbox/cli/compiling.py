"""Tell the user why the first step on a machine takes its time: what is compiled, how far that is, how long it takes.

On a terminal it is one line, written anew in place and gone when all is done. Elsewhere it is a line for what has
begun, as soon as its time is known, and one at the end.
"""

from __future__ import annotations

import sys
import threading
import time
from typing import Any

bars: list[Any] = []
"""The bars of rich's that are on the screen now: they make room for the line."""


def announce_compilation() -> None:
    """Tell on stderr of whatever is compiled from now on."""
    from sandbox import _compiling

    _compiling.on_change = (_InPlace() if sys.stderr.isatty() else _Lines()).change


class _InPlace:
    """One line on a terminal."""

    def __init__(self) -> None:
        self._live: Any = None
        self._turn = threading.Lock()  # another process is heard in a thread of its own

    def change(self) -> None:
        """Show the line, or take it away; in between it follows by itself."""
        from sandbox.engine.compile_status import compile_status

        with self._turn:
            status = compile_status()
            if status is not None and self._live is None:
                self._show()
            elif status is None and self._live is not None:
                self._live.stop()
                self._live = None
                for bar in bars:
                    bar.start()

    def _show(self) -> None:
        from rich.console import Console
        from rich.live import Live

        for bar in bars:
            bar.stop()
        self._live = Live(console=Console(stderr=True), get_renderable=_line, transient=True)
        self._live.start(refresh=True)


def _line() -> Any:
    from rich.text import Text

    from sandbox.engine.compile_status import compile_status

    status = compile_status()
    return Text(f"compiling, once: {status}" if status else "", no_wrap=True, overflow="ellipsis")


class _Lines:
    """Lines for a file: few, and none that is out of date as soon as it is written."""

    def __init__(self) -> None:
        self._begun: float | None = None
        self._told: list[Any] = []
        self._turn = threading.Lock()

    def change(self) -> None:
        """Write a line if there is something new to tell."""
        from sandbox._compiling import under_way

        with self._turn:
            works = under_way()
            if works:
                self._begun = self._begun or time.perf_counter()
                self._tell_times(works)
            elif self._begun is not None:
                _print(f"compiled in {time.perf_counter() - self._begun:.1f} s")
                self._begun = None

    def _tell_times(self, works: list[Any]) -> None:
        from sandbox.engine.compile_status import parts, seconds_left

        left = seconds_left(works)
        if left is not None and any(work not in self._told for work in works):
            self._told = works
            _print(f"compiling, once for this machine and version: {parts(works)}, about {left:.0f} s more")


def _print(text: str) -> None:
    print(f"sandbox: {text}", file=sys.stderr, flush=True)
