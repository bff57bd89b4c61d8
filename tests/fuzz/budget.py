"""How much time and memory one case may take."""

from __future__ import annotations

import faulthandler
import resource
import signal
import sys
import time
from collections.abc import Callable

SECONDS = 5.0
"""Processor time of a case; most take a few milliseconds, but a busy machine makes that three times as much."""
SECONDS_PER_ROW = 2e-4
"""More for each body and joint of a large scene."""
HANGS_AFTER = 30.0
"""Processor time after which the process is ended, wherever it is: compiled code listens to nobody."""
BYTES = 256 * 1024 * 1024
"""Growth of the memory in use."""
MOST_BYTES = 3 * 1024**3
"""Address space beyond what the process has at its beginning."""
_KIBI = 1024


class OverBudgetError(Exception):
    """A case took too long or too much memory."""


def limit_process() -> None:
    """Let the process run out of memory before the machine does, and say where it is when it hangs."""
    if sys.platform != "linux":
        return
    with open("/proc/self/statm", encoding="ascii") as file:
        size = int(file.read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (size + MOST_BYTES, resource.RLIM_INFINITY))
    faulthandler.enable()
    faulthandler.register(signal.SIGVTALRM, chain=True)


def within_budget(run: Callable[[], int]) -> None:
    """Call `run`, which returns how many bodies and joints it has had to do with. Raises `OverBudgetError`."""
    began, peak = time.process_time(), _peak()
    signal.setitimer(signal.ITIMER_VIRTUAL, HANGS_AFTER)
    try:
        rows = run()
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
    seconds, grown = time.process_time() - began, _peak() - peak
    if seconds > SECONDS + SECONDS_PER_ROW * rows:
        raise OverBudgetError(f"it took {seconds:.1f} s of processor time")
    if grown > BYTES:
        raise OverBudgetError(f"it took {grown / 1e6:.0f} MB of memory")


def _peak() -> int:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * _KIBI
