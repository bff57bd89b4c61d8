"""Springs swing on, and are damped as they say, whatever their bodies lie on, bear or push."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sandbox

G = 9.81
SECONDS = 10
Words = dict[str, object]


def heights(world: sandbox.World, name: str, axis: int) -> list[float]:
    found = []
    for _ in range(60 * SECONDS):
        world.step()
        found.append(world.body(name).position[axis])
    return found


def last_swing(places: list[float], seconds: float = 2.0) -> float:
    """Half of the way from lowest to highest at the end."""
    last = places[-round(60 * seconds) :]
    return 0.5 * (max(last) - min(last))


SPRINGS: dict[str, Words] = {
    "distance": {"type": "distance", "bodies": [None, "mass"], "anchors": [[-5, 0.25], [0, 0.25]]},
    "slide": {"type": "prismatic", "bodies": ["mass"], "anchor": [0, 0.25], "axis": [1, 0]},
    "weld": {"type": "weld", "bodies": ["mass"], "anchor": [0, 0.25], "damping_ratio": 0},
    "target": {"type": "target", "bodies": ["mass"], "anchor": [0, 0.25], "target": [0, 0.25], "damping_ratio": 0},
    "motor": {"type": "motor", "bodies": ["mass"], "anchor": [0, 0.25], "damping_ratio": 0},
}


@pytest.mark.parametrize("hertz", [0.5, 1.0, 3.0])
@pytest.mark.parametrize("kind", SPRINGS)
def test_a_mass_on_a_table_keeps_its_swing(kind, hertz):
    table = {"id": "table", "type": "static", "shapes": [{"box": [60, 1], "friction": 0}], "position": [0, -0.5]}
    mass = {"id": "mass", "shapes": [{"box": [0.5, 0.5], "friction": 0}], "position": [0, 0.25], "velocity": [1, 0]}
    joint = {"id": "spring", "hertz": hertz, **SPRINGS[kind]}
    world = sandbox.World(sandbox.Scene(bodies=[table, mass], joints=[joint], settings={"sleeping": False}))
    swing = 1.0 / (2.0 * math.pi * hertz)
    assert last_swing(heights(world, "mass", 0)) == pytest.approx(swing, rel=0.015)


@pytest.mark.parametrize("load", [0.1, 1.0, 10.0])
@pytest.mark.parametrize("hertz", [1.0, 3.0])
def test_a_pan_with_a_load_keeps_its_swing(load, hertz):
    """Not so far that the load leaves it."""
    sag = (1.0 + load) * G / (2.0 * math.pi * hertz) ** 2
    y = -0.7 * sag
    pan = {"id": "pan", "shapes": [{"box": [1, 0.2]}], "mass": 1, "position": [0, y], "fixed_rotation": True}
    box = {"id": "load", "shapes": [{"box": [0.3, 0.3]}], "mass": load, "position": [0, y + 0.25]}
    spring = {
        "id": "s", "type": "distance", "bodies": [None, "pan"], "anchors": [[0, 3], [0, y]], "length": 3,
        "hertz": hertz,
    }  # fmt: skip
    world = sandbox.World(sandbox.Scene(bodies=[pan, box], joints=[spring], settings={"sleeping": False}))
    swing = last_swing(heights(world, "pan", 1), 4.0)
    assert 0.95 * 0.3 * sag < swing < 1.02 * 0.3 * sag
    assert abs(world.body("load").position[1] - world.body("pan").position[1] - 0.25) < 1e-3


@pytest.mark.parametrize("damping", [0.0, 0.05, 0.3])
@pytest.mark.parametrize("hertz", [1.0, 3.0])
def test_the_heave_of_a_car_is_damped_as_its_springs_say(damping, hertz):
    body, wheel = 10.0, 1.0
    together = body * wheel / (body + wheel)  # which a spring's hertz and damping ratio count with
    omega = 2.0 * math.pi * hertz
    sag = body * G / (2.0 * together * omega**2)
    bodies: list[Words] = [
        {"id": "ground", "type": "static", "shapes": [{"box": [60, 1]}], "position": [0, -0.5]},
        {
            "id": "car",
            "shapes": [{"box": [3, 0.4]}],
            "mass": body,
            "fixed_rotation": True,
            "position": [0, 5 - 0.75 * sag],
        },
    ]
    joints: list[Words] = []
    for name, x in (("left", -1), ("right", 1)):
        bodies.append({"id": name, "shapes": [{"circle": 0.4}], "mass": wheel, "position": [x, 0.4]})
        joints.append({
            "id": f"of-{name}", "type": "wheel", "bodies": ["car", name], "anchor": [x, 0.4], "hertz": hertz,
            "damping_ratio": damping, "rest": -0.75 * sag,
        })  # fmt: skip
    world = sandbox.World(sandbox.Scene(bodies=bodies, joints=joints, settings={"sleeping": False}))
    found = np.array(heights(world, "car", 1)) - (5 - sag)
    times = np.arange(1, len(found) + 1) / 60
    natural = omega * math.sqrt(2.0 * together / body)
    ratio = damping * natural / omega
    turn = natural * math.sqrt(1.0 - ratio**2)
    swing = np.cos(turn * times) + ratio / math.sqrt(1.0 - ratio**2) * np.sin(turn * times)
    wanted = 0.25 * sag * np.exp(-ratio * natural * times) * swing
    for first in range(0, 600, 150):
        part = slice(first, first + 150)
        assert np.ptp(found[part]) == pytest.approx(np.ptp(wanted[part]), rel=0.03, abs=2e-3 * sag)
