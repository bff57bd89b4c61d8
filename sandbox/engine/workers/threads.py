"""The threads of the workers: they wait in Python between steps, and run machine code without its lock during one."""

from __future__ import annotations

import threading
import weakref
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from queue import SimpleQueue
from typing import Any, TypeAlias

from sandbox.engine.records.workers import SIZE, Workers
from sandbox.engine.workers.parallel_for import CLOSED

Job: TypeAlias = Callable[[], Any]


class WorkerThreads:
    """Threads that take part in a step beside the one that takes it. They end with this object."""

    def __init__(self, count: int) -> None:
        self._inboxes: list[SimpleQueue[Job | None]] = [SimpleQueue() for _ in range(count)]
        self._idle = threading.Semaphore(0)
        for number, inbox in enumerate(self._inboxes, start=1):
            name = f"sandbox-worker-{number}"
            threading.Thread(target=_work, args=(inbox, self._idle), name=name, daemon=True).start()
        weakref.finalize(self, _end, self._inboxes)

    @contextmanager
    def serving(self, workers: Workers, jobs: Sequence[Job]) -> Iterator[None]:
        """Have each thread do a job, `serve`, which ends when this block is left."""
        workers.words[CLOSED] = 0
        workers.words[SIZE] = 1 + len(jobs)
        for inbox, job in zip(self._inboxes, jobs, strict=True):
            inbox.put(job)
        try:
            yield
        finally:
            workers.words[CLOSED] = 1
            workers.words[SIZE] = 1
            for _ in jobs:
                self._idle.acquire()


def _work(inbox: SimpleQueue[Job | None], idle: threading.Semaphore) -> None:
    while (job := inbox.get()) is not None:
        try:
            job()
        finally:
            idle.release()


def _end(inboxes: Sequence[SimpleQueue[Job | None]]) -> None:
    for inbox in inboxes:
        inbox.put(None)
