"""Loading a scene: the example of the format, defaults, prefabs, materials, places in the file."""

from __future__ import annotations

import math
import subprocess
import sys

import numpy as np
import pytest

from sandbox.errors import SceneError
from sandbox.scene import Body, BoxShape, CircleShape, FlatBody, FlatSettings, FlatShape, Scene, load_scene, loads_scene

RAMP = """{
  "$schema": "../scene.schema.json", "format": 1,
  "title": "Crates on a ramp", "about": "What to watch for.",
  "gravity": [0, -9.81],
  "materials": {"wood": {"density": 0.7, "friction": 0.5, "restitution": 0.1}},
  "bodies": [
    {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
    {"id": "crate", "position": [0, 5], "angle": 15, "material": "wood", "shapes": [{"box": [1, 1]}]},
    {"id": "ball", "position": [3, 4], "velocity": [-2, 0],
     "shapes": [{"circle": 0.5, "at": [0, 0.1], "restitution": 0.8}]}
  ],
  "expect": [{"at": 300, "rests": "crate"}, {"always": true, "inside": [-20, -1, 20, 20]}]
}"""


def flat_bodies(**fields) -> dict[str, FlatBody]:
    return {body.id: body for body in Scene(**fields).flatten().bodies}


def flat_body(**fields) -> FlatBody:
    return flat_bodies(bodies=[{"id": "it", "shapes": [{"circle": 1}], **fields}])["it"]


def test_the_example_of_the_format_flattens_to_its_values():
    ground, crate, ball = loads_scene(RAMP).flatten().bodies
    square = ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))
    wood = FlatShape(kind="box", vertices=square, density=0.7, friction=0.5, restitution=0.1)
    assert crate == FlatBody(
        id="crate",
        type="dynamic",
        shapes=(wood,),
        position=(0, 5),
        angle=math.radians(15),
        pointer="/bodies/1",
    )
    assert ground.type == "static"
    assert ground.shapes[0].vertices[2] == (20, 0.5)
    assert ball.velocity == (-2, 0)
    assert ball.shapes == (FlatShape(kind="circle", vertices=((0, 0.1),), radius=0.5, restitution=0.8),)


def test_an_empty_object_is_a_scene_with_the_default_settings():
    scene = loads_scene("{}")
    assert scene.flatten().settings == FlatSettings()
    assert scene.flatten().gravity == (0, -9.81)
    assert scene.settings.steps == 300


def test_settings_reach_the_flat_scene():
    scene = Scene(settings={"step_rate": 120, "substeps": 8, "sleeping": False}, gravity=[1, 2])
    assert scene.flatten().settings == FlatSettings(step_rate=120, substeps=8, sleeping=False)
    assert scene.flatten().gravity == (1, 2)


def test_degrees_of_the_file_are_radians_of_the_api():
    body = flat_body(angle=180, angular_velocity=-90)
    assert body.angle == pytest.approx(math.pi)
    assert body.angular_velocity == pytest.approx(-math.pi / 2)


def test_own_fields_win_over_the_prefabs_even_with_default_values():
    prefabs = {"p": {"angle": 90, "linear_damping": 2, "shapes": [{"circle": 1}]}}
    bodies = flat_bodies(
        prefabs=prefabs, bodies=[{"id": "same", "prefab": "p"}, {"id": "own", "prefab": "p", "angle": 0}]
    )
    assert bodies["same"].angle == pytest.approx(math.pi / 2)
    assert bodies["own"].angle == 0
    assert bodies["own"].linear_damping == 2
    assert bodies["own"].shapes is bodies["same"].shapes


def test_a_shape_takes_its_own_value_then_its_material_then_the_bodys():
    materials = {"ice": {"friction": 0.01}, "mud": {"friction": 2, "density": 3}}
    body = {"id": "it", "material": "mud", "shapes": [
        {"circle": 1}, {"circle": 1, "material": "ice"}, {"circle": 1, "material": "ice", "friction": 1},
    ]}  # fmt: skip
    shapes = flat_bodies(materials=materials, bodies=[body])["it"].shapes
    assert [shape.friction for shape in shapes] == [2, 0.01, 1]
    assert [shape.density for shape in shapes] == [3, 1, 1]


def test_a_bodys_material_holds_for_the_shapes_of_its_prefab():
    materials = {"ice": {"friction": 0.01}, "mud": {"friction": 2}}
    bodies = flat_bodies(
        materials=materials,
        prefabs={"p": {"material": "mud", "shapes": [{"circle": 1}]}},
        bodies=[{"id": "a", "prefab": "p"}, {"id": "b", "prefab": "p", "material": "ice"}],
    )
    assert bodies["a"].shapes[0].friction == 2
    assert bodies["b"].shapes[0].friction == 0.01


def test_category_names_are_bits_above_default():
    shapes = [
        {"circle": 1},
        {"circle": 1, "category": "player", "mask": ["default", "debris"]},
        {"circle": 1, "category": ["player", "debris"], "mask": 0, "group": -2},
    ]
    body = flat_bodies(categories=["player", "debris"], bodies=[{"id": "it", "shapes": shapes}])["it"]
    assert [shape.category for shape in body.shapes] == [1, 2, 6]
    assert [shape.mask for shape in body.shapes] == [0xFFFFFFFF, 5, 0]
    assert body.shapes[2].group == -2


def test_a_located_pointer_is_a_line_and_a_column():
    scene = loads_scene(RAMP)
    assert scene.locate("/bodies/1") == (8, 5)
    assert scene.locate("/bodies/1/angle") == (8, 50)
    assert scene.locate("/expect/1") == (12, 45)
    assert scene.locate("/expect/1/nothing") == (12, 45)
    assert scene.locate("") == (1, 1)
    assert Scene().locate("/bodies/1") is None


def test_a_byte_order_mark_is_passed_over(tmp_path):
    path = tmp_path / "x.json"
    path.write_text(RAMP, encoding="utf-8-sig")
    scene = load_scene(path)
    assert scene.source == str(path)
    assert scene == loads_scene(RAMP)
    assert scene.locate("/bodies/1") == (8, 5)


def test_flattening_twice_gives_the_same_object():
    scene = loads_scene(RAMP)
    assert scene.flatten() is scene.flatten()


def test_models_build_a_scene_in_python():
    ball = Body(id="ball", position=np.array([1, 2]), shapes=[CircleShape(circle=np.float64(0.5))])
    scene = Scene(bodies=[ball, Body(id="box", shapes=[BoxShape(box=(1, 2))])])
    assert scene.flatten().bodies[0].position == (1, 2)


@pytest.mark.parametrize(
    ("build", "message"),
    [
        (lambda: Scene(bodies=[{"id": "a", "shpaes": []}]), 'unknown field "shpaes" (at /bodies/0/shpaes)'),
        (
            lambda: Body(id="a", positoin=(0, 0)),
            'unknown field "positoin" (at /positoin) did you mean "position"?',
        ),
        (lambda: CircleShape(circle=-1), "circle must not be below 1e-06 m (at /circle)"),
        (lambda: CircleShape(circle=float("nan")), "circle must be a finite number"),
        (lambda: Scene(bodies=[Body(id="a", prefab="x")]), 'no prefab is named "x" (at /bodies/0/prefab)'),
        (lambda: Scene().model_copy(update={"bodies": [Body(id="a")]}), 'the body "a" has no shapes'),
    ],
)
def test_mistakes_in_python_are_scene_errors(build, message):
    with pytest.raises(SceneError) as caught:
        build()
    assert message in str(caught.value)


def test_a_changed_copy_is_another_scene():
    scene = loads_scene(RAMP)
    copy = scene.model_copy(update={"title": "Other", "gravity": (0, 0)})
    assert copy.flatten().gravity == (0, 0)
    assert copy.bodies == scene.bodies
    assert scene.flatten().gravity == (0, -9.81)
    assert copy != scene


def test_a_scene_does_not_change():
    with pytest.raises(AttributeError, match="title of Scene is read-only"):
        Scene().title = "x"


def test_importing_scenes_is_light():
    code = "import sandbox.scene, sys; print([m for m in ('numpy', 'numba', 'pygame') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
