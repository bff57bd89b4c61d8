"""Restitution above 1: only where `bumper` says so, and then what strikes comes back as much faster as it says."""

from __future__ import annotations

import json
from itertools import pairwise
from typing import Any

import pytest

from sandbox import Material, Scene, SceneError, SetSurface, World, loads_scene
from sandbox.errors import CommandError

FALL = 2.0
G = 9.81


def data(shape: dict[str, Any], falling: dict[str, Any], **material: Any) -> dict[str, Any]:
    """Something 1 m high falls by 2 m to a floor; surfaces of both shapes, and the floor's material, are given."""
    return {
        "format": 1,
        "materials": {"floor": material},
        "bodies": [
            {"id": "floor", "type": "static", "material": "floor", "shapes": [{"box": [9, 1], **shape}]},
            {"id": "ball", "position": [0, 1 + FALL], "shapes": [falling]},
        ],
    }


def scene(shape: dict[str, Any], falling: dict[str, Any], **material: Any) -> Scene:
    return loads_scene(json.dumps(data(shape, falling, **material)))


def energies(w: World, steps: int) -> list[tuple[float, bool]]:
    """Energy by mass (J/kg) after each step, and whether it touches the floor in that."""
    found = []
    for _ in range(steps):
        w.step()
        ball = w.body("ball")
        speed = ball.velocity
        energy = 0.5 * (speed[0] ** 2 + speed[1] ** 2) + G * (ball.position[1] - 1.0)
        found.append((energy, bool(w.contacts.touching.any())))
    return found


@pytest.mark.parametrize("restitution", [1.0, 1.2, 1.5, 5.0])
@pytest.mark.parametrize("falling", [{"circle": 0.5}, {"box": [1, 1]}, {"circle": 0.5, "restitution": 0.9}])
def test_it_comes_back_by_the_square_of_the_restitution(restitution, falling):
    w = World(scene({}, falling, bumper=True, restitution=restitution))
    found = [energy for energy, _ in energies(w, 60)]
    assert found[0] == pytest.approx(G * FALL, rel=1e-3)
    assert found[-1] == pytest.approx(restitution**2 * G * FALL, rel=2e-3)


def test_energy_rises_at_bumpers_alone():
    w = World(scene({}, {"circle": 0.5}, bumper=True, restitution=1.1))
    found = energies(w, 600)
    rises = [touches for (before, _), (after, touches) in pairwise(found) if after > before + 1e-6]
    assert rises
    assert all(rises)


@pytest.mark.parametrize(("shape", "material"), [({"restitution": 1.5}, {}), ({}, {"restitution": 1.5})])
def test_alone_it_is_a_mistake_that_names_the_mend(shape, material):
    with pytest.raises(SceneError) as caught:
        scene(shape, {"circle": 0.5}, **material)
    assert 'restitution must not be above 1, or 5 beside "bumper": true' in str(caught.value)
    for each in (shape, material):
        each.update({"bumper": True} if each else {})
    assert scene(shape, {"circle": 0.5}, **material).flatten().bodies[0].shapes[0].restitution == 1.5


@pytest.mark.parametrize("wrong", [{"bumper": True, "restitution": 5.1}, {"bumper": False, "restitution": 1.1}])
def test_bumpers_have_bounds_too(wrong):
    with pytest.raises(SceneError, match="restitution"):
        Material(**wrong)


def test_a_saved_scene_keeps_it(tmp_path):
    made = scene({}, {"circle": 0.5}, bumper=True, restitution=1.5)
    made.save(tmp_path / "kept.scene.json")
    kept = loads_scene((tmp_path / "kept.scene.json").read_text(encoding="utf-8"))
    assert kept.materials["floor"] == Material(bumper=True, restitution=1.5)
    assert World(kept).digest() == World(made).digest()


def test_a_running_scene_gets_bumpers():
    w = World(scene({}, {"circle": 0.5}))
    with pytest.raises(CommandError, match="SetSurface of 'floor': restitution must not be above 1"):
        w.apply(SetSurface("floor", restitution=1.5))
    w.body("floor").set_surface(restitution=1.5, bumper=True)
    assert energies(w, 60)[-1][0] == pytest.approx(2.25 * G * FALL, rel=2e-3)
