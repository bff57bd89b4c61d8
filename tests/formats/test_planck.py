"""Worlds of planck.js: what is exported is imported as the same bodies, shapes and joints."""

from __future__ import annotations

import json
import math
import tempfile
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.errors import ArgumentError, SceneError
from sandbox.formats import Imported, export_scene, import_scene
from sandbox.scene import Scene, load_scene
from sandbox.scene.flat import FlatShape
from tests.formats.conftest import Read, texts


def there_and_back(scene: Scene) -> Imported:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "world.json")
        path.write_text(export_scene(scene, "planck").text, encoding="utf-8")
        return import_scene(path)


def number(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_nan=False, width=32)


PLACES = st.tuples(number(-50, 50), number(-50, 50))
SURFACES = st.fixed_dictionaries(
    {}, optional={"friction": number(0, 2), "restitution": number(0, 1), "density": number(0.125, 8),
                  "group": st.integers(-5, 5), "category": st.integers(1, 0xFFFF), "mask": st.integers(0, 0xFFFE),
                  "sensor": st.booleans()}
)  # fmt: skip
GEOMETRIES = st.one_of(
    st.builds(lambda r, at: {"circle": r, "at": at}, number(0.125, 3), PLACES),
    st.builds(lambda w, h, angle: {"box": (w, h), "angle": angle}, number(0.125, 5), number(0.125, 5), number(-90, 90)),
    st.builds(lambda w, h: {"polygon": [(0, 0), (w, 0), (w / 2, h)]}, number(0.25, 5), number(0.25, 5)),
)
SHAPES = st.builds(lambda geometry, surface: {**geometry, **surface}, GEOMETRIES, SURFACES)
MOTIONS = st.fixed_dictionaries(
    {}, optional={"velocity": PLACES, "angular_velocity": number(-300, 300), "linear_damping": number(0, 5),
                  "gravity_scale": number(-2, 2), "bullet": st.booleans(), "fixed_rotation": st.booleans()}
)  # fmt: skip


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    bodies: list[dict[str, Any]] = []
    for k in range(draw(st.integers(1, 4))):
        solid = {**draw(GEOMETRIES), "density": 1.0}
        shapes = [solid, *draw(st.lists(SHAPES, max_size=2))]
        body = {"id": f"body-{k}", "position": draw(PLACES), "angle": draw(number(-180, 180)), "shapes": shapes}
        bodies.append(body | (draw(MOTIONS) if draw(st.booleans()) else {"type": "static"}))
    return Scene(bodies=bodies, gravity=draw(PLACES))


def close(one: Any, two: Any) -> bool:
    if isinstance(one, tuple):
        return len(one) == len(two) and all(close(a, b) for a, b in zip(one, two, strict=True))
    if isinstance(one, float):
        return isinstance(two, float) and math.isclose(one, two, rel_tol=1e-6, abs_tol=1e-6)
    return bool(one == two)


def ring(shape: FlatShape) -> tuple[Any, ...]:
    """The corners from the lowest one on: an outline begins where its author likes."""
    corners = [(round(x, 6) + 0.0, round(y, 6) + 0.0) for x, y in shape.vertices]
    start = corners.index(min(corners))
    return tuple(corners[start:] + corners[:start])


@given(scenes())
def test_a_world_comes_back_as_it_was(scene: Scene) -> None:
    back = there_and_back(scene).scene.flatten()
    flat = scene.flatten()
    assert close(back.gravity, flat.gravity)
    for was, now in zip(flat.bodies, back.bodies, strict=True):
        names = ("id", "type", "position", "angle", "velocity", "angular_velocity", "linear_damping", "gravity_scale",
                 "fixed_rotation", "bullet", "mass", "center")  # fmt: skip
        assert [name for name in names if not close(getattr(was, name), getattr(now, name))] == []
        for one, two in zip(was.shapes, now.shapes, strict=True):
            assert close(ring(one), ring(two)), (one, two)
            assert close(one.radius, two.radius)
            kept = ("friction", "restitution", "category", "mask", "group", "sensor")
            assert [name for name in kept if not close(getattr(one, name), getattr(two, name))] == []
            assert one.sensor or close(one.density, two.density)


JOINTS = [
    {"id": "pin", "type": "revolute", "bodies": ["a", "b"], "anchor": [1, 2], "lower": -30, "upper": 60,
     "motor_speed": 90, "max_torque": 5},
    {"id": "slide", "type": "prismatic", "bodies": [None, "a"], "anchor": [0, 1], "axis": [0.6, 0.8], "lower": -1,
     "upper": 2},
    {"id": "rod", "type": "distance", "bodies": ["a", "b"], "anchors": [[0, 1], [3, 2]], "length": 2},
    {"id": "rope", "type": "distance", "bodies": ["a", "b"], "anchors": [[0, 1], [3, 2]], "max": 4},
    {"id": "spring", "type": "distance", "bodies": ["b"], "anchors": [[9, 9], [3, 2]], "hertz": 3,
     "damping_ratio": 0.25},
    {"id": "glue", "type": "weld", "bodies": ["a", "b"], "anchor": [1, 2], "angular_hertz": 6, "collide": True},
    {"id": "axle", "type": "wheel", "bodies": ["a", "b"], "anchor": [3, 2], "axis": [0, 1], "hertz": 4},
    {"id": "rub", "type": "friction", "bodies": ["a"], "anchor": [0, 1], "max_force": 7, "max_torque": 2},
    {"id": "hoist", "type": "pulley", "bodies": ["a", "b"], "anchors": [[0, 1], [3, 2]], "wheels": [[0, 9], [3, 9]],
     "ratio": 2},
    {"id": "pull", "type": "target", "bodies": ["b"], "anchor": [3, 2], "target": [5, 5], "max_force": 50},
    {"id": "cogs", "type": "gear", "joints": ["pin", "slide"], "ratio": -2},
]  # fmt: skip


def test_joints_come_back_as_they_were() -> None:
    bodies = [{"id": name, "shapes": [{"box": [1, 2]}], "position": place, "angle": angle}
              for name, place, angle in (("a", [0, 1], 30.0), ("b", [3, 2], -70.0))]  # fmt: skip
    scene = Scene(bodies=bodies, joints=JOINTS)
    imported = there_and_back(scene)
    assert imported.remarks == ()
    wanted = {joint.id: joint for joint in scene.flatten().joints}
    names = ["kind", "body_a", "body_b", "lower", "upper", "motor_speed", "hertz", "damping_ratio", "ratio", "collide",
             "angular_hertz", "points", "anchor_b"]  # fmt: skip
    for now in imported.scene.flatten().joints:
        was = wanted.pop(now.id)
        asked = names + ["axis"] * (was.kind in ("prismatic", "wheel"))
        assert [name for name in asked if not close(getattr(was, name), getattr(now, name))] == [], was.id
    assert wanted == {}


class TestShapes:
    def exported(self, *shapes: dict[str, Any]) -> Imported:
        return there_and_back(Scene(bodies=[{"id": "body", "shapes": list(shapes)}]))

    def test_a_capsule_keeps_its_mass(self) -> None:
        scene = Scene(bodies=[{"id": "body", "shapes": [{"capsule": [[-1, 0], [1, 0]], "radius": 0.5}]}])
        parts = there_and_back(scene).scene.flatten().bodies[0].shapes
        areas = [part.density * (2.0 if part.kind == "polygon" else math.pi / 4) for part in parts]
        assert sum(areas) == pytest.approx(2 + math.pi / 4)

    def test_what_has_more_corners_than_box2d_knows_is_cut(self) -> None:
        circle = [(math.cos(math.tau * k / 20), math.sin(math.tau * k / 20)) for k in range(20)]
        parts = self.exported({"polygon": circle}).scene.bodies[0].shapes
        assert [len(part.polygon) for part in parts] == [8, 8, 8]

    def test_chains_stay_chains(self) -> None:
        scene = Scene(bodies=[{"id": "hill", "type": "static", "shapes": [
            {"chain": [[0, 0], [1, 1], [2, 0]]}, {"chain": [[5, 0], [6, 0], [6, 1]], "closed": True},
            {"segment": [[0, 0], [9, 0]]},
        ]}])  # fmt: skip
        imported = there_and_back(scene)
        was, now = (each.flatten().bodies[0].shapes for each in (scene, imported.scene))
        assert [(one.vertices, one.seam) for one in was] == [(one.vertices, one.seam) for one in now]
        assert [hasattr(shape, "chain") for shape in imported.scene.bodies[0].shapes] == [True, True, False]


def test_what_rounds_to_rest_is_at_rest_in_a_scene() -> None:
    """So a world that comes back is the same however often it goes."""
    ball = {"id": "ball", "shapes": [{"circle": 0.5}], "velocity": [1e-12, 0.0], "angular_velocity": 1e-12}
    once = there_and_back(Scene(bodies=[{**ball, "linear_damping": 1e-12}]))
    assert once.scene.bodies[0].model_fields_set.isdisjoint({"velocity", "angular_velocity", "linear_damping"})
    assert there_and_back(once.scene).scene == once.scene


def test_what_a_world_of_planck_cannot_say_is_listed() -> None:
    scene = load_scene(Path(__file__).parents[2] / "scenes/games/breakout.scene.json")
    found = {remark.text for remark in export_scene(scene, "planck").remarks}
    assert "rules, controls and counters are left out" in found


def test_settings_that_a_file_does_not_hold_are_listed() -> None:
    ball = {"id": "ball", "shapes": [{"circle": 1, "restitution": 0.5}]}
    scene = Scene(bodies=[ball], settings={"step_rate": 240, "soft": False, "steps": 9})
    assert [tuple(remark) for remark in export_scene(scene, "planck").remarks] == [
        ("(soft, step_rate)", "settings are left out"), ("", "impacts slower than 1 m/s do not bounce there"),
    ]  # fmt: skip
    assert export_scene(scene, "pymunk").remarks[0] == ("(soft)", "settings are left out")


def test_an_unknown_format_is_told() -> None:
    with pytest.raises(ArgumentError, match="known formats are planck, pymunk"):
        export_scene(Scene(), "dwg")


WORLD = [{"gravity": {"x": 0, "y": 0}, "bodies": [{"refIndex": 1, "refType": "Body"}], "joints": []}]


class TestDamage:
    @pytest.mark.parametrize(
        ("body", "message"),
        [
            (None, "refers to entry 1, which is no object of this file"),
            ({"type": "soft"}, 'must be "static", "kinematic" or "dynamic"'),
            ({"type": "static", "fixtures": [{"refIndex": 1e9}]}, "refers to entry 1000000000"),
        ],
    )
    def test_references_that_lead_nowhere(self, read: Read, body: Any, message: str) -> None:
        with pytest.raises(SceneError) as error:
            read([*WORLD, body])
        assert message in str(error.value)
        assert error.value.problems[0].line == 1

    def test_a_shape_of_another_kind_is_left_out(self, read: Read) -> None:
        fixture = {"shape": {"type": "blob"}}
        body = {"type": "static", "fixtures": [{"refIndex": 2}]}
        assert texts(read([*WORLD, body, fixture]))[0].startswith("a fixture without a circle")


def test_the_file_is_plain_json() -> None:
    data = json.loads(export_scene(Scene(bodies=[{"id": "a", "shapes": [{"circle": 1}]}]), "planck").text)
    assert data[0]["bodies"] == [{"refIndex": 3, "refType": "Body"}]
