"""Scenes under the simple solver: beside the engine, in closed forms, and what is refused."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.reference.simple.techniques import SWITCHES, Techniques
from sandbox.reference.simple.world import SimpleWorld
from sandbox.reference.twin import simulate_twin
from sandbox.resources import find_scene
from sandbox.scene import load_scene
from sandbox.scene.flat import FlatScene, FlatSettings, FlatThruster
from tests import flat


def both(scene: FlatScene, steps: int) -> tuple[np.ndarray, np.ndarray]:
    """Poses (x, y, angle) of all bodies after some steps, in the engine and here."""
    world, simple = World(scene), SimpleWorld(scene)
    world.state.counters["step_count"] = 1  # past the step that finds how long springs are: simple ones have no length
    world.step(steps)
    simple.step(steps)
    return tuple(
        np.stack([rows.center_x, rows.center_y, rows.angle], axis=1) for rows in (world.state.bodies, simple.records())
    )  # type: ignore[return-value]


@pytest.mark.parametrize(
    ("name", "steps", "most"), [("stack-12", 90, 0.01), ("ramp", 60, 0.01), ("rolling-race", 60, 0.01)]
)
def test_scenes_go_as_in_the_engine(name: str, steps: int, most: float) -> None:
    ours, theirs = both(load_scene(find_scene(Path(name))).flatten(), steps)
    assert np.abs(ours - theirs).max() < most


@pytest.mark.slow
def test_a_twin_of_a_pyramid_stays_beside_the_engine() -> None:
    twin = simulate_twin(load_scene(find_scene(Path("pyramid-10"))), 60, every=6, name="simple")
    assert (twin.name, twin.label) == ("simple", "simple solver")
    for ours, theirs in zip(twin.ours, twin.theirs, strict=True):
        assert theirs.height == pytest.approx(ours.height, abs=2e-3)
        assert theirs.top == pytest.approx(ours.top, abs=5e-3)
        assert theirs.penetration < 0.005
        assert theirs.energy == pytest.approx(ours.energy, rel=5e-3)


def test_all_shapes_rest_where_they_have_to() -> None:
    low, high = flat.box(0.2, 0.4, (-0.5, 0.0)), flat.box(0.2, 0.4, (0.5, 0.0))
    scene = flat.scene(
        flat.ground(),
        flat.body("ball", flat.circle(0.5), position=(-8, 0.6)),
        flat.body("crate", flat.box(1, 1), position=(-4, 0.6)),
        flat.body("pill", flat.capsule(0.5, 0.25), position=(0, 0.3)),
        flat.body("wedge", flat.polygon((-0.5, 0.0), (0.5, 0.0), (0.0, 0.6)), position=(4, 0.05)),
        flat.body("table", low, high, flat.box(1.4, 0.1, (0.0, 0.25)), position=(8, 0.3)),
    )
    world = SimpleWorld(scene)
    world.step(60)
    bottoms = {"ball": 0.5, "crate": 0.5, "pill": 0.25, "wedge": 0.2, "table": None}
    for (name, bottom), body in zip(bottoms.items(), world.bodies[1:], strict=True):
        assert abs(body.velocity) < 0.02, name
        assert abs(body.angle) < 1e-3, name
        if bottom is not None:
            assert body.center.imag == pytest.approx(bottom, abs=2e-3), name


def test_a_ball_bounces_as_high_as_its_restitution_says() -> None:
    world = SimpleWorld(
        flat.scene(flat.ground(), flat.body("ball", flat.circle(0.5, restitution=0.8), position=(0, 2.5)))
    )
    heights = []
    for _ in range(120):
        world.step()
        heights.append(world.bodies[1].center.imag)
    low = int(np.argmin(heights))
    assert max(heights[low:]) - 0.5 == pytest.approx(0.64 * 2.0, rel=0.08)


def test_belts_lifts_and_filters() -> None:
    scene = flat.scene(
        flat.body("belt", flat.box(40, 2, (0.0, -1.0), surface_speed=2.0), type="static"),
        flat.body("lift", flat.box(4, 0.5), type="kinematic", position=(-8, 4.0), velocity=(0.0, 1.0)),
        flat.body("carried", flat.box(1, 1), position=(0, 0.5)),
        flat.body("lifted", flat.box(1, 1), position=(-8, 4.75)),
        flat.body("ghost", flat.box(1, 1, mask=0), position=(4, 0.5)),
    )
    world = SimpleWorld(scene)
    world.step(60)
    lift, carried, lifted, ghost = world.bodies[1:]
    assert lift.center == pytest.approx(-8 + 5j)
    assert carried.velocity == pytest.approx(2.0 + 0j, abs=0.02)
    assert lifted.center == pytest.approx(-8 + 5.75j, abs=2e-3)
    assert ghost.center.imag == pytest.approx(0.5 - 0.5 * 9.81, abs=0.05)


def test_damping_and_weightless_bodies() -> None:
    still = flat.body("a", flat.circle(1), gravity_scale=0.0, linear_damping=0.5, angular_damping=2.0,
                      velocity=(3.0, 0.0), angular_velocity=4.0)  # fmt: skip
    world = SimpleWorld(flat.scene(still))
    world.step(60)
    (body,) = world.bodies
    assert body.velocity == pytest.approx(3.0 * math.exp(-0.5))
    assert body.angular == pytest.approx(4.0 * math.exp(-2.0))


def test_it_takes_the_techniques_of_the_scene() -> None:
    assert Techniques.of(flat.scene(settings=FlatSettings())) == Techniques()
    for name in SWITCHES:
        settings = FlatSettings(substeps=7, **{name: False})
        assert Techniques.of(flat.scene(settings=settings)) == Techniques(substeps=7, **{name: False})


def test_what_it_cannot_step_is_named() -> None:
    gate = flat.body("gate", flat.box(1, 1, sensor=True), flat.box(1, 1, sensor=True), type="static")
    rocket = flat.body("rocket", flat.box(1, 1, one_way=(0.0, 1.0)), thrusters=(FlatThruster((0.0, 1.0)),))
    with pytest.raises(SandboxError, match=r"1 thruster and 2 sensors and 1 one-way shape$"):
        SimpleWorld(flat.scene(gate, rocket))
    with pytest.raises(SandboxError, match=r"this scene has \d+ joints"):
        SimpleWorld(load_scene(find_scene(Path("ragdolls"))))
    with pytest.raises(SandboxError, match=r"this scene has 1 region"):
        SimpleWorld(load_scene(find_scene(Path("planets"))))
