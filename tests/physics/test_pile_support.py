"""Finer substeps are for piles that stand on something, whatever that is: what falls bears nothing, however high."""

from __future__ import annotations

from dataclasses import replace

import pytest

from sandbox.engine.commands.drags import StartDrag
from sandbox.engine.commands.pushes import ApplyForce
from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody
from tests.flat import AWAKE, body, box, circle, ground, scene, world
from tests.joints.jointed import joint, jointed


def tower(bottom: float, count: int = 40, step: float = 1.0) -> list[FlatBody]:
    return [body(f"b{i}", box(1.0, 1.0), position=(0.0, bottom + 0.5 + step * i)) for i in range(count)]


def levels(w: World) -> set[int]:
    """The substep levels that all but the first body took in the last step."""
    return {int(level) for level in w.scratch.solver.free_motions.substep_level[1:]}


def finer_in(w: World, steps: int) -> int:
    """In how many of these steps some box took finer substeps."""
    finer = 0
    for _ in range(steps):
        w.step()
        finer += any(level > 0 for level in levels(w))
    return finer


@pytest.mark.parametrize("step", [1.0, 0.1])
def test_what_falls_bears_nothing(step: float) -> None:
    w = world(ground(), *tower(5.0, step=step))
    w.step(4)  # in the first step nothing is known, and levels go back one a step
    assert finer_in(w, 50) == 0


def test_what_is_heavy_presses_on_nothing_while_it_falls() -> None:
    """A ball of 2,500 times the mass of those that it falls with, which would take finer substeps to bear it."""
    small = [body(f"b{i}", circle(0.1), position=(0.19 * i, 20.0)) for i in range(8)]
    large = body("large", circle(5.0), position=(0.6, 25.05))
    w = world(ground(), *small, large)
    w.step(4)
    assert finer_in(w, 60) == 0
    w.step(120)  # it has landed on them
    assert finer_in(w, 10) == 10


def test_a_tower_that_has_landed_stands_as_one_that_was_put_down() -> None:
    w = world(ground(), *tower(0.05))
    w.step(4)
    assert finer_in(w, 1) == 0
    w.step(180)  # meanwhile it sways up and down, and does without where it swings up
    assert finer_in(w, 60) == 60
    w.step(360)
    assert abs(w.body("b39").position[0]) < 0.05
    assert abs(w.body("b39").position[1] - 39.5) < 0.1


def test_stiffer_contacts_are_for_what_they_can_hold_up() -> None:
    discs = [body(f"b{i}", circle(0.5), position=(0.0, 0.5 + i)) for i in range(40)]
    assert finer_in(world(ground(), *discs, settings=AWAKE), 60) == 0  # two forces for each, which can roll off
    upright = [replace(disc, fixed_rotation=True) for disc in discs]
    assert finer_in(world(ground(), *upright, settings=AWAKE), 60) >= 50
    rough = [replace(disc, shapes=(replace(disc.shapes[0], rolling_resistance=0.1),)) for disc in discs]
    assert finer_in(world(ground(), *rough, settings=AWAKE), 60) >= 50
    on_a_ball = [discs[0], *(replace(box, position=(0.0, box.position[1] + 1.0)) for box in tower(0.0, 39))]
    assert finer_in(world(ground(), *on_a_ball, settings=AWAKE), 60) >= 50


def test_a_column_of_discs_stands_as_long_as_it_is_straight() -> None:
    discs = [body(f"b{i}", circle(0.5), position=(0.0, 0.5 + i)) for i in range(40)]
    w = world(ground(), *discs, settings=AWAKE)
    w.step(600)
    assert abs(w.body("b39").position[0]) == 0.0
    assert w.body("b39").position[1] == pytest.approx(39.5, abs=0.05)


def test_a_tower_on_a_beam_that_welds_hold_takes_finer_substeps() -> None:
    beam = body("beam", box(8.0, 1.0), position=(0.0, -0.5))
    welds = [joint(f"weld{x}", "weld", None, "beam", (x, -0.5)) for x in (-4.0, 4.0)]
    w = jointed((beam, *tower(0.0)), welds, settings=AWAKE)
    w.step(10)
    assert finer_in(w, 60) == 60
    assert abs(w.body("b39").position[1] - 39.5) < 0.1


def test_a_tower_on_a_raft_that_a_force_carries_takes_finer_substeps() -> None:
    raft = body("raft", box(12.0, 1.0, density=20.0), position=(0.0, -0.5), fixed_rotation=True)
    w = World(scene(raft, *tower(0.0)))
    weight = 9.81 * float(w.state.bodies.mass.sum())
    finer = 0
    for k in range(60):
        w.apply(ApplyForce("raft", (0.0, weight)))
        w.step()
        finer += k >= 10 and min(levels(w)) > 0
    assert finer == 50


def test_a_tower_on_a_raft_that_a_hand_holds_takes_finer_substeps() -> None:
    raft = body("raft", box(12.0, 1.0, density=20.0), position=(0.0, -0.5), fixed_rotation=True)
    w = World(scene(raft, *tower(0.0)))
    w.apply(StartDrag("raft", (0.0, -0.5), max_force=1e6))
    w.step(10)
    finer = 0
    for _ in range(50):
        w.step()
        finer += min(levels(w)) > 0
    assert finer == 50
    assert w.body("raft").position[1] > -2.0


@pytest.mark.parametrize("hinges", [1, 2])
def test_a_tower_bears_what_a_hinged_beam_presses_with(hinges: int) -> None:
    """A tower that does with the usual substeps, and a heavy beam on it that one hinge bears half of, or two bear."""
    beam = body("beam", box(20.0, 0.5, density=2.8), position=(9.5, 16.25))
    pins = [joint(f"pin{k}", "revolute", None, "beam", (19.0 - 9.0 * k, 16.25)) for k in range(hinges)]
    w = jointed((ground(), *tower(0.0, 16), beam), pins, settings=AWAKE)
    w.step(10)
    assert finer_in(w, 60) == (60 if hinges == 1 else 0)
    assert abs(w.body("b15").position[1] - 15.5) < 0.02


@pytest.mark.parametrize("kind", ["revolute", "distance"])
def test_ropes_that_hang_and_touch_bear_nothing(kind: str) -> None:
    """Two ropes of beads, each bead of one against two of the other: it lies on the lower one's shoulder."""
    beads, joints = [], []
    for rope in range(2):
        x, top = 0.84 * rope, 0.5 * rope
        for k in range(20):
            beads.append(body(f"b{rope}-{k}", circle(0.5), position=(x, top - k - 1.0)))
            above = f"b{rope}-{k - 1}" if k > 0 else None
            ends = {"anchor_a": (x, top - k), "anchor_b": (x, top - k - 1.0)} if kind == "distance" else {}
            at = None if ends else (x, top - k - 0.5 * (k > 0))
            joints.append(joint(f"j{rope}-{k}", kind, above, f"b{rope}-{k}", at, **ends))
    w = jointed(tuple(beads), joints, settings=AWAKE)
    w.step(10)
    assert len(w.contacts) > 30
    assert finer_in(w, 60) == 0
