"""What rolls and rocks on a contact that wanders keeps its amplitude: nothing drives it, and nothing slows it."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from sandbox import Scene
from sandbox.engine.world import World
from sandbox.scene.flat import FlatSettings
from tests.flat import AWAKE, body, box, circle, ground, world


def tilts(w: World, name: str, seconds: int, rate: int) -> list[float]:
    """The largest tilt (degrees) of a body in each of five parts of so many seconds."""
    seen = []
    for _ in range(seconds * rate):
        w.step()
        seen.append(abs(math.degrees(w.body(name).angle)))
    part = len(seen) // 5
    return [max(seen[k : k + part]) for k in range(0, 5 * part, part)]


def roly_poly(degrees: float, rate: int, **surface: float) -> World:
    """A disc with most of its mass below its middle, tilted."""
    light = circle(0.5, friction=2.0, density=1.0, **surface)
    heavy = circle(0.15, (0.0, -0.3), friction=2.0, density=20.0)
    doll = body("doll", light, heavy, position=(0.0, 0.5), angle=math.radians(degrees))
    return world(ground(friction=2.0), doll, settings=_at(rate))


def plank_on_drum(degrees: float, rate: int, plank_first: bool = False, restitution: float = 0.0) -> World:
    """A plank that has rolled so far on a drum that it is tilted by as much."""
    angle = math.radians(degrees)
    n, t = (-math.sin(angle), math.cos(angle)), (math.cos(angle), math.sin(angle))
    place = (1.1 * n[0] + angle * t[0], 1.1 * n[1] + angle * t[1])
    drum = body("drum", circle(1.0, friction=2.0), type="static")
    plank = body("plank", box(2.0, 0.2, friction=2.0, restitution=restitution), position=place, angle=angle)
    return world(*((plank, drum) if plank_first else (drum, plank)), settings=_at(rate))


def _at(rate: int) -> FlatSettings:
    return replace(AWAKE, step_rate=rate)


@pytest.mark.parametrize("rate", [60, 240])
@pytest.mark.parametrize("degrees", [5.0, 30.0])
def test_a_roly_poly_rocks_on(degrees, rate):
    """With the contacts of the beginning of each step a tilt of 5 degrees is 12 after 20 s, of 30 it is 62."""
    parts = tilts(roly_poly(degrees, rate), "doll", 20, rate)
    assert parts[0] == pytest.approx(degrees, rel=2e-3)
    assert 0.95 * degrees < parts[-1] < degrees


def test_a_roly_poly_that_may_bounce_rocks_on():
    """The rows of its contacts follow as well, not only the lanes of the solver."""
    assert tilts(roly_poly(5.0, 60, restitution=0.5), "doll", 20, 60)[-1] == pytest.approx(5.0, rel=0.05)


@pytest.mark.parametrize(("degrees", "rate", "kept"), [(5.0, 60, 0.95), (5.0, 240, 0.99), (15.0, 60, 0.8)])
def test_a_plank_rocks_on_a_drum(degrees, rate, kept):
    """With the contacts of the beginning it tilts to 13 degrees in 10 s (Box2D to 10), and slides off later."""
    parts = tilts(plank_on_drum(degrees, rate), "plank", 20, rate)
    assert kept * degrees < parts[-1] < degrees


def test_a_plank_rocks_whichever_body_is_first():
    parts = [tilts(plank_on_drum(5.0, 60, plank_first=first), "plank", 20, 60) for first in (False, True)]
    assert parts[1] == pytest.approx(parts[0], rel=1e-3)


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_contacts_are_told_of_as_they_were_found(restitution):
    """When the step began, not in the middle of it: with the normal of the plank's face there."""
    w = plank_on_drum(15.0, 60, restitution=restitution)
    w.step(30)
    for _ in range(30):
        before = w.body("plank").angle
        w.step()
        contact = w.state.contacts[0]
        assert contact.axis_owner == 1
        assert (contact.normal_x, contact.normal_y) == pytest.approx((-math.sin(before), math.cos(before)), abs=1e-9)
    assert abs(w.body("plank").angular_velocity) > 0.05


def test_a_roly_poly_rocks_on_a_board_that_slides():
    """Both bodies move; the board weighs little more than the doll."""
    light, heavy = circle(0.5, friction=2.0, density=1.0), circle(0.15, (0.0, -0.3), friction=2.0, density=20.0)
    doll = body("doll", light, heavy, position=(0.0, 0.7), angle=math.radians(10.0))
    board = body("board", box(6.0, 0.2, friction=2.0, density=3.0), position=(0.0, 0.1))
    parts = tilts(world(ground(friction=0.0), board, doll), "doll", 20, 60)
    assert parts[-1] == pytest.approx(parts[0], rel=0.1)


def test_a_plank_rocks_on_a_drum_with_weights_welded_to_it():
    """Joints are measured from the middle of the step as well; it was tilted by 16 degrees after 20 s, from 6."""
    drum = {"id": "drum", "type": "static", "position": [0, -1], "shapes": [{"circle": 1.0, "friction": 2.0}]}
    plank = {"id": "plank", "position": [0, 0.1], "shapes": [{"box": [2.0, 0.2], "friction": 2.0}]}
    weights = [
        {"id": f"weight{x}", "position": [x, 0.1], "shapes": [{"box": [0.2, 0.2], "friction": 2.0}]}
        for x in (-1.1, 1.1)
    ]
    welds = [
        {"id": f"weld{x}", "type": "weld", "bodies": ["plank", f"weight{x}"], "anchor": [0.909 * x, 0.1]}
        for x in (-1.1, 1.1)
    ]
    for each in (plank, *weights):
        x = each["position"][0]
        each |= {"angular_velocity": 25.0, "velocity": [0.0, math.radians(25.0) * x]}
    w = World(Scene(bodies=[drum, plank, *weights], joints=welds, settings={"sleeping": False}))
    parts = tilts(w, "plank", 20, 60)
    assert 0.7 * parts[0] < parts[-1] < 1.01 * parts[0]


@pytest.mark.parametrize("links", [100, 400, 800])
@pytest.mark.parametrize("friction", [0.0, 100.0])
def test_a_disc_in_a_bowl_of_links_gains_nothing(links, friction):
    """It passes several links in a step, and each turns it: 0.449 m once were 0.49 to 0.52 after 20 s."""
    at = [(5.0 * math.sin(t), -5.0 * math.cos(t)) for t in (-1.2 + 2.4 * k / links for k in range(links + 1))]
    place = (4.5 * math.sin(0.1), -4.5 * math.cos(0.1))
    bowl = {"id": "bowl", "type": "static", "shapes": [{"chain": at, "friction": friction}]}
    disc = {"id": "disc", "position": place, "shapes": [{"circle": 0.5, "friction": friction}]}
    w = World(Scene(bodies=[bowl, disc], settings={"sleeping": False}))
    seen = []
    for _ in range(20 * 60):
        w.step()
        seen.append(abs(w.body("disc").position[0]))
    assert max(seen[-300:]) < 1.025 * 0.4492
    assert max(seen[-300:]) > 0.8 * 0.4492
