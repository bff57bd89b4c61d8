"""A progress bar over many scenes, for terminals only: in a log file it would be noise."""

from __future__ import annotations

import sys
from types import TracebackType
from typing import TYPE_CHECKING, Self

from sandbox._printable import printable
from sandbox.cli.compiling import bars

if TYPE_CHECKING:
    from rich.console import Console


class SceneProgress:
    """One bar that shows the scene being run; a context manager that leaves nothing behind on the screen.

    `count` scenes are to come, and the bar counts `unit`.
    """

    def __init__(self, console: Console, count: int, unit: str = "steps") -> None:
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

        columns = (TextColumn("{task.description}", markup=False), BarColumn(), MofNCompleteColumn(), TextColumn(unit))
        self._bar = Progress(
            *columns,
            console=console,
            transient=True,
            disable=not console.is_terminal,
            # Lines for the same terminal go above the bar; those for a file stay out of its way.
            redirect_stdout=sys.stdout.isatty(),
            redirect_stderr=sys.stderr.isatty(),
        )
        self._task = self._bar.add_task("", total=None)
        self._count = count
        self._begun = 0

    def begin(self, name: str, steps: int | None) -> None:
        """The next scene starts; it will take `steps` steps, if that is known."""
        self._begun += 1
        self._bar.reset(self._task, total=steps, description=f"{self._begun}/{self._count} {printable(name)}")

    def say(self, words: str) -> None:
        """What is being done with the current scene, with no end in sight."""
        self._bar.reset(self._task, total=None, description=f"{self._begun}/{self._count} {printable(words)}")

    def done(self, steps: int) -> None:
        """`steps` steps of the current scene are done."""
        self._bar.update(self._task, completed=steps)

    def __enter__(self) -> Self:
        self._bar.start()
        if not self._bar.disable:
            bars.append(self._bar)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if not self._bar.disable:
            bars.remove(self._bar)
            self._bar.stop()  # a bar that is not shown would end a line, with rich up to 14
