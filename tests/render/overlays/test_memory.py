from __future__ import annotations

import pytest

from sandbox.engine.world import World
from sandbox.render.overlays.memory import grid_cells, proposed_pairs, step_boxes
from tests.naive.grid import Box, all_pairs
from tests.render.overlays.looks import GROUND, crate, look_at, shipped_world, world_of

SCENES = ["pile", "dust", "galton-board", "crates-on-a-ramp"]
CALM = ["pile", "crates-on-a-ramp", "pyramid-10"]
"""Scenes in which continuous collision never widens a box after the pairs are found."""


@pytest.mark.parametrize("scene", CALM)
def test_boxes_hold_their_shapes(scene: str) -> None:
    look = look_at(shipped_world(scene, 40))
    boxes, _ = step_boxes(look)
    tight = look.shape_boxes
    assert (boxes[:, :2] <= tight[:, :2] + 1e-2).all()
    assert (boxes[:, 2:] >= tight[:, 2:] - 1e-2).all()


@pytest.mark.parametrize("scene", CALM)
def test_pairs_are_those_whose_boxes_overlap(scene: str) -> None:
    look = look_at(shipped_world(scene, 40))
    boxes, _ = step_boxes(look)
    filters = look.world.scratch.colliders.filters[: len(boxes)]
    naive = [
        Box(
            tuple(box[:2]),
            tuple(box[2:]),
            int(own.body),
            bool(own.moves & 4),
            int(own.category),
            int(own.mask),
            int(own.group),
        )
        for box, own in zip(boxes.tolist(), filters, strict=False)
    ]
    joined = look.world.scratch.joint_filter.bonds.shape[0]
    found = set(map(tuple, proposed_pairs(look).tolist()))
    assert found
    assert joined == 0
    assert found == set(all_pairs(naive))


@pytest.mark.parametrize("scene", SCENES)
def test_after_a_step_all_boxes_are_of_this_time(scene: str) -> None:
    assert step_boxes(look_at(shipped_world(scene, 40)))[1].all()


def tiles() -> World:
    """Many tiles of 3 m, which have a grid of their own, and crates on them, most of which sleep."""
    floor = [
        {"id": f"tile-{k}", "type": "static", "shapes": [{"box": [3, 3]}], "position": [3 * k, -1.5]} for k in range(70)
    ]
    crates = [crate(f"crate-{k}", 2.5 * k, 0.5) for k in range(80)]
    return world_of(*floor, *crates, crate("late", 4.0, 60.0), steps=120)


@pytest.mark.parametrize("scene", [*CALM, "tiles"])
def test_every_shape_is_in_one_cell_that_holds_the_middle_of_its_box(scene: str) -> None:
    look = look_at(tiles() if scene == "tiles" else shipped_world(scene, 40))
    assert scene != "tiles" or 0 < look.world.scratch.active.info[0].moving < 10
    cells, (boxes, _) = grid_cells(look), step_boxes(look)
    assert cells.count.sum() == len(boxes)
    middle = 0.5 * (boxes[:, :2] + boxes[:, 2:])
    size = (boxes[:, 2:] - boxes[:, :2]).max(axis=1)
    for point, own in zip(middle, size.tolist(), strict=True):
        inside = (cells.low <= point).all(axis=1) & (point <= cells.high).all(axis=1)
        wide = (cells.high - cells.low)[:, 0] >= own
        assert (inside & wide).any()


def test_before_the_first_step_and_after_a_restore_no_box_is_trusted_that_is_elsewhere() -> None:
    world = world_of(GROUND, crate("a", 0, 30), crate("b", 4, 0.6))
    assert not step_boxes(look_at(world))[1].any()
    start = world.snapshot()
    world.step(60)
    world.restore(start)
    trusted = step_boxes(look_at(world))[1]
    assert trusted.tolist() == [True, False, False]
    assert {0, 1} not in map(set, proposed_pairs(look_at(world)).tolist())
