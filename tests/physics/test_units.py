"""Scenes in other units than metres: what is as many times as large, and says so, moves as it does in metres. So
does what is as many times as heavy.

By a power of two every number is as many times as large to the last bit, so that nothing may differ at all.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise, product
from typing import Any

import numpy as np
import pytest

import sandbox
from sandbox import MoveDrag, StartDrag
from tests.benchmarks import other_scenes as others

Words = dict[str, Any]

LENGTHS = {
    "position", "velocity", "gravity", "box", "circle", "capsule", "polygon", "segment", "chain", "radius", "at",
    "anchor", "anchors", "length", "rest", "surface_speed", "ratio",
}  # fmt: skip
"""What a length is in, once: places, speeds, accelerations; the ratio of a gear, where it is a slide to an angle."""


def in_units(words: Any, size: float, mass: float, name: str = "") -> Any:
    """A scene in units of which a metre has so many, and everything so many times as heavy: times are the same."""
    if isinstance(words, dict):
        many = {key: in_units(value, size, mass, key) for key, value in words.items()}
        is_shape = not {"box", "circle", "capsule", "polygon", "segment", "chain"}.isdisjoint(words)
        return many | ({"density": words.get("density", 1.0) * mass / size**2} if is_shape else {})
    if isinstance(words, list | tuple):
        return [in_units(each, size, mass, name) for each in words]
    if isinstance(words, float | int) and not isinstance(words, bool):
        return words * (size if name in LENGTHS else mass * size**2 if name == "max_torque" else 1)
    return words


def world(parts: others.Parts, size: float = 1.0, mass: float = 1.0) -> sandbox.World:
    bodies, joints = in_units(list(parts), size, mass)
    scene = {"bodies": bodies, "joints": joints, "gravity": [0.0, -10.0 * size]}
    return sandbox.World(sandbox.Scene(**scene, settings={"units_per_meter": size}))


def poses(w: sandbox.World, size: float) -> list[Any]:
    """Lengths in metres, angles, and who is awake. What has faded away has fewer digits the smaller it is: 0."""
    b = w.state.bodies
    lengths = [b.position_x, b.position_y, b.velocity_x, b.velocity_y]
    numbers = [*(each / size for each in lengths), b.angle, b.angular_velocity]
    return [*(np.where(np.abs(each) < 1e-290, 0.0, each) for each in numbers), b.awake]


def some(parts: others.Parts, most: int = 250) -> others.Parts:
    """The first bodies and what joins these."""
    bodies = parts[0][:most]
    there = {body["id"] for body in bodies}
    return bodies, [joint for joint in parts[1] if there.issuperset(joint.get("bodies", []))]


def pinned(parts: others.Parts) -> others.Parts:
    """With a weight on it that nothing can bear at the usual substeps."""
    bodies, joints = parts
    return [{"id": "weight", "position": [0.0, 40.0], "shapes": [{"box": [4, 1], "density": 60}]}, *bodies], joints


def shots(_: int) -> others.Parts:
    """Fast discs and boxes in a ring of thin segments, a gate that lets through one way, and a belt."""
    corners = [[10.0 * math.cos(0.4 * k), 10.0 * math.sin(0.4 * k)] for k in range(16)]
    belt = {"box": [6, 0.5], "at": [0, -5], "surface_speed": 2.0}
    gate = {"segment": [[-4, 2], [4, 2]], "one_way": [0, 1]}
    ring = [{"id": "ring", "type": "static", "shapes": [{"segment": list(pair)} for pair in pairwise(corners)]}]
    bodies = [*ring, {"id": "level", "type": "static", "shapes": [belt, gate]}]
    for k in range(24):
        shape = {"circle": 0.3} if k % 3 else {"box": [0.5, 0.4]}
        speed = [20.0 * (k + 1) * math.cos(k), 15.0 * (k + 1) * math.sin(k)]
        place = [3.0 * math.cos(0.3 * k), 3.0 * math.sin(0.3 * k) + 1.0]
        shape["restitution"] = 0.5 * (k % 2)
        bodies.append({"id": f"b{k}", "position": place, "velocity": speed, "bullet": k % 4 == 0, "shapes": [shape]})
    return bodies, []


def bouncing_pairs() -> others.Parts:
    """Hinged and welded pairs that bounce on a floor, with friction."""
    bodies: list[Words] = [{"id": "floor", "type": "static", "shapes": [{"box": [90, 1], "restitution": 0.8}]}]
    joints = []
    for k in range(6):
        pair, x = [f"a{k}", f"b{k}"], 4.0 * k
        bodies.append({"id": pair[0], "position": [x, 2], "angle": 17.0 * k, "shapes": [{"box": [0.8, 0.5]}]})
        bodies.append({"id": pair[1], "position": [x + 1.3, 2.2], "shapes": [{"circle": 0.4}]})
        kind = "weld" if k % 2 else "revolute"
        joints.append({"id": f"j{k}", "type": kind, "bodies": pair, "anchor": [x + 0.7, 2.1]})
    return bodies, joints


def racks() -> others.Parts:
    """Racks that turn wheels, and are struck by what falls on them."""
    bodies: list[Words] = []
    joints: list[Words] = []
    for k in range(6):
        x = 4.0 * k
        wheel, rack, weight = f"wheel{k}", f"rack{k}", f"weight{k}"
        bodies.append({"id": wheel, "position": [x, 4], "shapes": [{"circle": 1, "density": 2.0 + k}]})
        bodies.append({"id": rack, "position": [x + 1.2, 3], "shapes": [{"box": [0.3, 4]}]})
        bodies.append({"id": weight, "position": [x + 1.3, 6 + k], "shapes": [{"circle": 0.4, "density": 9.0}]})
        joints.append({"id": f"pin{k}", "type": "revolute", "bodies": [wheel], "anchor": [x, 4]})
        joints.append(
            {"id": f"slide{k}", "type": "prismatic", "bodies": [rack], "anchor": [x + 1.2, 3], "axis": [0, 1]}
        )
        joints.append({"id": f"gear{k}", "type": "gear", "joints": [f"slide{k}", f"pin{k}"], "ratio": 0.5 + 0.1 * k})
    return bodies, joints


def drawers() -> others.Parts:
    """A grid of hinges and slides too dense to be factorised, in which slides of a row are geared to each other."""
    bodies: list[Words] = []
    joints: list[Words] = []
    for i, j in product(range(9), range(9)):
        x, y = 1.1 * i, 5 + 1.1 * j
        bodies.append({"id": f"b{i}-{j}", "position": [x, y], "shapes": [{"box": [0.8, 0.6]}]})
        if i > 0:
            pair = {"bodies": [f"b{i - 1}-{j}", f"b{i}-{j}"], "anchor": [x - 0.55, y]}
            joints.append({"id": f"hinge{i}-{j}", "type": "revolute", **pair})
        if j > 0:
            pair = {"bodies": [f"b{i}-{j - 1}", f"b{i}-{j}"], "anchor": [x, y - 0.55]}
            joints.append({"id": f"slide{i}-{j}", "type": "prismatic", "axis": [0, 1], **pair})
        if i > 0 and j > 0:
            slides = [f"slide{i - 1}-{j}", f"slide{i}-{j}"]
            joints.append({"id": f"gear{i}-{j}", "type": "gear", "joints": slides})
    bodies[0]["type"] = "static"
    return bodies, joints


BUILDS: dict[str, Callable[[], others.Parts]] = {
    "boxes": lambda: others.heap_of_boxes(1),
    "capsules under a weight": lambda: pinned(others.heap_of_capsules(1)),
    "rounded polygons": lambda: others.heap_of_rounded_polygons(1),
    "balls that bounce": lambda: others.bouncing_pit(1),
    "sizes mixed": lambda: others.sizes_mixed(1),
    "stars": lambda: others.stars(1),
    "tiles": lambda: others.tiles(1),
    "ropes": lambda: others.ropes(1),
    "cloth": lambda: others.cloth(1),
    "net of welds": lambda: others.weld_net(1),
    "loops": lambda: others.loops(1),
    "rag dolls": lambda: others.ragdolls(1),
    "cars": lambda: others.cars(1),
    "needles": lambda: others.needles(1),
    "shots": lambda: shots(1),
    "pairs that bounce": bouncing_pairs,
    "racks": racks,
    "drawers": drawers,
}


@pytest.mark.parametrize(
    ("size", "mass"),
    [(64.0, 1.0), *(pytest.param(*both, marks=pytest.mark.slow) for both in [(2.0**-10, 1.0), (0.25, 2.0**12)])],
)
@pytest.mark.parametrize("name", BUILDS)
def test_what_is_as_many_times_as_large_moves_the_same_to_the_bit(name: str, size: float, mass: float) -> None:
    parts = some(BUILDS[name]())
    one, many = world(parts), world(parts, size, mass)
    for step in range(64):
        one.step()
        many.step()
        for here, there in zip(poses(one, 1.0), poses(many, size), strict=True):
            assert np.array_equal(here, there), step


def test_a_hand_pulls_as_hard() -> None:
    parts = some(BUILDS["boxes"](), 40)
    one, many = world(parts), world(parts, 64.0)
    for w, size in ((one, 1.0), (many, 64.0)):
        b = w.body("b20")
        w.apply(StartDrag("b20", (b.position[0], b.position[1])))
        w.apply(MoveDrag("b20", (50.0 * size, 80.0 * size)))
        w.step(30)
    assert all(np.array_equal(*two) for two in zip(poses(one, 1.0), poses(many, 64.0), strict=True))
    assert one.body("b20").position[1] > 10.0


@pytest.mark.parametrize(
    ("gravity", "units"), [((0.0, 0.0), 1.0), ((0.0, -9.81), 1.0), ((24.8, 0.0), 1.0), ((0.0, 981.0), 100.0)]
)
def test_gravity_beyond_any_planets_tells_how_long_a_metre_is(gravity: tuple[float, float], units: float) -> None:
    w = sandbox.World(sandbox.Scene(gravity=gravity))
    assert w.state.settings[0].units_per_meter == pytest.approx(units, rel=1e-12)


def test_what_a_scene_says_holds() -> None:
    w = sandbox.World(sandbox.Scene(gravity=(0, -900), settings={"units_per_meter": 30}))
    assert w.state.settings[0].units_per_meter == 30.0


def test_a_scene_of_a_world_whose_gravity_changed_keeps_its_units() -> None:
    w = sandbox.World(sandbox.Scene(gravity=(0, -981)))
    w.gravity = (0.0, 0.0)
    again = sandbox.World(sandbox.scene_of(w).scene)
    assert again.state.settings[0].units_per_meter == w.state.settings[0].units_per_meter == pytest.approx(100.0)


def test_boxes_of_sixty_pixels_settle_and_fall_asleep() -> None:
    """Without units they would sink into each other by a third of their size, and never rest."""
    bodies: list[Words] = [{"id": "floor", "type": "static", "position": [0, -50], "shapes": [{"box": [2000, 100]}]}]
    bodies += [
        {"id": f"b{k}", "position": [60 * (k % 8) + 3 * (k % 5), 40 + 70 * (k // 8)], "shapes": [{"box": [60, 60]}]}
        for k in range(40)
    ]
    w = sandbox.World(sandbox.Scene(bodies=bodies, gravity=(0, -900)))
    w.step(480)
    assert w.awake_count == 0
    assert w.contacts.separation1.min() > -1.5
