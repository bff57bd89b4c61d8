"""Whole scenes under comparison: that they agree, and that whatever is spoiled on purpose is found."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.reference import comparison
from sandbox.reference.ask_pymunk import Answers, Probe
from sandbox.reference.comparison import Observer, compare
from sandbox.reference.comparison_result import KEEP, Comparison
from sandbox.resources import find_scene
from sandbox.scene import Scene, load_scene
from tests import flat

SUBSET = [
    ("crates-on-a-ramp", 200), ("newtons-cradle", 300), ("far-away", 120), ("filters", 120), ("mixer", 60),
    ("wrecking-shot", 80), ("tetrominoes", 120), ("pile", 100), ("matchboxes", 100), ("pyramid-30", 5), ("dust", 10),
    ("arch", 60), ("conveyor", 120), ("tumbler", 70),
]  # fmt: skip


@pytest.mark.parametrize(("name", "steps"), SUBSET)
def test_a_shipped_scene_has_no_disagreement_and_no_missed_pair(name: str, steps: int) -> None:
    tally = compare(load_scene(find_scene(Path(name))), steps)
    assert tally.disagreements == []
    assert tally.misses == []
    assert tally.agrees
    assert tally.agreed + tally.touching + tally.pymunk_wrong.total() == tally.pairs > 0
    assert tally.steps == steps


@pytest.mark.parametrize(("name", "steps", "changes"), [("water-wheel", 60, 5), ("chain-reaction", 140, 5)])
def test_steps_at_whose_end_rules_bring_or_delete_bodies_are_left_out(name: str, steps: int, changes: int) -> None:
    tally = compare(load_scene(find_scene(Path(name))), steps)
    assert tally.agrees
    assert tally.misses == []
    assert tally.steps == steps - changes


def test_in_pixels_the_step_may_keep_a_face_by_as_much() -> None:
    """Boxes of 60 pixels that tumble: of two axes that are nearly as good, the step takes that of the first box."""
    bodies: list[dict[str, Any]] = [
        {"id": "floor", "type": "static", "position": [0, -50], "shapes": [{"box": [900, 100]}]}
    ]
    bodies += [
        {
            "id": f"b{k}",
            "position": [62 * (k % 6) - 150, 40 + 70 * (k // 6)],
            "angle": 7 * k,
            "shapes": [{"box": [60, 60]}],
        }
        for k in range(36)
    ]
    tally = compare(Scene(bodies=bodies, gravity=(0, -900)), 150)
    assert tally.pairs > 2000
    assert tally.disagreements == []


def overlapping() -> World:
    """A box and a ball sunk into the ground, and a ball beside, well inside the box's margin."""
    return flat.world(
        flat.ground(),
        flat.body("box", flat.box(1, 1), position=(0, 0.4)),
        flat.body("ball", flat.circle(0.5), position=(3, 0.45)),
    )


def after_step(world: World, spoil: Callable[[World], None]) -> Comparison:
    """What the comparison of one step finds if `spoil` changes what the step left behind."""
    observer, step = Observer(world), World.step
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(World, "step", lambda world, n=1: (step(world, n), spoil(world))[0])
        observer.step()
    return observer.tally


def test_a_sound_step_agrees() -> None:
    tally = after_step(overlapping(), lambda world: None)
    assert (tally.pairs, tally.agreed, tally.missed) == (2, 2, 0)


def test_a_pair_that_the_grid_misses_is_found() -> None:
    def forget(world: World) -> None:
        world.state.counters[0].pair_count -= 1

    tally = after_step(overlapping(), forget)
    assert not tally.agrees
    assert tally.missed == 1
    assert tally.misses[0].names == ("ground", "ball")
    assert tally.misses[0].step == 1


def test_a_pair_of_swept_boxes_that_the_grid_misses_is_found() -> None:
    fast = flat.body("bullet", flat.circle(0.1), position=(0, 5), velocity=(0.0, -600.0))
    world = flat.world(flat.ground(), fast)
    tally = after_step(world, lambda world: world.state.counters.pair_count.fill(0))
    assert tally.pairs == 0
    assert [miss.names for miss in tally.misses] == [("ground", "bullet")]


def test_an_overlap_without_a_contact_is_found() -> None:
    def lose(world: World) -> None:
        world.state.counters[0].contact_count = 1

    tally = after_step(overlapping(), lose)
    assert [found.what for found in tally.disagreements] == ["no contact"]
    assert tally.disagreements[0].names == ("ground", "ball")
    assert tally.disagreements[0].who_is_wrong == "sandbox"


def test_a_contact_along_the_wrong_axis_is_found() -> None:
    def turn(world: World) -> None:
        world.contacts.normal_x[:] = 1.0
        world.contacts.normal_y[:] = 0.0

    tally = after_step(overlapping(), turn)
    assert [found.what for found in tally.disagreements] == ["contact axis"] * 2


def test_a_wrong_depth_of_the_kernel_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    decide = comparison.decide
    monkeypatch.setattr(comparison, "decide", lambda *given: (decide(*given)[0] - 1e-6, decide(*given)[1]))
    tally = compare(overlapping_scene(), 1)
    assert tally.disagreed == 2
    assert {found.who_is_wrong for found in tally.disagreements} == {"sandbox"}
    assert {found.what for found in tally.disagreements} == {"depth or axis"}


def test_an_unexplained_error_of_pymunk_is_a_disagreement(monkeypatch: pytest.MonkeyPatch) -> None:
    def blind(_probe: Probe, _poses: object, pairs: np.ndarray) -> Answers:
        return Answers(np.zeros(len(pairs), bool), np.zeros(len(pairs)), np.zeros((len(pairs), 2)))

    monkeypatch.setattr(Probe, "ask", blind)
    tally = compare(overlapping_scene(), 1)
    assert [(found.what, found.who_is_wrong) for found in tally.disagreements] == [("verdict", "pymunk")] * 2
    assert tally.disagreements[0].theirs.separation is None


def overlapping_scene() -> flat.FlatScene:
    return overlapping().scene  # type: ignore[return-value]


def test_traps_of_pymunk_are_counted_by_name_and_are_no_disagreement() -> None:
    wedge = flat.body("wedge", flat.polygon((0, 0), (4, 0), (0, 4), density=0.0), type="static")
    twins = [flat.body(name, flat.box(1, 1), position=(20, 20)) for name in "ab"]
    ball = flat.body("ball", flat.circle(0.5), position=(-0.375, 4.375))
    tally = compare(flat.scene(wedge, *twins, ball, gravity=(0, 0)), 1)
    assert tally.pymunk_wrong == {"no-axis": 1, "in-line": 1}
    assert tally.agrees


def test_equal_axes_agree_and_are_counted() -> None:
    boxes = [flat.body(name, flat.box(2, 2), position=at) for name, at in (("a", (0, 0)), ("b", (1, 1)))]
    tally = compare(flat.scene(*boxes, gravity=(0, 0)), 1)
    assert tally.agreed == tally.pairs == 1
    assert tally.normal_error == 0.0


def test_every_and_first_choose_the_steps() -> None:
    heard: list[int] = []
    tally = compare(overlapping_scene(), 40, every=10, on_steps=heard.append)
    assert tally.steps == 4
    assert heard == [16, 32]
    assert compare(overlapping_scene(), 40, every=10, first=40).steps == 1


def test_no_more_than_the_limit_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    decide = comparison.decide
    monkeypatch.setattr(comparison, "decide", lambda *given: (decide(*given)[0] - 1e-3, decide(*given)[1]))
    tally = compare(overlapping_scene(), 100)
    assert tally.disagreed > KEEP == len(tally.disagreements)


def test_empty_scenes_are_compared_too() -> None:
    assert compare(flat.scene(), 3) == Comparison(steps=3)
    assert compare(flat.scene(flat.ground()), 3) == Comparison(steps=3)
