"""What is being compiled just now, how far it is, and how long it will still take on this machine.

Whoever compiles tells of it by lines of text, so that another process can tell as well:

    begin NAME WEIGHT      an entry point, and the weight of all kernels below it
    kernel WEIGHT          one of them has been typed and lowered
    end                    the entry point is machine code

The weight of a kernel is how many instructions its bytecode has. Time goes with it: after each tenth of the weight,
between 0.9 and 1.1 tenths of the time of `FRONT` had gone. What LLVM does with the whole comes after that.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

FRONT = 0.78
"""The share of the time until all kernels are lowered: 0.71, 0.73 and 0.83 in the three large entry points."""
_KNOWN = 0.08
"""After this share the time for all is known well enough to be told."""


class Work:
    """An entry point that is being compiled."""

    def __init__(self, name: str, weight: int) -> None:
        self.name = name
        self._weight = weight
        self._begun = time.perf_counter()
        self._first: tuple[float, float] | None = None
        self._last = (0.0, self._begun)

    def note(self, weight: int) -> None:
        """A kernel of that weight is done."""
        done = min(self._last[0] + FRONT * weight / self._weight, FRONT)
        self._last = done, time.perf_counter()
        self._first = self._first or self._last

    @property
    def seconds(self) -> float | None:
        """How long all of it takes, by what has been done so far; None as long as that is too little.

        Before the first kernel numba readies itself, which says nothing of the others.
        """
        if self._first is None or self._last[0] - self._first[0] < _KNOWN:
            return None
        (first, then), (last, now) = self._first, self._last
        return then - self._begun + (1.0 - first) * (now - then) / (last - first)

    @property
    def spent(self) -> float:
        """Seconds since it was begun."""
        return time.perf_counter() - self._begun


class Process:
    """What one process compiles: one entry point at a time."""

    def __init__(self) -> None:
        self.work: Work | None = None
        self.shown = True

    def show(self, shown: bool) -> None:
        """Whether anybody waits for it."""
        self.shown = shown
        on_change()

    def hear(self, line: str) -> None:
        """Take one of the lines above."""
        match line.split():
            case ["begin", name, weight]:
                self.work = Work(name, int(weight))
            case ["kernel", weight] if self.work is not None:
                self.work.note(int(weight))
            case ["end"]:
                self.work = None
        if self.shown:
            on_change()


here = Process()
tell: Callable[[str], None] = here.hear
"""Who hears of what this process compiles."""
processes: list[Process] = [here]


def on_change() -> None:
    """Called after each line about what is waited for. Whoever shows it puts a function of his own here."""


def at_once(work: Callable[[], None]) -> None:
    """Do it, and let everybody wait."""
    work()


patiently: Callable[[Callable[[], None]], None] = at_once
"""Does work that may take seconds. Whoever has a window to keep alive puts a function of his own here."""


def under_way() -> list[Work]:
    """What is being compiled now and waited for."""
    works = [each.work for each in processes if each.shown]
    return [work for work in works if work is not None]


@contextmanager
def compiling(entry: Any) -> Iterator[None]:
    """Tell that an entry point is being compiled."""
    function = entry.py_func
    tell(f"begin {function.__module__}.{function.__qualname__} {weight_of(entry)}")
    try:
        yield
    finally:
        tell("end")


def weight_of(entry: Any) -> int:
    """The weight of an entry point and all kernels below it.

    Where it is not given `joints`, the kernels in the room of that name are left out: some mention them for others.
    """
    code = entry.py_func.__code__
    absent = {"joints"}.difference(code.co_varnames[: code.co_argcount])
    found, open_ = {entry}, [entry]
    while open_:
        function = open_.pop().py_func
        for each in map(function.__globals__.get, function.__code__.co_names):
            if hasattr(each, "py_func") and each not in found and absent.isdisjoint(each.__module__.split(".")):
                found.add(each)
                open_.append(each)
    return sum(map(weight, (each.py_func for each in found)))


def weight(function: Any) -> int:
    """The weight of one kernel: the words of its bytecode but for the 0s, which are room for what Python caches."""
    return sum(map(bool, function.__code__.co_code[::2]))
