"""Batches of islands: every island in one, none over two, and the bits the same however many share one.

But in the first step, in which what a batch is to bear is solved until all of it agrees.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import sandbox
from sandbox.engine import stepper
from sandbox.engine.memory import bundles, limit
from sandbox.engine.world import World
from sandbox.resources import find_scene
from tests.determinism import busy, jointed
from tests.shipped import shipped


@pytest.fixture
def few_a_batch(monkeypatch):
    """Batches of up to two bodies each, in worlds of any size."""
    monkeypatch.setattr(limit, "SIZE", 2)
    monkeypatch.setattr(bundles, "SIZE", 2)
    monkeypatch.setattr(stepper, "_WORTH_SHARING", 0)


def begun(scene, workers: int) -> World:
    """A world that has its first step behind it, as it says."""
    world = World(scene, workers)
    world.state.counters["step_count"] = 1
    return world


def digests(scene, workers: int) -> list[str]:
    world = begun(scene, workers)
    found = []
    for _ in range(12):
        world.step(10)
        found.append(world.digest())
    return found


@pytest.mark.parametrize("made", [busy, jointed])
@pytest.mark.parametrize("workers", [1, 3])
def test_a_busy_scene_with_commands_goes_the_same_way(made, workers, few_a_batch, monkeypatch):
    in_batches = [made.digests(begun(made.scene(), workers)) for _ in range(4 if workers > 1 else 1)]
    monkeypatch.undo()
    expected = made.digests(begun(made.scene(), 1))
    assert in_batches == [expected] * len(in_batches)


@pytest.mark.parametrize("name", ["stack-20", "newtons-cradle", "bowling", "billiards"])
@pytest.mark.parametrize("workers", [1, 2])
def test_shipped_scenes_go_the_same_way(name, workers, few_a_batch, monkeypatch):
    in_batches = digests(shipped(name), workers)
    monkeypatch.undo()
    assert in_batches == digests(shipped(name), 1)


def unlike_piles() -> sandbox.Scene:
    """Stacks of five crates; one of them bears 400 times its weight, and so takes finer substeps; a ball that flies."""
    crate = {"shapes": [{"box": [0.5, 0.5]}]}
    stacks = [{**crate, "id": f"c{x}-{k}", "position": [2.0 * x, 0.25 + 0.5 * k]} for x in range(6) for k in range(5)]
    heavy = {"id": "heavy", "shapes": [{"box": [0.5, 0.5], "density": 400.0}], "position": [4.0, 3.0]}
    ball = {"id": "ball", "shapes": [{"circle": 0.2}], "position": [-5.0, 9.0], "velocity": [1.0, 9.0]}
    floor = {"id": "floor", "type": "static", "shapes": [{"box": [30.0, 1.0]}], "position": [5.0, -0.5]}
    return sandbox.Scene(bodies=[floor, *stacks, heavy, ball])


@pytest.mark.parametrize("workers", [1, 2])
def test_islands_of_several_substep_levels_go_the_same_way(workers, few_a_batch, monkeypatch):
    in_batches = begun(unlike_piles(), workers)
    in_batches.step(60)
    monkeypatch.undo()
    together = begun(unlike_piles(), 1)
    together.step(60)
    assert together.state.counters["substep_levels"][0] > 1
    assert in_batches.digest() == together.digest()
    ball = together.body("ball")
    assert ball.position == pytest.approx((-4.0, 9.0 + 9.0 - 0.5 * 9.81), rel=1e-12), "it flies once a step"


def test_every_island_is_in_one_batch_that_holds_it():
    world = World(sandbox.load_scene(find_scene(Path("box2d-many-pyramids"))))
    world.step()
    made = world.scratch
    batches, of_body = made.blocks.batches, made.solver.batches
    count = int(of_body.max()) + 1
    assert count > 20
    awake = made.active.bodies[1 : 1 + made.active.bodies[0]]
    first = batches.first_body[: count + 1]
    assert sorted(batches.bodies[: first[-1]]) == sorted(awake)
    for n in range(count):
        members = batches.bodies[first[n] : first[n + 1]]
        assert (of_body[members] == n).all()
        assert (np.diff(members) > 0).all()
        assert n == 0 or len(members) <= batches.size[0]
    rows = made.contacts.active.contact[1 : 1 + made.contacts.active.contact[0]]
    touching = world.state.contacts[rows]
    moves = world.state.bodies.inverse_mass > 0.0
    both = moves[touching.body_a] & moves[touching.body_b]
    assert (of_body[touching.body_a] == of_body[touching.body_b])[both].all()
