"""A long run takes no more memory than a short one."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.flat import body, box, ground, world

_LONG_RUN = """
import tracemalloc
from tests.flat import body, box, circle, ground, world

w = world(
    ground(),
    body("ball", circle(0.5, restitution=1.0), position=(0.0, 2.0)),
    body("crate", box(1.0, 1.0), position=(5.0, 0.5)),
)
w.step(1000)
tracemalloc.start()
w.step(500)
before, _ = tracemalloc.get_traced_memory()
w.step(100_000)
after, peak = tracemalloc.get_traced_memory()
print(after - before, peak - before, w.step_count)
"""


@pytest.mark.slow
def test_memory_does_not_grow_over_100_000_steps():
    """In a process of its own: what is traced are the allocations of all threads, also of those that run the tests."""
    run = subprocess.run([sys.executable, "-c", _LONG_RUN], capture_output=True, text=True, check=True)
    grown, peak, steps = map(int, run.stdout.split())
    assert grown < 4096
    assert peak < 65_536
    assert steps == 101_500


def resident() -> int:
    """Resident memory of this process in bytes; 0 where the system does not say."""
    statm = Path("/proc/self/statm")
    return int(statm.read_text().split()[1]) * 4096 if statm.exists() else 0


def test_compiled_code_does_not_leak_either():
    w = world(ground(), *(body(f"{i}", box(1.0, 1.0), position=(0.0, 0.5 + i)) for i in range(3)))
    w.step(2000)
    before = resident()
    w.step(20_000)
    assert resident() - before < 4_000_000
