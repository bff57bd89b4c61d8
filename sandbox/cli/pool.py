"""Work over processes; what comes of it comes in the order of the work."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import active_children, get_context, parent_process
from multiprocessing.connection import wait
from threading import Thread, current_thread, main_thread
from typing import TypeVar

import typer

from sandbox._lent import keep_streams, kept_streams
from sandbox.errors import SandboxError

Item = TypeVar("Item")
Made = TypeVar("Made")

JOBS = typer.Option("-j", "--jobs", min=0, max=256, metavar="N", help="Processes at a time; 0: one a processor.")


def _begin(streams: dict[str, bytes]) -> None:
    """Whoever ends the parent by force, as a system does that is short of memory, does not leave its processes.

    What a shell lent the parent, it alone can read.
    """
    keep_streams(streams)
    parent = parent_process()
    if parent is not None:
        Thread(target=lambda: (wait([parent.sentinel]), os._exit(1)), daemon=True).start()


@contextmanager
def _ended_by_sigterm() -> Iterator[None]:
    """End all processes with this one when it is asked to end, as `kill`, `timeout` and CI servers do."""

    def end(number: int, frame: object) -> None:
        for process in active_children():
            process.terminate()
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
    # Fresh processes: a fork would copy locks of threads that it has not got.
    pool = ProcessPoolExecutor(workers, get_context("spawn"), initializer=_begin, initargs=(kept_streams(),))
    try:
        with _ended_by_sigterm():
            yield from pool.map(work, items)
    except BrokenProcessPool:
        text = "a process was killed from outside, as a system does that is short of memory; try fewer with -j"
        raise SandboxError(text) from None
    finally:
        pool.shutdown(cancel_futures=True)  # whoever interrupts does not wait for the rest


def compile_first() -> None:
    """Fill an empty kernel cache once, or every process would."""
    from sandbox._jit import cache_is_cold
    from sandbox.engine.world import World
    from sandbox.scene import Scene

    if cache_is_cold():
        World(Scene()).step()
