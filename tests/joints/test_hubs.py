"""Many joints on one light body: what each of them pushes, all others have to take back."""

from __future__ import annotations

import math

import pytest

from sandbox.engine.joints import part_layout
from sandbox.engine.world import World
from sandbox.scene.flat import FlatSettings, Vec
from tests.flat import body, box, circle
from tests.joints.jointed import G, energy, joint, jointed


def on_circle(radius: float, turn: float) -> Vec:
    return radius * math.cos(turn), radius * math.sin(turn)


def ferris_wheel(cabins: int, settings: FlatSettings, ratio: float = 7.0, speed: float = 0.3) -> World:
    """Cabins of 23 kg hang from a wheel that turns freely about its middle; they have `ratio` times its mass."""
    places = [on_circle(8.0, math.tau * k / cabins) for k in range(cabins)]
    density = 23.0 / ratio * cabins / (math.pi * 64.0)
    wheel = body("wheel", circle(8.0, density=density, mask=0), angular_velocity=speed)
    hung = [
        body(f"c{k}", box(1.0, 1.0, density=23.0, mask=0), position=(x, y - 0.6)) for k, (x, y) in enumerate(places)
    ]
    hinges = [joint(f"h{k}", "revolute", "wheel", f"c{k}", place) for k, place in enumerate(places)]
    return jointed((wheel, *hung), (joint("axle", "revolute", None, "wheel", (0.0, 0.0)), *hinges), settings=settings)


def spoked_wheel(spokes: int, settings: FlatSettings) -> World:
    """A rim of hinged links on rods about a hub that is held, turning."""
    rim, hub, step = 2.0, 0.3, math.tau / spokes
    corners = [on_circle(rim, step * (k - 0.5)) for k in range(spokes + 1)]
    bodies = [body("hub", circle(hub, density=1.0 / (math.pi * hub * hub), mask=0), angular_velocity=2.0)]
    joints = [joint("axle", "revolute", None, "hub", (0.0, 0.0))]
    for k in range(spokes):
        (ax, ay), (bx, by) = corners[k], corners[k + 1]
        middle = 0.5 * (ax + bx), 0.5 * (ay + by)
        length = math.dist(corners[k], corners[k + 1])
        link = box(length, 0.1, density=0.05 / (0.1 * length), mask=0)
        bodies.append(body(f"l{k}", link, position=middle, angle=step * k + 0.5 * math.pi))
        joints.append(joint(f"rim{k}", "revolute", f"l{(k - 1) % spokes}", f"l{k}", corners[k]))
        joints.append(
            joint(f"spoke{k}", "distance", "hub", f"l{k}", anchor_a=on_circle(hub, step * k), anchor_b=middle)
        )
    return jointed(tuple(bodies), tuple(joints), settings=settings)


def apart(world: World) -> float:
    """Largest distance (m) of the anchors of any hinge."""
    hinges = [name for name in world.joint_names if not name.startswith("spoke")]
    return max(math.dist(*world.joint(name).anchors) for name in hinges)


@pytest.mark.parametrize(("rate", "substeps"), [(60, 4), (60, 8), (60, 16), (240, 4), (240, 8)])
@pytest.mark.parametrize(
    ("wheel", "parts"), [(ferris_wheel, 16), (ferris_wheel, 30), (spoked_wheel, 60), (spoked_wheel, 100)]
)
def test_a_net_about_a_light_hub_gains_no_energy_at_any_rate(monkeypatch, wheel, parts, rate, substeps):
    monkeypatch.setattr(part_layout, "UPDATES_A_ROW", -1000)
    world = wheel(parts, FlatSettings(step_rate=rate, substeps=substeps, sleeping=False))
    begin = energy(world)
    for _ in range(2 * rate):
        world.step()
        assert energy(world) < begin + 0.01 * abs(begin)
    assert apart(world) < 0.1


@pytest.mark.parametrize("ratio", [1.0, 20.0, 1e3])
@pytest.mark.parametrize("cabins", [8, 16, 60])
def test_a_wheel_stands_still_under_any_load(cabins, ratio):
    world = ferris_wheel(cabins, FlatSettings(sleeping=False), ratio, 0.0)
    begin = energy(world)
    for _ in range(300):
        world.step()
        assert energy(world) - begin < 1e-9 * cabins * 23.0 * G
    assert apart(world) < 1e-4
