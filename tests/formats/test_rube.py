"""R.U.B.E. scenes: defaults, masses, chains, joints, and what is listed as left out."""

from __future__ import annotations

import math
import struct
from typing import Any

import pytest

from sandbox.engine.world import World
from sandbox.errors import SceneError
from tests.formats.conftest import Read, texts

SQUARE = {"x": [-1, 1, 1, -1], "y": [-1, -1, 1, 1]}
BOX = {"name": "box", "density": 1, "friction": 0.2, "polygon": {"vertices": SQUARE}}
GROUND = {"name": "ground", "type": 0, "position": 0, "fixture": [{"polygon": {"vertices": SQUARE}}]}


def hexed(value: float) -> str:
    return struct.pack(">f", value).hex().upper()


def crate(**fields: Any) -> dict[str, Any]:
    return {"name": "crate", "type": 2, "position": {"x": 0, "y": 5}, "awake": True, "fixture": [BOX], **fields}


def world(*bodies: dict[str, Any], joint: list[dict[str, Any]] | None = None, **fields: Any) -> dict[str, Any]:
    return {"gravity": {"x": 0, "y": -10}, "body": list(bodies), "joint": joint or [], **fields}


class TestBodies:
    def test_numbers_may_be_zero_vectors_and_bytes_in_hexadecimal(self, read: Read) -> None:
        body = crate(position={"x": hexed(1.5), "y": hexed(-0.1)}, linearVelocity=0, angle=math.pi / 2)
        scene = read(world(body)).scene
        assert scene.bodies[0].position == (1.5, -0.1)
        assert scene.bodies[0].angle == pytest.approx(90)
        assert scene.gravity == (0, -10)

    def test_what_is_left_out_of_a_file_has_the_defaults_of_the_loader(self, read: Read) -> None:
        (shape,) = read(world({"type": 0, "fixture": [{"circle": {"radius": 1}}]})).scene.flatten().bodies[0].shapes
        assert (shape.friction, shape.restitution, shape.density) == (0, 0, 0)
        assert (shape.category, shape.mask, shape.group) == (1, 0xFFFFFFFF, 0)

    def test_mass_data_that_the_shapes_explain_is_not_written(self, read: Read) -> None:
        mass, inertia = 4.0, 4.0 * (4 + 4) / 12
        same = {"massData-mass": mass, "massData-center": 0, "massData-I": inertia}
        other = {"massData-mass": 7.0, "massData-center": {"x": 0.5, "y": 0}, "massData-I": 9.0}
        one, two = read(world(crate(**same), crate(**other))).scene.bodies
        assert (one.mass, one.inertia, one.center) == (None, None, None)
        assert (two.mass, two.inertia, two.center) == (7, 9 - 7 * 0.25, (0.5, 0))

    def test_a_dynamic_body_without_density_weighs_a_kilogram_and_does_not_turn(self, read: Read) -> None:
        light = {**BOX, "density": 0}
        (body,) = read(world(crate(fixture=[light]))).scene.flatten().bodies
        assert (body.mass, body.fixed_rotation) == (1, True)

    def test_sensors_weigh_as_much_as_in_box2d(self, read: Read) -> None:
        feeler = {"density": 1, "sensor": True, "circle": {"center": 0, "radius": 1}}
        (body,) = read(world(crate(fixture=[BOX, feeler]))).scene.bodies
        assert body.mass == pytest.approx(4 + math.pi)
        assert body.shapes[1].sensor

    def test_groups_keep_their_sign(self, read: Read) -> None:
        for group in (3, -3):
            fixture = {**BOX, "filter-groupIndex": group, "filter-maskBits": 6, "filter-categoryBits": 4}
            (shape,) = read(world(crate(fixture=[fixture]))).scene.bodies[0].shapes
            assert (shape.group, shape.mask, shape.category) == (group, 6, 4)

    def test_a_polygon_that_is_not_convex_is_its_hull(self, read: Read) -> None:
        dented = {"x": [-1, 1, 0.2, -1], "y": [-1, -1, -0.5, 1]}
        imported = read(world(crate(fixture=[{**BOX, "polygon": {"vertices": dented}}])))
        assert len(imported.scene.bodies[0].shapes[0].polygon) == 3
        assert "a polygon that is not convex is its hull, as in Box2D" in texts(imported)

    def test_what_is_not_carried_over_is_listed_with_its_place(self, read: Read) -> None:
        asleep = crate(awake=False, customProperties=[{"name": "hp", "int": 3}])
        gone = {**GROUND, "active": False}
        imported = read(world(asleep, gone, image=[{"name": "sky"}], velocityIterations=8))
        assert {tuple(remark) for remark in imported.remarks} == {
            ('body[0] "crate"', "custom properties are left out"),
            ('body[0] "crate"', "a sleeping body begins awake"),
            ('body[1] "ground"', "a body that is not active is left out"),
            ('image[0] "sky"', "images are left out"),
            ("", "numbers of iterations are left out: this engine has substeps"),
        }

    def test_names_become_ids_that_are_unique(self, read: Read) -> None:
        scene = read(world(crate(name="my box!"), crate(name="my box!"), crate(name=""))).scene
        assert [body.id for body in scene.bodies] == ["my-box", "my-box-2", "body-3"]


LINE = {"x": [0, 1, 2], "y": [0, 0, 1]}


class TestChains:
    def shape(self, read: Read, chain: dict[str, Any]) -> Any:
        imported = read(world({"type": 0, "fixture": [chain]}))
        return imported.scene.bodies[0].shapes[0], texts(imported)

    def test_with_both_ghosts(self, read: Read) -> None:
        ends = {"hasPrevVertex": True, "prevVertex": {"x": -1, "y": 0}, "hasNextVertex": True, "nextVertex": 0}
        shape, remarks = self.shape(read, {"chain": {"vertices": LINE, **ends}})
        assert shape.ghosts == ((-1, 0), (0, 0))
        assert remarks == []

    def test_with_one_ghost(self, read: Read) -> None:
        ends = {"hasPrevVertex": True, "prevVertex": {"x": -1, "y": 0}}
        shape, remarks = self.shape(read, {"chain": {"vertices": LINE, **ends}})
        assert shape.ghosts is None
        assert len(remarks) == 1

    def test_a_line_back_to_its_start_is_closed(self, read: Read) -> None:
        ring = {"x": [0, 1, 1, 0], "y": [0, 0, 1, 0]}
        shape, _ = self.shape(read, {"chain": {"vertices": ring}})
        assert shape.closed
        assert len(shape.chain) == 3

    def test_an_edge_is_a_segment(self, read: Read) -> None:
        shape, _ = self.shape(read, {"edge": {"vertex1": 0, "vertex2": {"x": 2, "y": 0}}})
        assert shape.segment == ((0, 0), (2, 0))


def joined(kind: str, **fields: Any) -> dict[str, Any]:
    base = {"type": kind, "name": kind, "bodyA": 0, "bodyB": 1, "anchorA": {"x": 0, "y": 5}, "anchorB": 0}
    return world(GROUND, crate(), joint=[{**base, **fields}])


class TestJoints:
    def test_angles_count_from_the_start_and_are_degrees(self, read: Read) -> None:
        limits = {"enableLimit": True, "lowerLimit": -1, "upperLimit": 1, "refAngle": 0.5}
        (joint,) = read(joined("revolute", **limits, enableMotor=True, motorSpeed=2, maxMotorTorque=3)).scene.joints
        assert joint.lower == pytest.approx(math.degrees(-0.5))
        assert joint.upper == pytest.approx(math.degrees(1.5))
        assert (joint.motor_speed, joint.max_torque) == (pytest.approx(math.degrees(2)), 3)

    def test_a_limit_that_is_far_away_is_none(self, read: Read) -> None:
        limits = {"enableLimit": True, "lowerLimit": -1, "upperLimit": 3.4e18}
        (joint,) = read(joined("revolute", **limits)).scene.joints
        assert (joint.lower, joint.upper) == (pytest.approx(math.degrees(-1)), None)

    def test_slides_count_from_the_start(self, read: Read) -> None:
        fields = {"localAxisA": {"x": 0, "y": 1}, "anchorA": {"x": 0, "y": 4}}
        (joint,) = read(joined("prismatic", **fields, enableLimit=True, lowerLimit=0, upperLimit=3)).scene.joints
        assert (joint.lower, joint.upper, joint.axis) == (-1, 2, (0, 1))

    def test_a_suspension_rests_where_box2d_has_it(self, read: Read) -> None:
        fields = {"localAxisA": {"x": 0, "y": 1}, "anchorA": {"x": 0, "y": 4}}
        (joint,) = read(joined("wheel", **fields, springFrequency=4, springDampingRatio=0.5)).scene.joints
        assert (joint.hertz, joint.damping_ratio, joint.rest) == (4, 0.5, -1)
        (loose,) = read(joined("wheel", **fields)).scene.joints
        assert loose.hertz is None

    def test_stiffness_becomes_the_frequency_with_which_it_swings(self, read: Read) -> None:
        (joint,) = read(joined("distance", length=2, stiffness=4 * 9, damping=4, anchorA={"x": 0, "y": 3})).scene.joints
        assert joint.hertz == pytest.approx(3 / (2 * math.pi))  # of 4 kg
        assert joint.damping_ratio == pytest.approx(4 / (2 * 4 * 3))

    @pytest.mark.parametrize(
        ("kind", "fields", "wanted"),
        [
            ("rope", {"maxLength": 7}, {"type": "distance", "max": 7}),
            ("weld", {"frequency": 5, "dampingRatio": 1}, {"type": "weld", "hertz": 0, "angular_hertz": 5}),
            ("friction", {"maxForce": 2, "maxTorque": 3}, {"type": "friction", "max_force": 2, "max_torque": 3}),
            ("motor", {"linearOffset": {"x": 1, "y": 5}, "maxForce": 9}, {"type": "motor", "offset": (1, 0)}),
            ("mouse", {"target": {"x": 1, "y": 2}, "frequency": 4}, {"type": "target", "target": (1, 2), "hertz": 4}),
        ],
    )
    def test_other_kinds(self, read: Read, kind: str, fields: dict[str, Any], wanted: dict[str, Any]) -> None:
        (joint,) = read(joined(kind, **fields)).scene.joints
        assert {key: getattr(joint, key) for key in wanted} == wanted

    def test_a_joint_that_moves_nobody_is_left_out(self, read: Read) -> None:
        imported = read(world(GROUND, GROUND, joint=[{"type": "weld", "name": "glue", "bodyA": 0, "bodyB": 1}]))
        assert imported.scene.joints == ()
        (remark,) = imported.remarks
        assert remark.place == 'joint[0] "glue"'

    def test_a_static_body_without_shapes_is_the_world(self, read: Read) -> None:
        pin = {"type": "revolute", "bodyA": 0, "bodyB": 1, "anchorA": {"x": 0, "y": 5}, "anchorB": 0}
        imported = read(world({"type": 0}, crate(), joint=[pin]))
        assert imported.scene.joints[0].bodies == (None, "crate")
        assert imported.remarks == ()

    def test_gears_count_joints_as_b2djson_does(self, read: Read) -> None:
        hinge = {"type": "revolute", "bodyA": 0, "anchorA": {"x": 0, "y": 5}}
        gear = {"type": "gear", "bodyA": 1, "bodyB": 2, "joint1": 0, "joint2": 1, "ratio": 2}
        first, second = {**hinge, "name": "one", "bodyB": 1}, {**hinge, "name": "two", "bodyB": 2}
        scene = read(world(GROUND, crate(), crate(), joint=[gear, first, second])).scene
        assert scene.joints[-1].joints == ("one", "two")

    def test_anchors_that_stand_apart_are_told(self, read: Read) -> None:
        imported = read(joined("revolute", anchorA={"x": 0, "y": 4}))
        assert imported.scene.joints[0].anchor == (0, 5)
        assert imported.remarks[0].place == 'joint[0] "revolute" (1 m)'


DENTED = {"x": [-1, 1, 0.2, -1], "y": [-1, -1, -0.5, 1]}


def saved(**fields: Any) -> dict[str, Any]:
    """A project of the editor: bodies by id, fixtures as they were drawn."""
    line = {"id": 4, "shapes": [{"type": "line"}], "vertices": {"x": [-9, 9], "y": [0, 0]}}
    ground = {"id": 3, "name": "ground", "type": "static", "position": 0, "fixture": [line]}
    solid = {"id": 8, "density": 1, "shapes": [{"type": "polygon"}], "vertices": DENTED}
    ball = {"density": 1, "shapes": [{"type": "circle", "radius": 0.5}], "vertices": {"x": [2], "y": [0]}}
    hero = {"id": 7, "name": "hero", "type": "dynamic", "awake": True, "position": {"x": 0, "y": 5},
            "fixture": [solid, ball]}  # fmt: skip
    pin = {"id": 1, "type": "revolute", "bodyA": 3, "bodyB": 7, "anchorA": {"x": 0, "y": 5}, "anchorB": 0,
           "referenceAngle": 0.5, "enableLimit": True, "lowerLimit": -1, "upperLimit": 1}  # fmt: skip
    return {"metaworld": {"gravity": 0, "metabody": [ground, hero], "metajoint": [pin], **fields}}


class TestProjects:
    def test_are_read_like_what_the_editor_exports(self, read: Read) -> None:
        imported = read(saved(), "level.rube")
        ground, hero = imported.scene.bodies
        assert (ground.type, ground.shapes[0].segment) == ("static", ((-9, 0), (9, 0)))
        *parts, ball = hero.shapes
        assert sorted(len(part.polygon) for part in parts) == [3, 3]
        assert (ball.circle, ball.at) == (0.5, (2, 0))
        (pin,) = imported.scene.joints
        assert (pin.bodies, pin.lower) == (("ground", "hero"), pytest.approx(math.degrees(-0.5)))
        assert imported.remarks == ()

    def test_what_lies_in_other_files_is_told(self, read: Read) -> None:
        (remark,) = read(saved(metaobject=[{"name": "tree", "file": "tree.rube"}]), "level.rube").remarks
        assert remark == ('metaworld.metaobject[0] "tree"',
                          "objects of other files are left out: export the scene in R.U.B.E.")  # fmt: skip


def test_no_field_is_dropped_in_silence(read: Read) -> None:
    spun = {"angle": 1, "massData-I": 2, "path": "a/b", "windFactor": 3, "enableWind": False}
    imported = read(world(crate(**spun), joint=[], tides=[1]))
    assert [tuple(remark) for remark in imported.remarks] == [
        ('body[0] "crate" (windFactor)', "fields that mean nothing to a scene are left out"),
        ("(tides)", "fields that mean nothing to a scene are left out"),
    ]


def test_strengths_past_all_bounds_are_the_greatest_that_a_scene_has(read: Read) -> None:
    strong = {"enableMotor": True, "motorSpeed": 1, "maxMotorTorque": 3.4028234663852886e38}
    (joint,) = read(joined("revolute", **strong)).scene.joints
    assert joint.max_torque == 1e15


class TestDamage:
    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ('{"body": [{"type": 2,\n "position": "up"}]}', "2:14: must be {"),
            ('{"body": [{"type": 7}]}', "1:20: must be 0 (static), 1 (kinematic) or 2 (dynamic)"),
            ('{"body": [\n5]}', "2:1: must be an object, not a number"),
            ('{"body": [{"angle": NaN}]}', "1:21: must be a finite number"),
            ('{"body": [{"fixture": [{"polygon": {"vertices": {"x": [1], "y": []}}}]}]}', '"x" has 1 entries'),
            ('{"body": [', "the file ends too early"),
        ],
    )  # fmt: skip
    def test_one_message_with_its_place(self, read: Read, text: str, message: str) -> None:
        with pytest.raises(SceneError) as error:
            read(text)
        assert len(error.value.problems) == 1
        assert message in str(error.value)


def test_it_runs(read: Read) -> None:
    moving = World(read(joined("distance", length=5, collideConnected=True)).scene)
    moving.step(30)
    assert not [event for event in moving.events if event["event"] == "freeze"]
