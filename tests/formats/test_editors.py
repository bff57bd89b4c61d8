"""Physics Body Editor and PhysicsEditor: shapes without places."""

from __future__ import annotations

from typing import Any

import pytest

from sandbox.errors import SceneError
from tests.formats.conftest import Read, texts

TRIANGLE = [{"x": 0, "y": 0}, {"x": 1, "y": 0}, {"x": 0, "y": 1}]


def project(**fields: Any) -> dict[str, Any]:
    body = {
        "name": "rock",
        "imagePath": "rock.png",
        "origin": {"x": 0.5, "y": 0},
        "polygons": [TRIANGLE],
        "circles": [],
    }
    return {"rigidBodies": [{**body, **fields}], "dynamicObjects": []}


class TestBodyEditor:
    def test_points_count_from_the_origin_and_the_image_is_as_wide_as_asked(self, read: Read) -> None:
        imported = read(project(), units=0.5)
        (body,) = imported.scene.bodies
        assert body.shapes[0].polygon == ((-1, 0), (1, 0), (-1, 2))
        assert texts(imported) == ["images are left out", "the file has no places: bodies stand side by side"]

    def test_what_was_drawn_comes_before_its_parts(self, read: Read) -> None:
        drawn = [{"type": "POLYGON", "vertices": [*TRIANGLE, {"x": 0.2, "y": 0.2}]},
                 {"type": "CIRCLE", "vertices": [{"x": 1, "y": 1}, {"x": 1, "y": 1.25}]}]  # fmt: skip
        shapes = read(project(shapes=drawn)).scene.bodies[0].shapes
        assert (len(shapes[0].polygon), shapes[1].circle, shapes[1].at) == (4, 0.25, (0.5, 1))

    def test_parts_stand_in_for_what_cannot_be(self, read: Read) -> None:
        crossed = [{"x": 0, "y": 0}, {"x": 1, "y": 1}, {"x": 1, "y": 0}, {"x": 0, "y": 1}]
        circles = [{"cx": 0.5, "cy": 2, "r": 0.5}]
        shapes = (
            read(project(shapes=[{"type": "POLYGON", "vertices": crossed}], circles=circles)).scene.bodies[0].shapes
        )
        assert (len(shapes[0].polygon), shapes[1].circle) == (3, 0.5)

    def test_bodies_stand_side_by_side(self, read: Read) -> None:
        data = project()
        data["rigidBodies"] = data["rigidBodies"] * 3
        bodies = read(data).scene.bodies
        assert [body.position for body in bodies] == [(0.5, 0), (1.75, 0), (3, 0)]

    def test_damage(self, read: Read) -> None:
        with pytest.raises(SceneError, match="must be a list of points"):
            read(project(polygons=[5]))


MATTER = {
    "generator_info": "Shape definitions generated with PhysicsEditor.",
    "star": {
        "type": "fromPhysicsEditor", "label": "star", "isStatic": False, "density": 0.001, "restitution": 0.5,
        "friction": 0.25, "frictionAir": 0.01, "frictionStatic": 0.5,
        "collisionFilter": {"group": -1, "category": 2, "mask": 255},
        "fixtures": [{"isSensor": False, "vertices": [[{"x": 0, "y": 0}, {"x": 64, "y": 0}, {"x": 64, "y": 32}]]},
                     {"isSensor": True, "circle": {"x": 32, "y": 16, "radius": 8}}],
    },
}  # fmt: skip


class TestPhysicsEditor:
    def test_for_matter(self, read: Read) -> None:
        imported = read(MATTER)
        (body,) = imported.scene.bodies
        polygon, circle = body.shapes
        assert polygon.polygon == ((-1, 0.5), (1, 0.5), (1, -0.5))
        assert polygon.density == pytest.approx(0.001 * 32**2)
        assert (polygon.group, polygon.category, polygon.mask, polygon.restitution) == (-1, 2, 255, 0.5)
        assert (circle.circle, circle.at, circle.sensor) == (0.25, (0, 0), True)
        assert body.linear_damping == pytest.approx(0.6)
        assert any(text.startswith("static friction") for text in texts(imported))

    def test_for_p2_and_lime(self, read: Read) -> None:
        fixture = {"density": 2, "friction": 0, "bounce": 0.5, "filter": {"categoryBits": 1, "maskBits": 65535}}
        (body,) = read({"ship": [{**fixture, "shape": [0, 0, 32, 0, 0, 32]}]}).scene.bodies
        (shape,) = body.shapes
        assert shape.polygon == ((-0.5, 0.5), (0.5, 0.5), (-0.5, -0.5))
        assert (shape.density, shape.friction, shape.restitution) == (2, 0, 0.5)

    @pytest.mark.parametrize(("shape", "message"), [([1], "two numbers for each corner"), (["x"], "must be a number")])
    def test_damage(self, read: Read, shape: Any, message: str) -> None:
        with pytest.raises(SceneError, match=message):
            read({"ship": [{"density": 1, "shape": shape}]})
