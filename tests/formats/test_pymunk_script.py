"""The exported program runs by itself, and its bodies stay near ours."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from sandbox.engine.world import World
from sandbox.formats import export_scene
from sandbox.scene import Scene

SCENE = Scene(
    title='Quotes " and \\ \n bars',
    bodies=[
        {"id": "floor", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "position": [0, 3], "angle": 10, "shapes": [{"box": [1, 1]}], "linear_damping": 0.5},
        {"id": "ball", "position": [3, 2], "velocity": [1, 2], "shapes": [{"circle": 0.5, "at": [0.1, 0]}]},
        {"id": "bob", "position": [-5, 6], "shapes": [{"capsule": [[-0.5, 0], [0.5, 0]], "radius": 0.2}]},
        {"id": "arm", "position": [-9, 6], "shapes": [{"polygon": [[-1, 0], [1, -0.2], [1, 0.2]]}],
         "gravity_scale": 0.5},
    ],
    joints=[
        {"id": "rod", "type": "distance", "bodies": [None, "bob"], "anchors": [[-5, 9], [-5, 6]]},
        {"id": "pin", "type": "revolute", "bodies": ["arm"], "anchor": [-10, 6], "lower": -40, "upper": 40},
        {"id": "rail", "type": "prismatic", "bodies": ["ball"], "anchor": [3, 2], "axis": [1, 0], "enabled": False},
    ],
)  # fmt: skip


def test_its_bodies_stay_near_ours() -> None:
    exported = export_scene(SCENE, "pymunk")
    made: dict[str, Any] = {"__name__": "exported"}
    exec(compile(exported.text, "exported.py", "exec"), made)
    world = World(SCENE)
    for name, body in made["bodies"].items():
        if body.body_type == 0:
            assert body.mass == pytest.approx(world.body(name).mass)
            assert body.moment == pytest.approx(world.body(name).inertia)
    for _ in range(20):
        made["space"].step(1 / 60)
    world.step(20)
    for name, body in made["bodies"].items():
        assert math.dist(body.position, world.body(name).position) < 0.05, name
        assert abs(body.angle - world.body(name).angle) < 0.05, name
    assert exported.remarks == (("rail", "a joint that is switched off is left out"),)


@pytest.mark.slow
def test_it_runs_under_python(tmp_path: Path) -> None:
    program = tmp_path / "fall.py"
    program.write_text(export_scene(SCENE, "pymunk").text, encoding="utf-8")
    done = subprocess.run([sys.executable, program], capture_output=True, text=True, check=True)
    assert [line.split()[0] for line in done.stdout.splitlines()] == ["floor", "crate", "ball", "bob", "arm"]
