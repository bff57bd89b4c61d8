"""What slides or rolls over parts of one body that abut, and over lines that go on from each other, does not catch."""

from __future__ import annotations

import math
from typing import Any

import pytest

import sandbox
from sandbox import Spawn

SLEDS = {
    "box": ({"box": [0.6, 0.4]}, 0.2),
    "disc": ({"circle": 0.3}, 0.3),
    "rounded": ({"box": [0.6, 0.4], "radius": 0.1}, 0.2),
}
G = 9.81


def sled(name: str, x: float, speed: float, tilt: float = 0.0) -> dict[str, Any]:
    """A frictionless body on y = 0 at x, all turned by `tilt` degrees."""
    shape, height = SLEDS[name]
    c, s = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
    return {
        "id": "sled",
        "shapes": [shape | {"friction": 0}],
        "position": [c * x - s * height, s * x + c * height],
        "angle": tilt,
        "velocity": [c * speed, s * speed],
    }


def boxes(count: int, width: float, height: float = 0.2) -> list[dict[str, Any]]:
    """A deck with its top at y = 0, its middle at x = 0."""
    return [
        {"box": [width, height], "at": [(k - 0.5 * count + 0.5) * width, -0.5 * height], "friction": 0}
        for k in range(count)
    ]


def after(*bodies: dict[str, Any], steps: int = 120, **fields: Any) -> sandbox.World:
    world = sandbox.World(sandbox.Scene(bodies=list(bodies), settings={"sleeping": False}, **fields))
    world.step(steps)
    return world


@pytest.mark.parametrize("name", SLEDS)
@pytest.mark.parametrize(("kind", "speed"), [("static", 0.0), ("kinematic", 0.0), ("kinematic", 3.0)])
def test_a_deck_of_boxes_holds_as_one(name: str, kind: str, speed: float) -> None:
    for width in (0.25, 1.0):
        deck = {"id": "deck", "type": kind, "shapes": boxes(100, width), "velocity": [speed, 0]}
        world = after(deck, sled(name, 0.3, 5.0 + speed))
        assert world.body("sled").velocity[0] - speed == pytest.approx(5.0, abs=1e-4)


@pytest.mark.parametrize("name", SLEDS)
def test_a_deck_that_lies_aslant_and_comes_later(name: str) -> None:
    """Gravity is turned as well: nothing but the angle of the body differs."""
    for tilt in (30.0, -120.0):
        c, s = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
        scene = sandbox.Scene(gravity=[G * s, -G * c], settings={"sleeping": False})
        world = sandbox.World(scene)
        world.apply(
            Spawn(
                [
                    {"id": "deck", "type": "kinematic", "angle": tilt, "shapes": boxes(60, 0.5)},
                    sled(name, 0.1, 5.0, tilt),
                ]
            )
        )
        world.step(120)
        x, y = world.body("sled").velocity
        assert c * x + s * y == pytest.approx(5.0, abs=1e-4)


@pytest.mark.parametrize("name", SLEDS)
def test_a_loose_wagon(name: str) -> None:
    ice = {"id": "ice", "type": "static", "shapes": [{"box": [400, 1], "friction": 0}], "position": [0, -0.7]}
    wagon = {"id": "wagon", "mass": 1000, "shapes": boxes(20, 1.0)}
    world = after(ice, wagon, sled(name, -9.0, 4.0), steps=240)
    assert world.body("sled").velocity[0] == pytest.approx(4.0, abs=1e-4)


def test_a_step_in_a_deck_is_one() -> None:
    shapes = boxes(20, 1.0)
    shapes[14]["at"][1] += 0.1
    world = after({"id": "deck", "type": "kinematic", "shapes": shapes}, sled("box", 0.3, 5.0))
    assert world.body("sled").velocity[0] < 1.0
    assert world.body("sled").position[0] < 4.0


LEFT, RIGHT = [[-20, 0], [0, 0]], [[0, 0], [20, 0]]
FLOORS: dict[str, list[dict[str, Any]]] = {
    "lines": [{"segment": LEFT}, {"segment": RIGHT}],
    "lines that begin there": [{"segment": LEFT[::-1]}, {"segment": RIGHT}],
    "round lines": [
        {"segment": LEFT, "radius": 0.1, "at": [0, -0.1]},
        {"segment": RIGHT, "radius": 0.1, "at": [0, -0.1]},
    ],
    "box and line": [{"box": [20, 1], "at": [-10, -0.5]}, {"segment": RIGHT}],
    "box and capsule": [{"box": [20, 1], "at": [-10, -0.5]}, {"capsule": RIGHT, "radius": 0.2, "at": [0, -0.2]}],
    "box and chain": [{"box": [20, 1], "at": [-10, -0.5]}, {"chain": RIGHT[::-1]}],
    "wedge and line": [{"polygon": [[-20, 0], [-20, -3], [0, 0]]}, {"segment": RIGHT}],
    "round line on a box": [{"capsule": [[-20, -0.1], [0, -0.1]], "radius": 0.1}, {"box": [20, 1], "at": [10, -0.5]}],
}


@pytest.mark.parametrize("floor", FLOORS)
@pytest.mark.parametrize("name", SLEDS)
@pytest.mark.parametrize("kind", ["static", "kinematic"])
def test_what_goes_on_from_the_end_of_a_line(floor: str, name: str, kind: str) -> None:
    shapes = [shape | {"friction": 0} for shape in FLOORS[floor]]
    for way in (1.0, -1.0):
        world = after({"id": "floor", "type": kind, "shapes": shapes}, sled(name, -3.0 * way, 4.0 * way))
        assert world.body("sled").velocity[0] == pytest.approx(4.0 * way, abs=1e-4)


def test_bodies_that_are_static_are_one_floor() -> None:
    bodies = [
        {"id": f"{k}", "type": "static", "shapes": [shape | {"friction": 0}]}
        for k, shape in enumerate(FLOORS["box and line"])
    ]
    for way in (1.0, -1.0):
        world = after(*bodies, sled("box", -3.0 * way, 4.0 * way))
        assert world.body("sled").velocity[0] == pytest.approx(4.0 * way, abs=1e-4)


def drum(shapes: list[dict[str, Any]], steps: int = 900) -> float:
    """How far up (degrees, on average over 5 s) a drum that turns at 3 rad/s carries a disc that rolls in it."""
    turning = {"id": "drum", "type": "kinematic", "angular_velocity": math.degrees(3.0), "shapes": shapes}
    wheel = [{"circle": 0.3, "friction": 0.9}]
    disc = {"id": "disc", "position": [0, -1.7], "angular_velocity": math.degrees(20.0), "shapes": wheel}
    world = after(turning, disc, steps=600)
    angles = []
    for _ in range(steps - 600):
        world.step()
        x, y = world.body("disc").position
        angles.append(math.degrees(math.atan2(x, -y)))
    return sum(angles) / len(angles)


@pytest.mark.parametrize("kind", ["box", "segment"])
def test_a_drum_of_parts_carries_what_rolls_as_a_chain_does(kind: str) -> None:
    """A chain of so many links carries it by a degree, ruts of parts by twenty."""
    count, radius = 144, 2.0
    turn = 2 * math.pi / count
    corners = [
        [
            radius / math.cos(turn / 2) * math.cos(turn * (k + 0.5)),
            radius / math.cos(turn / 2) * math.sin(turn * (k + 0.5)),
        ]
        for k in range(count)
    ]
    shapes: dict[str, list[dict[str, Any]]] = {
        "segment": [{"segment": [corners[k - 1], corners[k]], "friction": 0.9} for k in range(count)],
        "box": [
            {
                "box": [0.2, 2 * (radius + 0.1) * math.tan(turn / 2)],
                "at": [(radius + 0.1) * math.cos(turn * k), (radius + 0.1) * math.sin(turn * k)],
                "angle": 360 * k / count,
                "friction": 0.9,
            }
            for k in range(count)
        ],
    }
    assert abs(drum(shapes[kind])) < 1.5


def test_sensors_cover_nothing() -> None:
    floor = {"id": "floor", "type": "static", "position": [0, -0.5], "shapes": [{"box": [20, 1]}]}
    zone = {"id": "zone", "type": "static", "shapes": [{"box": [30, 4], "sensor": True}]}
    crate = {"id": "crate", "position": [0, 0.5], "shapes": [{"box": [1, 1]}]}
    world = after(floor, zone, crate)
    assert world.body("crate").position[1] == pytest.approx(0.5, abs=1e-3)


PIECES = {
    "one": [{"box": [2, 1]}],
    "two": [{"box": [1, 1], "at": [-0.5, 0]}, {"box": [1, 1], "at": [0.5, 0]}],
    "four": [{"box": [1, 0.5], "at": [x, y]} for x in (-0.5, 0.5) for y in (-0.25, 0.25)],
    "across": [{"box": [1.2, 1], "at": [-0.4, 0]}, {"box": [1.2, 1], "at": [0.4, 0]}],
}


@pytest.mark.parametrize("tilt", [0.0, 1.0, 20.0, 45.0])
def test_a_box_of_parts_falls_as_a_box(tilt: float) -> None:
    """The corner that lands first turns it, and the far corner, which is another part's, lands in the same step."""
    found = {}
    for name, pieces in PIECES.items():
        ground = {"id": "ground", "type": "static", "position": [0, -0.5], "shapes": [{"box": [400, 1]}]}
        fallen = {"id": "box", "position": [0, 3], "angle": tilt, "velocity": [2, 0], "shapes": pieces, "mass": 2}
        fallen["inertia"] = 1
        box = after(ground, fallen, steps=60).body("box")
        found[name] = (*box.position, box.angle)
    for name in PIECES:
        assert found[name] == pytest.approx(found["one"], abs=5e-3)
