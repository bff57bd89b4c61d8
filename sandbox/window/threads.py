"""The threads that work beside the window, and their end with it.

Python ends threads that still work when it ends itself by an exception that C++ code on their stacks, such as NumPy's,
does not let pass: the whole process is aborted then, though all is well. So they are asked to stop, and waited for.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from weakref import WeakKeyDictionary, WeakMethod

PATIENCE = 10.0
"""Seconds that the end of the program waits for at most: what is being compiled may take a minute."""
_threads: WeakKeyDictionary[threading.Thread, WeakMethod[Callable[[], None]] | None] = WeakKeyDictionary()
"""Each with the method that asks it to stop, if there is one."""


def start_thread(work: Callable[[], None], stop: Callable[[], None] | None = None) -> threading.Thread:
    """Do work in a thread; `stop`, a method, asks it to end soon."""
    thread = threading.Thread(target=work, daemon=True)
    _threads[thread] = None if stop is None else WeakMethod(stop)
    thread.start()
    return thread


def end_threads(seconds: float = PATIENCE) -> None:
    """Ask all of them to stop, and wait until they have, but no longer than that."""
    last, threads = time.monotonic() + seconds, list(_threads.items())
    for _, stop in threads:
        method = None if stop is None else stop()
        if method is not None:
            method()
    for thread, _ in threads:
        thread.join(max(last - time.monotonic(), 0.0))


@contextmanager
def ended_threads() -> Iterator[None]:
    """No thread works any more when the block is left."""
    try:
        yield
    finally:
        end_threads()
