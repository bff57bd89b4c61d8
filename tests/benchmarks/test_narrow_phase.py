"""What the separating-axis test costs a pair, inside the step and asked by itself. Prints figures.

`python -m pytest -m benchmark -s tests/benchmarks/test_narrow_phase.py`
"""

from __future__ import annotations

import statistics
import time
from pathlib import Path

import pytest

import sandbox
from sandbox._jit import entry_point, kernel_argument
from sandbox.engine.narrow_phase.find_contacts import find_contacts
from sandbox.engine.records.state import StateTables
from sandbox.resources import find_scene

SECONDS = 1.0 / 60.0
TURNS = 60


@entry_point
def find(state, active, colliders, pairs, contacts, ccd_bodies, workers, decisions):
    """Inner kernels are not for Python to call."""
    return find_contacts(state, active, colliders, pairs, contacts, ccd_bodies, workers, decisions)


def nanoseconds_a_pair(world: sandbox.World, turns: int = TURNS) -> tuple[float, int]:
    """(time of the narrow phase over the pairs of the last step, number of pairs).

    The lowest tenth of the turns: what else runs on the machine only ever adds.
    """
    state, scratch = world.state, world.scratch
    count = int(state.counters[0].pair_count)
    tables = StateTables(*(getattr(state, name) for name in StateTables._fields))
    bundles = (
        tables, scratch.active, scratch.colliders, scratch.grid.pairs, scratch.contacts, scratch.solver.ccd,
        scratch.workers, scratch.decisions,
    )  # fmt: skip
    arguments = [kernel_argument(bundle) for bundle in bundles]
    times = []
    for _ in range(turns + 1):
        start = time.perf_counter()
        find(*arguments)
        times.append(time.perf_counter() - start)
    return statistics.quantiles(times[1:], n=10)[0] / count * 1e9, count


@pytest.mark.benchmark
@pytest.mark.parametrize(("name", "steps"), [("pyramid-100", 20), ("pyramid-30", 20), ("pile", 300)])
def test_narrow_phase(name: str, steps: int) -> None:
    world = sandbox.World(sandbox.load_scene(find_scene(Path(name))))
    world.state.settings[0].sleeping = 0  # the pairs of sleepers are not those of the last step
    world.step(steps)
    cost, count = nanoseconds_a_pair(world)
    print(f"\n{name}: {count} pairs, narrow phase {cost:.1f} ns a pair")
    assert count > 100


@pytest.mark.benchmark
def test_collide_from_python() -> None:
    a, b = sandbox.Box(1, 1), sandbox.Box(1, 1, at=(0.9, 0.2), angle=0.1)
    sandbox.collide(a, b)
    times = []
    for _ in range(2000):
        start = time.perf_counter()
        contact = sandbox.collide(a, b)
        times.append(time.perf_counter() - start)
    print(f"\ncollide of two boxes from Python: {statistics.median(times) * 1e6:.0f} us")
    assert contact is not None
