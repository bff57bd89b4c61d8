"""Closed chains hold what is in them: one-sided and two-sided ones, whatever presses and however fast it comes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

import sandbox
from tests.examples import examples

Points = list[tuple[float, float]]


def circle_of(count: int, *radii: float) -> Points:
    """Points around the origin, counter-clockwise, at these distances in turn."""
    angles = [2.0 * math.pi * k / count for k in range(count)]
    return [(radii[k % len(radii)] * math.cos(a), radii[k % len(radii)] * math.sin(a)) for k, a in enumerate(angles)]


CONTAINERS: dict[str, Points] = {
    "round": circle_of(72, 3.0),
    "twelve sides": circle_of(12, 3.0),
    "box": [(-3, -3), (3, -3), (3, 3), (-3, 3)],
    "box of short links": [(-3 + 0.5 * k, -3) for k in range(12)]
    + [(3, -3 + 0.5 * k) for k in range(12)]
    + [(3 - 0.5 * k, 3) for k in range(12)]
    + [(-3, 3 - 0.5 * k) for k in range(12)],
    "star": circle_of(10, 3.0, 1.7),
}
KINDS: dict[str, dict[str, Any]] = {
    "ball": {"circle": 0.15},
    "box": {"box": [0.3, 0.3]},
    "pill": {"capsule": [[-0.15, 0], [0.15, 0]], "radius": 0.1},
    "triangle": {"polygon": [[-0.21, -0.12], [0.21, -0.12], [0, 0.24]]},
    "rod": {"box": [0.8, 0.04]},
    "needle": {"capsule": [[-0.4, 0], [0.4, 0]], "radius": 0.01},
}
STIFF = {"friction": 0, "density": 50}
PRESSES: dict[str, dict[str, Any]] = {
    "blade": {"shapes": [{"box": [0.2, 3.2], **STIFF}]},
    "piston": {"velocity": (0, -40), "shapes": [{"box": [1.8, 0.5], "density": 2000}]},
    "plunger": {"type": "kinematic", "position": (0, 1), "velocity": (0, -2), "shapes": [{"box": [1.8, 0.4]}]},
}
names = st.sampled_from


def inside(outline: Points, places: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which places lie within an outline: a ray to the right crosses it an odd number of times."""
    starts, ends = np.array(outline), np.roll(outline, -1, axis=0)
    x, y = places[:, :1], places[:, 1:]
    rise = np.where(starts[:, 1] == ends[:, 1], 1.0, ends[:, 1] - starts[:, 1])  # a level link is not crossed
    reached = x < starts[:, 0] + (y - starts[:, 1]) * (ends[:, 0] - starts[:, 0]) / rise
    crossed = ((starts[:, 1] > y) != (ends[:, 1] > y)) & reached
    odd: NDArray[np.bool_] = crossed.sum(axis=1) % 2 == 1
    return odd


def gaps(outline: Points, places: NDArray[np.float64]) -> NDArray[np.float64]:
    """Distance of places from an outline."""
    starts = np.array(outline)
    along, away = np.roll(outline, -1, axis=0) - starts, places[:, None] - starts
    share = np.clip((away * along).sum(axis=2) / (along * along).sum(axis=1), 0.0, 1.0)
    apart = away - share[:, :, None] * along
    nearest: NDArray[np.float64] = np.hypot(apart[:, :, 0], apart[:, :, 1]).min(axis=1)
    return nearest


def places_within(outline: Points, count: int, away: float, rng: np.random.Generator) -> NDArray[np.float64]:
    """Places within an outline, at least so far from it."""
    found: list[NDArray[np.float64]] = []
    while len(found) < count:
        place = rng.uniform(-3.0, 3.0, (1, 2))
        if inside(outline, place)[0] and gaps(outline, place)[0] > away:
            found.append(place[0])
    return np.array(found)


def crowd(outline: Points, kinds: list[str], count: int, speed: float, away: float, seed: int) -> list[dict[str, Any]]:
    """Bodies thrown about within an outline."""
    rng = np.random.default_rng(seed)
    bodies = []
    for k, (x, y) in enumerate(places_within(outline, count, away, rng)):
        heading, fast = rng.uniform(0.0, 2.0 * math.pi), speed * rng.uniform(0.3, 1.0)
        surface = {"friction": 0.2 * (k % 2), "restitution": 0.8 * (seed % 2) * (k % 3 == 0)}
        bodies.append(
            {
                "id": f"body-{k}",
                "shapes": [KINDS[kinds[k % len(kinds)]] | surface],
                "position": (float(x), float(y)),
                "angle": float(rng.uniform(0.0, 360.0)),
                "velocity": (float(fast * math.cos(heading)), float(fast * math.sin(heading))),
                "angular_velocity": float(rng.uniform(-3000.0, 3000.0)),
            }
        )
    return bodies


def world_of(outline: Points, one_sided: bool, crowd: list[dict[str, Any]], press: str | None = None) -> sandbox.World:
    """The crowd, rows 1 and on, in a closed chain; a press, if any, comes last."""
    chain = {"chain": outline, "closed": True, "one_sided": one_sided, "friction": 0.1}
    bodies = [{"id": "container", "type": "static", "shapes": [chain]}, *crowd]
    joints = []
    if press is not None:
        bodies.append({"id": "press", **PRESSES[press]})
    if press == "blade":
        ends = ["container", "press"]
        joints.append({"id": "motor", "type": "revolute", "bodies": ends, "anchor": [0, 0], "motor_speed": 600})
    return sandbox.World(sandbox.Scene(bodies=bodies, joints=joints, settings={"sleeping": False}))


def keep(world: sandbox.World, outline: Points, count: int, steps: int) -> None:
    """Step; nobody of the crowd may be outside at any step."""
    for step in range(steps):
        world.step()
        held = inside(outline, world.bodies.center[1 : 1 + count])
        assert held.all(), f"body-{held.argmin()} is outside after step {step + 1}"


both_sorts = pytest.mark.parametrize("one_sided", [True, False])


@both_sorts
@pytest.mark.parametrize("press", PRESSES)
@pytest.mark.parametrize("container", CONTAINERS)
def test_a_press_drives_nobody_out(container, press, one_sided):
    """What is pressed in slides from link to link, sunk in as it is."""
    outline = CONTAINERS[container]
    bodies = crowd(outline, ["pill", "ball", "box", "triangle"], 70, 1.0, 0.3, 1)
    keep(world_of(outline, one_sided, bodies, press), outline, len(bodies), 75 if press == "plunger" else 150)


@both_sorts
@pytest.mark.parametrize("speed", [pytest.param(10.0, marks=pytest.mark.slow), 100.0, 1000.0, 3000.0])
@pytest.mark.parametrize("container", CONTAINERS)
def test_nobody_is_fast_enough_to_leave(container, speed, one_sided):
    outline = CONTAINERS[container]
    for seed in range(2):
        bodies = crowd(outline, list(KINDS), 40, speed, 0.45, seed)
        keep(world_of(outline, one_sided, bodies), outline, len(bodies), 90)


@examples(30)
@given(
    names(sorted(CONTAINERS)), st.booleans(), st.lists(names(sorted(KINDS)), min_size=1, max_size=3),
    st.floats(0.0, 3.0), st.sampled_from([None, *PRESSES]), st.integers(0, 10_000),
)  # fmt: skip
def test_who_begins_in_the_chain_with_its_centre_inside_stays_there(container, one_sided, kinds, power, press, seed):
    outline = CONTAINERS[container]
    bodies = crowd(outline, kinds, 40, 10.0**power, 0.001, seed)
    keep(world_of(outline, one_sided, bodies, press), outline, len(bodies), 40)


@pytest.mark.slow
@both_sorts
def test_nobody_leaves_a_great_spinner(one_sided):
    outline = circle_of(180, 6.0)
    rng = np.random.default_rng(7)
    angles, radii = rng.uniform(0.0, 2.0 * math.pi, 900), 5.4 * np.sqrt(rng.uniform(0.05, 1.0, 900))
    bodies = crowd(CONTAINERS["round"], ["pill", "ball", "box"], 900, 1.0, 0.3, 3)
    for each, angle, radius in zip(bodies, angles, radii, strict=True):
        each["position"] = (float(radius * math.cos(angle)), float(radius * math.sin(angle)))
    world = world_of(outline, one_sided, bodies, "blade")
    keep(world, outline, len(bodies), 600)


def over_chain(height: float, shape: dict[str, Any], **fields: Any) -> sandbox.World:
    """A body over, or in, a flat one-sided chain of short links, y = 0."""
    chain = {"chain": [(0.25 * k - 5.0, 0.0) for k in range(81)], "one_sided": True, "friction": 0}
    body = {"id": "body", "position": (0.1, height), "shapes": [shape | {"friction": 0}], **fields}
    bodies = [{"id": "chain", "type": "static", "shapes": [chain]}, body]
    return sandbox.World(sandbox.Scene(bodies=bodies, settings={"sleeping": False}))


@pytest.mark.parametrize(("kind", "half"), [("ball", 0.15), ("box", 0.15), ("pill", 0.1), ("rod", 0.02)])
@pytest.mark.parametrize("speed", [0.0, 3.0, 60.0, 600.0])
def test_what_is_sunk_in_slides_from_link_to_link_and_comes_up(kind, half, speed):
    for share in (0.1, 0.5, 0.9):
        world = over_chain((1.0 - share) * half, KINDS[kind], velocity=(speed, 0.0))
        while world.body("body").position[0] < 9.0 and world.step_count < 90:
            world.step()
            assert world.body("body").position[1] > 0.9 * (1.0 - share) * half
        if world.step_count == 90:
            assert world.body("body").position[1] == pytest.approx(half, abs=2e-3)


def test_on_the_way_up_a_chain_lets_through_and_then_it_holds_what_is_more_than_half_through():
    """At 4.6 m/s the middle of the box comes 8 cm past the chain, at 4.2 m/s it stays 10 cm short."""
    for speed, held in ((4.6, True), (4.2, False)):
        world = over_chain(-1.0, {"box": [0.6, 0.6]}, velocity=(0.0, speed))
        free = sandbox.World(sandbox.Scene(bodies=[{"id": "body", "position": (0.1, -1.0), "shapes": [{"circle": 1}],
                                                    "velocity": (0.0, speed)}]))  # fmt: skip
        for _ in range(22):
            world.step()
            free.step()
            assert world.body("body").position == free.body("body").position
        world.step(150)
        assert (world.body("body").position[1] == pytest.approx(0.3, abs=2e-3)) == held
        assert held or world.body("body").position[1] < -5.0


@both_sorts
@pytest.mark.parametrize("link", [2.0, 0.3, pytest.param(0.05, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("count", "drop"), [(1, 0.0), (1, 0.5), (1, 3.0), (10, 0.02)])
def test_boxes_that_have_landed_on_a_chain_lie_at_its_surface(link, count, drop, one_sided):
    """But for what a soft contact yields under each box of the load."""
    chain = {"chain": [(link * k - 4.0, 0.0) for k in range(round(8.0 / link) + 1)], "one_sided": one_sided}
    bodies: list[dict[str, Any]] = [{"id": "chain", "type": "static", "shapes": [chain]}]
    for k in range(count):
        bodies.append({"id": f"box-{k}", "position": (0.013, 0.3 + drop + 0.61 * k), "shapes": [{"box": [0.6, 0.6]}]})
    world = sandbox.World(sandbox.Scene(bodies=bodies, settings={"sleeping": False}))
    world.step(180)
    lowest = world.state.bodies[1]
    tilt = 0.3 * (abs(float(lowest.rotation_sin)) + float(lowest.rotation_cos) - 1.0)
    assert float(lowest.center_y) - 0.3 - tilt == pytest.approx(0.0, abs=1e-4 * count)
