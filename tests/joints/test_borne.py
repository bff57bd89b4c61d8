"""Jointed parts that something bears come to rest: furniture welded of planks, and bridges with boxes on them."""

from __future__ import annotations

import math
from dataclasses import replace
from random import Random

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatJoint, FlatSettings
from tests.flat import body, box, ground
from tests.joints.jointed import gap, joint, jointed, largest_gain, row

Furniture = tuple[list[FlatBody], list[tuple[str, str, tuple[float, float]]]]


def plank(name: str, x: float, y: float, width: float, height: float) -> FlatBody:
    return body(name, box(width, height), position=(x, y))


def chair() -> Furniture:
    parts = [
        plank("seat", 0.0, 0.55, 0.9, 0.1), plank("front", -0.35, 0.25, 0.1, 0.5), plank("rear", 0.35, 0.25, 0.1, 0.5),
        plank("back", 0.4, 1.05, 0.1, 0.9),
    ]  # fmt: skip
    return parts, [("seat", "front", (-0.35, 0.5)), ("seat", "rear", (0.35, 0.5)), ("seat", "back", (0.4, 0.6))]


def table() -> Furniture:
    """With a box that weighs twice as much as its top."""
    parts = [
        plank("top", 0.0, 1.05, 2.0, 0.1), plank("left", -0.9, 0.5, 0.1, 1.0), plank("right", 0.9, 0.5, 0.1, 1.0),
        body("box", box(1.0, 1.0, density=0.4), position=(0.0, 1.6)),
    ]  # fmt: skip
    return parts, [("top", "left", (-0.9, 1.0)), ("top", "right", (0.9, 1.0))]


def shelf(boards: int) -> Furniture:
    """A box on each board."""
    parts, joins = [], []
    for k in range(boards):
        y = 1.1 * k
        parts += [plank(f"left{k}", -1.0, y + 0.5, 0.1, 1.0), plank(f"right{k}", 1.0, y + 0.5, 0.1, 1.0)]
        parts.append(plank(f"board{k}", 0.0, y + 1.05, 2.2, 0.1))
        parts.append(body(f"box{k}", box(0.5, 0.5, density=2.0), position=(0.0, y + 1.35)))
        for side, x in (("left", -1.0), ("right", 1.0)):
            joins.append((f"{side}{k}", f"board{k}", (x, y + 1.0)))
            if k:
                joins.append((f"board{k - 1}", f"{side}{k}", (x, y)))
    return parts, joins


FURNITURE = {"chair": chair(), "table": table(), **{f"shelf of {n}": shelf(n) for n in (1, 2, 3)}}


def put_up(name: str, how: str, rate: int, sleeping: bool) -> World:
    """Welded, or with hinges whose stops leave them no angle."""
    parts, joins = FURNITURE[name]
    stops = {} if how == "weld" else {"lower": 0.0, "upper": 0.0}
    joints: tuple[FlatJoint, ...] = tuple(joint(f"{a}-{b}", how, a, b, at, **stops) for a, b, at in joins)
    settings = FlatSettings(step_rate=rate, sleeping=sleeping)
    return jointed((ground(friction=0.5), *parts), joints, settings=settings)


def fastest(w: World, steps: int) -> float:
    """Speed (m/s) of the fastest body in so many steps; turning counts for half a metre."""
    highest = 0.0
    for _ in range(steps):
        w.step()
        b = w.state.bodies
        speeds = np.hypot(b.velocity_x, b.velocity_y) + 0.5 * np.abs(b.angular_velocity)
        highest = max(highest, float(speeds.max()))
    return highest


@pytest.mark.parametrize("rate", [30, 60, 120])
@pytest.mark.parametrize("how", ["weld", "revolute"])
@pytest.mark.parametrize("name", FURNITURE)
def test_furniture_stands_still(name, how, rate):
    w = put_up(name, how, rate, sleeping=False)
    names = [part.id for part in FURNITURE[name][0]]
    w.step(rate)
    stood = {each: w.body(each).position for each in names}
    w.step(9 * rate)
    assert fastest(w, rate) < 1e-3
    assert max(math.dist(w.body(each).position, stood[each]) for each in names) < 1e-3
    assert gap(w) < 1e-3


@pytest.mark.parametrize("rate", [30, 60, 120])
@pytest.mark.parametrize("how", ["weld", "revolute"])
@pytest.mark.parametrize("name", FURNITURE)
def test_furniture_falls_asleep(name, how, rate):
    w = put_up(name, how, rate, sleeping=True)
    w.step(5 * rate)
    assert not any(w.body(part.id).awake for part in FURNITURE[name][0])


BRIDGES = [(12, 10, 1.0), (12, 10, 2.0), (12, 6, 1.0), (16, 8, 1.0), (20, 2, 1.0), (20, 10, 2.0), (20, 0, 1.0)]


@pytest.mark.parametrize(("planks", "boxes", "density"), BRIDGES)
def test_a_loaded_bridge_hardly_moves(planks, boxes, density):
    """Straight, without slack; boxes are put down 5 cm above it."""
    parts = [
        body(f"p{k}", box(1.0, 0.2, friction=0.8, density=density), position=(float(k), 0.0)) for k in range(planks)
    ]
    ends = [None, *(part.id for part in parts), None]
    joints = [joint(f"j{k}", "revolute", ends[k], ends[k + 1], (k - 0.5, 0.0)) for k in range(planks + 1)]
    places = [0.5 * (planks - boxes) + k for k in range(boxes)]
    loads = [body(f"box{k}", box(0.9, 0.9, friction=0.8, density=2.0), position=(x, 0.6)) for k, x in enumerate(places)]
    w = jointed((*parts, *loads), tuple(joints))
    w.step(1200)
    assert fastest(w, 60) < 0.2
    assert all(w.body(load.id).position[1] > -1.0 for load in loads)
    assert gap(w) < 0.01


def bridge(planks: int, **hinge: float) -> World:
    """Straight, held at both ends, with three crates that fall on it."""
    bodies, hinges = row(planks, pin="both")
    crates = [body(f"c{k}", box(0.8, 0.8), position=(planks * (k + 1) / 4, 3.0 + k)) for k in range(3)]
    return jointed((*bodies, *crates), tuple(replace(one, **hinge) for one in hinges))


@pytest.mark.parametrize("stops", [{}, {"lower": -0.3, "upper": 0.3}], ids=["free", "stops"])
@pytest.mark.parametrize("torque", [0.5, 5.0])
@pytest.mark.parametrize("planks", [6, 12])
def test_a_bridge_of_hinges_with_friction_takes_up_what_falls_on_it(planks, torque, stops):
    """While it passes straight its rows say nearly the same, and only enormous impulses would hold it."""
    world = bridge(planks, motor_speed=0.0, max_motor=torque, **stops)
    fall = 9.81 * 0.64 * (3.0 + 4.0 + 5.0)
    assert largest_gain(world, 300) < 0.1 * fall


def mesh(seed: int) -> World:
    """Four planks in a closed loop of hinges with stops and friction, let go somewhere above the ground."""
    random = Random(seed)
    height = random.choice([0.6, 2.0, 6.0])
    places = [(float(i), height + j) for i in range(2) for j in range(2)]
    planks = [
        body(
            f"p{k}", box(*random.choice([(0.7, 0.4), (0.4, 0.7)]), density=10 ** random.uniform(-1, 1)), position=place
        )
        for k, place in enumerate(places)
    ]
    hinges = []
    for one, other in ((0, 2), (0, 1), (1, 3), (2, 3)):
        at = 0.5 * (places[one][0] + places[other][0]), 0.5 * (places[one][1] + places[other][1])
        drive = {"lower": -0.35, "upper": 0.35, "motor_speed": 0.0, "max_motor": 10 ** random.uniform(-1, 2)}
        hinges.append(joint(f"j{len(hinges)}", "revolute", f"p{one}", f"p{other}", at, **drive))
    return jointed((ground(), *planks), tuple(hinges))


@pytest.mark.parametrize("seed", [21, 62, 133, 189, 196])
def test_stops_of_a_loop_give_nothing_where_it_is_not_found_which_of_them_hold(seed):
    """Its rows say nearly the same, so that a wrong guess may ask them for anything."""
    world = mesh(seed)
    weight = 9.81 * float(world.state.bodies.mass[1:].sum())
    assert largest_gain(world, 200) < 1.0 * weight
