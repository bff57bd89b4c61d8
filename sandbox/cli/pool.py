"""Work over processes; what comes of it comes in the order of the work."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from typing import TypeVar

import typer

from sandbox.errors import SandboxError

Item = TypeVar("Item")
Made = TypeVar("Made")

JOBS = typer.Option("-j", "--jobs", min=0, max=256, metavar="N", help="Processes at a time; 0: one a processor.")


def elsewhere(work: Callable[[Item], Made], items: Sequence[Item], workers: int) -> Iterator[Made]:
    """What `work` makes of each of `items`, in fresh processes. Raises `SandboxError` if one is killed."""
    # Fresh processes: a fork would copy locks of threads that it has not got.
    pool = ProcessPoolExecutor(workers, mp_context=get_context("spawn"))
    try:
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
