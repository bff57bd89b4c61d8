"""A long run takes no more memory than a short one."""

from __future__ import annotations

import tracemalloc
from pathlib import Path

import pytest

from tests.flat import body, box, circle, ground, world


@pytest.mark.slow
def test_memory_does_not_grow_over_100_000_steps():
    w = world(
        ground(),
        body("ball", circle(0.5, restitution=1.0), position=(0.0, 2.0)),
        body("crate", box(1.0, 1.0), position=(5.0, 0.5)),
    )
    w.step(1000)
    tracemalloc.start()
    try:
        w.step(500)
        before, _ = tracemalloc.get_traced_memory()
        w.step(100_000)
        after, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert after - before < 4096
    assert peak - before < 65_536
    assert w.step_count == 101_500


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
