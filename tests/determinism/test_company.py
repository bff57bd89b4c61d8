"""A world does not care what else runs beside it: in the same process, in turn, or in any number of processes."""

from __future__ import annotations

import multiprocessing
from concurrent.futures import ProcessPoolExecutor

import pytest

from sandbox.engine.world import World
from tests.determinism import busy, jointed
from tests.flat import body, box, ground, world


def digests_of(name: str) -> list[str]:
    """What one of the rooms gets, by name: for other processes."""
    return {"busy": lambda: busy.digests(World(busy.scene())), "jointed": jointed_digests}[name]()


def jointed_digests() -> list[str]:
    return jointed.digests(World(jointed.scene()))


def test_worlds_that_take_turns():
    alone = digests_of("busy"), digests_of("jointed")
    first, second, crowd = World(busy.scene()), World(jointed.scene()), pile()
    together: tuple[list[str], list[str]] = ([], [])
    for step in range(jointed.STEPS):
        together[0].extend(busy.digests(first, step, step + 1))
        crowd.step()
        together[1].extend(jointed.digests(second, step, step + 1))
    assert together[0] == alone[0][: jointed.STEPS]
    assert together[1] == alone[1]


def pile() -> World:
    """A world whose memory grows while others run."""
    crates = [body(f"crate {i}", box(1.0, 1.0), position=(1.01 * (i % 12), 0.6 + 1.1 * (i // 12))) for i in range(96)]
    return world(ground(), *crates)


@pytest.mark.slow
@pytest.mark.parametrize("workers", [1, 2, 3])
def test_any_number_of_workers(workers):
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(workers, mp_context=spawn) as pool:
        results = list(pool.map(digests_of, ["busy", "jointed", "busy"]))
    assert results == [digests_of("busy"), digests_of("jointed"), digests_of("busy")]
