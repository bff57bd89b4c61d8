"""A progress bar for pictures that take a while; on a terminal only."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from types import TracebackType
from typing import Self, TypeVar

from sandbox.cli.compiling import bars

T = TypeVar("T")


class PictureProgress:
    """A bar on stderr that leaves nothing behind; a context manager."""

    def __init__(self) -> None:
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

        console = Console(stderr=True)
        columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
        self._bar = Progress(*columns, console=console, transient=True, disable=not console.is_terminal)

    def count(self, what: str, items: Iterable[T], total: int | None = None) -> Iterator[T]:
        """Pass `items` through and count them under the name `what`."""
        length = total if total is not None else len(items) if isinstance(items, range) else None
        task = self._bar.add_task(what, total=length, visible=length != 0)
        for item in items:
            yield item
            self._bar.advance(task)

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
