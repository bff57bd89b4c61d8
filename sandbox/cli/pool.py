"""Work over processes; what comes of it comes in the order of the work."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from threading import current_thread, main_thread
from typing import TypeVar

import typer

from sandbox._fresh_processes import end_children, fresh_processes
from sandbox._lent import keep_streams, kept_streams

Item = TypeVar("Item")
Made = TypeVar("Made")

JOBS = typer.Option("-j", "--jobs", min=0, max=256, metavar="N", help="Processes at a time; 0: one a processor.")


@contextmanager
def ended_by_sigterm() -> Iterator[None]:
    """End all processes with this one when it is asked to end, as `kill`, `timeout` and CI servers do."""

    def end(number: int, frame: object) -> None:
        end_children()
        raise SystemExit(128 + number)

    if current_thread() is not main_thread():  # signals are not for others
        yield
        return
    before = signal.signal(signal.SIGTERM, end)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def elsewhere(work: Callable[[Item], Made], items: Sequence[Item], workers: int) -> Iterator[Made]:
    """What `work` makes of each of `items`, in fresh processes. Raises `SandboxError` if one is killed."""
    # What a shell lent this process, it alone can read.
    with ended_by_sigterm(), fresh_processes(workers, keep_streams, kept_streams()) as pool:
        futures = [pool.submit(work, item) for item in items]
        yield from (future.result() for future in futures)
