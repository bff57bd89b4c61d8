"""Cases that trip engines: slender stacks, heavy on light, bodies in one place, great distances, a box of gas."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody
from tests.flat import body, box, capsule, circle, ground, polygon, world
from tests.joints.jointed import joint, jointed

FASTEST = 4.0
"""Speed (m/s) that bodies which overlap may get from being pushed apart."""
SHAPES = {
    "box": box(1.0, 1.0),
    "circle": circle(0.5),
    "capsule": capsule(0.5, 0.3),
    "triangle": polygon((-0.5, -0.4), (0.5, -0.4), (0.0, 0.6)),
}


def stack(count: int, size: float = 1.0) -> list[FlatBody]:
    return [body(f"b{i}", box(size, size), position=(0.0, size * (i + 0.5))) for i in range(count)]


def farthest(pile: World, steps: int) -> float:
    """The longest way of a body in so many steps."""
    x, y = pile.state.bodies.center_x.copy(), pile.state.bodies.center_y.copy()
    pile.step(steps)
    return float(np.hypot(pile.state.bodies.center_x - x, pile.state.bodies.center_y - y).max())


def top_speed(crowd: World, steps: int) -> float:
    top = 0.0
    for _ in range(steps):
        crowd.step()
        top = max(top, float(np.hypot(crowd.state.bodies.velocity_x, crowd.state.bodies.velocity_y).max()))
    return top


@pytest.mark.parametrize(("count", "size"), [(20, 1.0), (40, 1.0), (60, 1.0), (20, 0.1), (10, 0.02), (12, 10.0)])
def test_a_stack_stands(count: int, size: float) -> None:
    assert farthest(world(ground(), *stack(count, size)), 600) < 0.05 * size


@pytest.mark.parametrize("size", [0.1, 1.0, 10.0])
@pytest.mark.parametrize("ratio", [10.0, 29.0, 100.0, 1000.0])
def test_a_heavy_box_rests_on_a_light_one(ratio: float, size: float) -> None:
    heavy = body("heavy", box(size, size, density=ratio), position=(0.0, 1.5 * size))
    assert farthest(world(ground(), *stack(1, size), heavy), 600) < 0.05 * size


def drawbridge(ratio: float) -> World:
    """A plank hinged at its left end, as heavy as `ratio` of the boxes of which one lies under its right end."""
    plank = body("plank", box(8.0, 0.5, density=ratio / 4.0), position=(-3.5, 1.25))
    hinge = joint("hinge", "revolute", None, "plank", (-7.4, 1.25))
    return jointed((ground(), *stack(1), plank), (hinge,))


@pytest.mark.parametrize("ratio", [10.0, 100.0, 1000.0])
def test_a_heavy_bridge_that_hangs_by_a_hinge_rests_on_a_light_box(ratio: float) -> None:
    assert farthest(drawbridge(ratio), 600) < 0.05


def test_a_heavy_drum_that_hangs_by_a_joint_costs_what_tumbles_in_it_no_more_substeps() -> None:
    walls = (box(9.0, 0.5, at=(0.0, 4.5)), box(9.0, 0.5, at=(0.0, -4.5)), box(0.5, 9.0, at=(4.5, 0.0)))
    drum = body("drum", *(replace(wall, density=50.0) for wall in (*walls, box(0.5, 9.0, at=(-4.5, 0.0)))))
    places = [(-3.0 + 0.5 * (k % 13), -3.0 + 0.5 * (k // 13)) for k in range(130)]
    crumbs = [body(f"c{k}", box(0.25, 0.25), position=at) for k, at in enumerate(places)]
    motor = joint("motor", "revolute", None, "drum", (0.0, 0.0), motor_speed=0.5, max_torque=1e8)
    tumbling = jointed((drum, *crumbs), (motor,))
    above = 0
    for _ in range(400):
        tumbling.step()
        above += int((tumbling.scratch.solver.free_motions.substep_level[1:] > 0).sum())
    assert above < 0.02 * 400 * len(crumbs)


@pytest.mark.parametrize("count", [4, 40])
def test_contacts_tell_the_impulse_of_a_substep_of_the_scene_however_many_their_island_takes(count: int) -> None:
    tower = world(ground(), *stack(count))
    tower.step(120)
    bottom = tower.contacts[tower.contacts.body_a == 0]
    levels = tower.scratch.solver.free_motions.substep_level
    assert (levels[1:] > 0).all() == (count == 40)
    borne = float(bottom.normal_impulse1.sum() + bottom.normal_impulse2.sum())
    assert borne == pytest.approx(count * 9.81 / 240.0, rel=0.02)


def test_a_tower_bears_four_hundred_times_the_mass_of_its_boxes() -> None:
    heavy = body("heavy", box(1.0, 1.0, density=400.0), position=(0.0, 12.5))
    assert farthest(world(ground(), *stack(12), heavy), 600) < 0.05


def test_more_substeps_for_one_island_change_nothing_for_another() -> None:
    near = [body("ball", circle(0.5), position=(30.0, 3.0), velocity=(1.0, 0.0))]
    alone, beside = world(ground(), *near), world(ground(), *near, *stack(40))
    alone.step(200)
    beside.step(200)
    assert beside.body("ball").position == alone.body("ball").position


def test_what_is_carried_by_a_moving_platform_keeps_its_pace() -> None:
    lift = body("lift", box(4.0, 1.0), type="kinematic", position=(0.0, -0.5), velocity=(0.5, 0.5))
    small = body("small", box(0.5, 0.5), position=(1.5, 0.25), velocity=(0.5, 0.5))
    carried = world(lift, small, *(replace(crate, velocity=(0.5, 0.5)) for crate in stack(25)))
    carried.step(300)
    for name, x in (("small", 1.5), ("b0", 0.0), ("b24", 0.0)):
        assert carried.body(name).position[0] - carried.body("lift").position[0] == pytest.approx(x, abs=0.05)


@pytest.mark.parametrize("name", SHAPES)
def test_two_bodies_in_one_place_part(name: str) -> None:
    pair = world(body("a", SHAPES[name]), body("b", SHAPES[name]), gravity=(0.0, 0.0))
    assert top_speed(pair, 240) < FASTEST
    a, b = pair.state.bodies
    assert math.hypot(a.center_x - b.center_x, a.center_y - b.center_y) > 0.99 * (1.0 if name != "capsule" else 0.6)


@pytest.mark.parametrize("seed", range(4))
def test_a_crowd_in_one_place_parts_without_an_explosion(seed: int) -> None:
    places = np.random.default_rng(seed).uniform((-2.0, 0.5), (2.0, 3.0), (40, 2))
    bodies = [body(f"c{i}", box(1.0, 1.0), position=(float(x), float(y))) for i, (x, y) in enumerate(places)]
    assert top_speed(world(*bodies, gravity=(0.0, 0.0)), 300) < FASTEST


@pytest.mark.parametrize("depth", [0.1, 0.3, 0.5, 0.7, 0.9])
def test_an_overlapping_box_climbs_out(depth: float) -> None:
    pair = world(ground(), *stack(1), body("b", box(1.0, 1.0), position=(0.05, 1.5 - depth)))
    assert top_speed(pair, 300) < FASTEST
    assert pair.body("b").position[1] == pytest.approx(1.5, abs=0.01)


def test_a_pyramid_stands_ten_thousand_kilometres_away_as_it_does_here() -> None:
    def pyramid(x: float, y: float) -> World:
        floor = body("floor", box(60.0, 2.0, (0.0, -1.0)), type="static", position=(x, y))
        rows = ((i, j) for i in range(10) for j in range(10 - i))
        boxes = [body(f"{i}-{j}", box(1.0, 1.0), position=(x + j + 0.5 * i - 4.5, y + i + 0.5)) for i, j in rows]
        return world(floor, *boxes)

    assert farthest(pyramid(0.0, 0.0), 600) < 0.02
    assert farthest(pyramid(1e7, -1e7), 600) < 0.02


@pytest.mark.parametrize("name", ["box", "circle"])
def test_a_gas_keeps_its_energy(name: str) -> None:
    shape = {"box": box(0.9, 0.7, restitution=1.0, friction=0.0), "circle": circle(0.45, restitution=1.0, friction=0.0)}
    walls = [
        body(f"wall{i}", box(*size, restitution=1.0, friction=0.0), type="static", position=at)
        for i, (size, at) in enumerate(
            [
                ((1.0, 22.0), (-10.5, 0.0)),
                ((1.0, 22.0), (10.5, 0.0)),
                ((22.0, 1.0), (0.0, 10.5)),
                ((22.0, 1.0), (0.0, -10.5)),
            ]
        )
    ]
    gas = [
        body(f"m{i}", shape[name], position=(i % 6 * 3.0 - 7.5, i // 6 * 3.0 - 7.5),
             velocity=(3.0 * math.sin(i), 3.0 * math.cos(2.1 * i)))
        for i in range(36)
    ]  # fmt: skip
    closed = world(*walls, *gas, gravity=(0.0, 0.0))
    before = energy(closed)
    closed.step(3600)
    assert energy(closed) == pytest.approx(before, rel=1e-3)


def energy(closed: World) -> float:
    """Kinetic energy in joules."""
    b = closed.state.bodies
    return float((0.5 * b.mass * (b.velocity_x**2 + b.velocity_y**2) + 0.5 * b.inertia * b.angular_velocity**2).sum())
