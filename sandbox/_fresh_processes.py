"""Pools of fresh processes (a fork would copy locks of threads that it has not got) that leave nothing behind."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import active_children, get_context, parent_process, resource_tracker
from multiprocessing.connection import wait
from threading import Thread
from typing import Any

from sandbox.errors import SandboxError


class _Pool(ProcessPoolExecutor):
    """Its processes, which begin as work is given, never hear of Ctrl-C: a terminal tells all of it at once, and each
    would print what it was just importing. The one that began them says what is to end."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        with _interrupts_held():
            return super().submit(fn, *args, **kwargs)


@contextmanager
def fresh_processes(count: int, begin: Callable[..., None], *given: Any) -> Iterator[ProcessPoolExecutor]:
    """A pool of `count` processes, each of which calls `begin` first. Whatever ends its use early ends them at once.

    It is for `submit`: `map` cancels what it gave when it is left, and up to Python 3.11 the pool's own thread fails,
    and says so, over what is cancelled while processes end. Raises `SandboxError` if one of them is killed.
    """
    pool = _Pool(count, get_context("spawn"), initializer=_begin, initargs=(begin, *given))
    try:
        yield pool
    except BrokenProcessPool:
        text = "a process was killed from outside, as a system does that is short of memory; try fewer with -j"
        raise SandboxError(text) from None
    except BaseException:  # whoever interrupts does not wait for work that takes an hour
        end_children()
        raise
    finally:
        pool.shutdown()


def end_children() -> None:
    """Tell all processes that this one has begun to end."""
    for process in active_children():
        process.terminate()


def _begin(begin: Callable[..., None], *given: Any) -> None:
    """Whoever ends the parent by force, as a system does that is short of memory, does not leave its processes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    if parent is not None:
        Thread(target=lambda: (wait([parent.sentinel]), os._exit(1)), daemon=True).start()
    begin(*given)


@contextmanager
def _interrupts_held() -> Iterator[None]:
    """Ctrl-C waits meanwhile; processes that begin inherit that it does, for good. Windows has no such masks."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # where it begins with the first process, it lets them through again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
