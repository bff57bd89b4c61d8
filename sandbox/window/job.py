"""Work in a thread while the window goes on: how far it is, how to stop it, and what comes of it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Generic, TypeVar

from sandbox.window.threads import start_thread

T = TypeVar("T")
Item = TypeVar("Item")


class Cancelled(Exception):  # noqa: N818 - nothing went wrong
    """Ends the work of a job that is no longer wanted."""


class Progress:
    """How far a job is: `done` of `total` (0: not known) of what `what` says. Raises `Cancelled` where it is told."""

    def __init__(self) -> None:
        self.what = ""
        self.done = 0
        self.total = 0
        self.cancelled = False

    @property
    def share(self) -> float:
        """From 0 to 1."""
        return min(self.done / self.total, 1.0) if self.total else 0.0

    def at(self, done: int) -> None:
        """So far it is now."""
        if self.cancelled:
            raise Cancelled
        self.done = done

    def count(self, what: str, items: Iterable[Item], total: int | None = None) -> Iterator[Item]:
        """Pass `items` through and count them."""
        self.done = 0
        self.what, self.total = what, total if total is not None else len(items) if isinstance(items, range) else 0
        for number, item in enumerate(items):
            self.at(number)
            yield item
        self.at(self.total)


class Job(Generic[T]):
    """Runs `work` in a thread; look at `done`, then take `result`."""

    def __init__(self, work: Callable[[Progress], T]) -> None:
        self.progress = Progress()
        self._work = work
        self._result: list[T] = []
        self._error: Exception | None = None
        self._thread = start_thread(self._run, self.cancel)

    @property
    def done(self) -> bool:
        """True when `result` can be called without waiting."""
        return not self._thread.is_alive()

    def wait(self, seconds: float) -> bool:
        """Wait for it, but no longer than that; says whether it is done."""
        self._thread.join(seconds)
        return self.done

    def cancel(self) -> None:
        """Stop as soon as it can; `result` raises `Cancelled` then."""
        self.progress.cancelled = True

    def result(self) -> T:
        """What came of it; waits for it. Raises what the work raised, and `Cancelled`."""
        self._thread.join()
        if self._error is not None:
            raise self._error
        return self._result[0]

    def _run(self) -> None:
        try:
            self._result.append(self._work(self.progress))
        except Exception as error:  # handed to the thread that asks for the result
            self._error = error
