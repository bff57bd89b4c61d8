"""Recordings of Box2D v3, written here by the same tables; damage is told, never a traceback."""

from __future__ import annotations

import math
import struct
import tempfile
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.errors import SceneError
from sandbox.formats import Imported, import_scene
from sandbox.formats.b2rec.layouts import LAYOUTS, PRIMITIVES
from sandbox.formats.b2rec.ops import OPS

CODES = {op.name: (code, op.fields) for code, op in OPS.items()}


def put(tag: str, value: Any) -> bytes:
    """A value as Box2D writes it; what a structure is not told is 0."""
    if tag in LAYOUTS:
        return b"".join(put(kind, (value or {}).get(name)) for name, kind in LAYOUTS[tag])
    if tag == "STR":
        return struct.pack("<H", len(value or "")) + (value or "").encode()
    if tag.startswith("LIST-"):
        return struct.pack("<i", len(value or [])) + b"".join(put(tag[5:], each) for each in value or [])
    code = "2f" if tag == "POSITION" else PRIMITIVES[tag]
    count = int(code[:-1] or 1)
    numbers = [value or 0] if count == 1 else [*(value or ())] + [0.0] * (count - len(value or ()))
    return struct.pack("<" + code, *numbers)


def call(name: str, **given: Any) -> bytes:
    code, fields = CODES[name]
    body = b"".join(put(tag, given.get(key)) for key, tag in fields)
    return bytes([code]) + len(body).to_bytes(3, "little") + body


def recording(*calls: bytes, bodies: int = 0, version: tuple[int, int] = (3, 4)) -> bytes:
    config = struct.pack("<4I2f7fQi2fi5iB2i", 0x32534E42, 4, 0, 0, 0, -10, 1, 1, 4, 3, 30, 10, 0, 0, 0, 0, 0, 0,
                         0, 0, 0, 0, 0, 0x13, bodies, 0)  # fmt: skip
    head = struct.pack("<4s2HIf4BIQ", b"B2RC", *version, 0, 1.0, 0, 8, 0, 0, 0, len(config))
    return head + config + b"".join(calls)


def body(key: int, name: str, **given: Any) -> bytes:
    usual = {"rotation": (1, 0), "gravityScale": 1, "sleepThreshold": 0.05, "type": 2, "isEnabled": 1, "isAwake": 1,
             "enableSleep": 1}  # fmt: skip
    return call("CreateBody", **{"made": key, "def": usual | {"name": name} | given})


def disc(key: int, on: int) -> bytes:
    shape = {"density": 1.0, "material": {"friction": 0.5}, "filter": {"categoryBits": 1, "maskBits": 2**64 - 1}}
    return call("CreateCircleShape", **{"made": key, "body": on, "def": shape, "circle": {"radius": 0.5}})


STEP = call("Step", dt=1 / 60, subStepCount=4)
WORLD = recording(
    body(7, "ball", position=(1.5, 2)), disc(1, 7), body(8, "gone"), disc(2, 8), call("DestroyBody", body=8),
    call("BodySetLinearVelocity", body=7, v=(3, 0)), STEP, call("BodyApplyTorque", body=7), STEP,
)  # fmt: skip


def opened(data: bytes) -> Imported:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "session.b2rec")
        path.write_bytes(data)
        return import_scene(path)


def test_the_scene_is_the_world_at_the_first_step() -> None:
    found = opened(WORLD)
    (ball,) = found.scene.bodies
    assert (found.format, ball.id, ball.position, ball.velocity) == ("b2rec", "ball", (1.5, 2.0), (3.0, 0.0))
    assert [remark.text for remark in found.remarks] == [
        "calls after the first step that are left out: 1 BodyApplyTorque"
    ]


@pytest.mark.parametrize(
    ("data", "message"),
    [(recording(bodies=3), "begins with bodies in the world"), (recording(version=(3, 2)), "version 3.2"),
     (WORLD[:-1], "byte"), (recording(b"\xee\0\0\0"), "unknown kind 0xEE")],
)  # fmt: skip
def test_what_cannot_be_read_is_told(data: bytes, message: str) -> None:
    with pytest.raises(SceneError, match=message):
        opened(data)


SPUN = {"linearVelocity": (1, 0), "angularVelocity": 2}
SOLID = {"density": 1.0, "material": {"friction": 0.5}, "filter": {"categoryBits": 1, "maskBits": 2**64 - 1}}
MASS = math.pi / 4  # of a disc of radius 0.5


def aside(key: int, on: int, x: float) -> bytes:
    """A disc that is not at the origin of its body."""
    circle = {"radius": 0.5, "center": (x, 0)}
    return call("CreateCircleShape", **{"made": key, "body": on, "def": SOLID, "circle": circle})


class TestMotion:
    """Velocities are those of the centre of mass, which moves while shapes are made."""

    @pytest.mark.parametrize(
        ("calls", "velocity", "spin"),
        [
            ([body(7, "a", **SPUN), aside(1, 7, 3)], (1, 6), 2),
            ([body(7, "a"), aside(1, 7, 3), call("BodySetLinearVelocity", body=7, v=(1, 0)),
              call("BodySetAngularVelocity", body=7, w=2)], (1, 0), 2),
            ([body(7, "a"), call("BodySetLinearVelocity", body=7, v=(1, 0)),
              call("BodySetAngularVelocity", body=7, w=2), aside(1, 7, 3)], (1, 6), 2),
            ([body(7, "a", **SPUN), aside(1, 7, 3), aside(2, 7, -3)], (1, 0), 2),
            ([body(7, "a", **SPUN), aside(1, 7, 3), aside(2, 7, -3), call("DestroyShape", shape=2)], (1, 6), 2),
            ([body(7, "a", **SPUN), aside(1, 7, 3),
              call("BodySetMassData", body=7, massData={"mass": 1, "rotationalInertia": 1})], (1, 6), 2),
            ([body(7, "a"), disc(1, 7), call("BodyApplyLinearImpulseToCenter", body=7, impulse=(MASS, 0))], (1, 0), 0),
            ([body(7, "a"), disc(1, 7), call("BodyApplyLinearImpulse", body=7, impulse=(0, MASS), point=(0.25, 0))],
             (0, 1), 2),
            ([body(7, "a"), disc(1, 7), call("BodyApplyAngularImpulse", body=7, impulse=MASS / 8)], (0, 0), 1),
            ([body(7, "a"), disc(1, 7), call("BodyApplyForceToCenter", body=7, force=(60 * MASS, 0)),
              call("BodyApplyTorque", body=7, torque=60 * MASS / 8)], (1, 0), 1),
            ([body(7, "a"), disc(1, 7), call("BodyApplyTorque", body=7, torque=9), call("BodyClearForces", body=7)],
             (0, 0), 0),
        ],
    )  # fmt: skip
    def test_at_the_first_step(self, calls: list[bytes], velocity: tuple[float, float], spin: float) -> None:
        found = opened(recording(*calls, STEP))
        (made,) = found.scene.bodies
        assert made.velocity == pytest.approx(velocity, abs=1e-6)
        assert math.radians(made.angular_velocity) == pytest.approx(spin, abs=1e-6)
        assert found.remarks == ()


def on_the_ground(*calls: bytes) -> Imported:
    return opened(recording(body(1, "ground", type=0), *calls, STEP))


SQUARE = {"vertices": (-1, -1, 1, -1, 1, 1, -1, 1), "count": 4, "radius": 0.25}
LINE = {"points": [(0, 0), (1, 0), (2, 1), (3, 1)], "filter": {"categoryBits": 1, "maskBits": 2**64 - 1}}


class TestShapes:
    def test_polygons_keep_their_rounding_and_filter(self) -> None:
        shape = SOLID | {"filter": {"categoryBits": 4, "maskBits": 6, "groupIndex": -2}, "isSensor": 1}
        made = call("CreatePolygonShape", **{"made": 1, "body": 1, "def": shape, "polygon": SQUARE})
        (found,) = on_the_ground(made).scene.bodies[0].shapes
        assert (len(found.polygon), found.radius, found.sensor) == (4, 0.25, True)
        assert (found.category, found.mask, found.group) == (4, 6, -2)

    def test_of_64_bits_the_lower_are_kept(self) -> None:
        shape = SOLID | {"filter": {"categoryBits": 1 << 40, "maskBits": 1 << 40}}
        made = call("CreateSegmentShape", **{"made": 1, "body": 1, "def": shape, "segment": {"point2": (1, 0)}})
        assert [each.text for each in on_the_ground(made).remarks] == ["of 64 bits of a filter the lower 32 are kept"]

    @pytest.mark.parametrize(("loop", "points"), [(0, ((2, 1), (1, 0))), (1, ((3, 1), (2, 1), (1, 0), (0, 0)))])
    def test_chains_are_turned_round_and_their_material_may_change(self, loop: int, points: Any) -> None:
        made = call("CreateChain", **{"made": 5, "body": 1, "def": LINE | {"isLoop": loop, "materials": [{}]}})
        slick = call("ChainSetSurfaceMaterial", chain=5, material={"friction": 0.25}, materialIndex=0)
        found = on_the_ground(made, slick)
        (chain,) = found.scene.bodies[0].shapes
        assert (chain.chain, chain.one_sided, chain.friction) == (points, True, 0.25)
        assert loop or chain.ghosts == ((3, 1), (0, 0))
        assert found.remarks == ()

    def test_a_segment_of_a_chain_may_be_set_anew(self) -> None:
        segment = {"ghost1": (-1, 0), "point1": (0, 0), "point2": (1, 0), "ghost2": (2, 0)}
        made = call("CreateChainSegmentShape", **{"made": 5, "body": 1, "def": SOLID, "chainSegment": segment})
        moved = call("ShapeSetChainSegment", shape=5, chainSegment=segment | {"point2": (1, 1)})
        found = on_the_ground(made, moved)
        assert found.scene.bodies[0].shapes[0].chain == ((1, 1), (0, 0))
        assert found.remarks == ()

    def test_a_material_that_is_not_there_is_told(self) -> None:
        made = call("CreateChain", **{"made": 5, "body": 1, "def": LINE | {"materials": [{}]}})
        with pytest.raises(SceneError, match="ChainSetSurfaceMaterial speaks of a material"):
            on_the_ground(made, call("ChainSetSurfaceMaterial", chain=5, materialIndex=3))


STRONG = {"constraintHertz": 60.0, "constraintDampingRatio": 2.0, "bodyA": 1, "bodyB": 7}
LEANING = {"q": (math.cos(0.5), math.sin(0.5))}
UPRIGHT = {"q": (1, 0)}


class TestJoints:
    """The ball stands at (0, 0), as the ground does."""

    @pytest.mark.parametrize(
        ("name", "given", "wanted"),
        [
            ("Revolute", {"enableLimit": 1, "lowerAngle": -1, "upperAngle": 1, "enableMotor": 1, "motorSpeed": 2,
                          "maxMotorTorque": 3.4e38},
             {"type": "revolute", "lower": -math.degrees(1), "motor_speed": math.degrees(2), "max_torque": 1e15}),
            ("Revolute", {"localFrameB": LEANING, "enableSpring": 1, "hertz": 2, "dampingRatio": 0.5, "targetAngle": 1},
             {"hertz": 2, "rest": math.degrees(0.5)}),
            ("Prismatic", {"localFrameA": LEANING, "localFrameB": LEANING, "enableLimit": 1, "lowerTranslation": -1,
                           "upperTranslation": 2},
             {"type": "prismatic", "axis": (math.cos(0.5), math.sin(0.5)), "lower": -1, "upper": 2}),
            ("Wheel", {"enableSpring": 1, "hertz": 4, "dampingRatio": 0.5, "enableMotor": 1, "motorSpeed": 1,
                       "maxMotorTorque": 5},
             {"type": "wheel", "hertz": 4, "max_torque": 5}),
            ("Weld", {"linearHertz": 3, "angularHertz": 5}, {"type": "weld", "hertz": 3, "angular_hertz": 5}),
            ("Distance", {"length": 2, "lowerSpringForce": -3.4e38, "upperSpringForce": 3.4e38}, {"length": 2}),
            ("Distance", {"length": 2, "enableSpring": 1, "hertz": 3, "enableLimit": 1, "minLength": 1, "maxLength": 4,
                          "lowerSpringForce": -3.4e38, "upperSpringForce": 3.4e38},
             {"type": "distance", "hertz": 3, "min": 1, "max": 4}),
            ("Motor", {"linearHertz": 2, "maxSpringForce": 9, "angularHertz": 3, "maxSpringTorque": 8},
             {"type": "motor", "hertz": 2, "angular_hertz": 3, "max_force": 9, "max_torque": 8}),
            ("Motor", {"maxVelocityForce": 4, "maxVelocityTorque": 2},
             {"type": "friction", "max_force": 4, "max_torque": 2}),
            ("Filter", {}, {"type": "friction", "max_force": 0}),
        ],
    )  # fmt: skip
    def test_kinds(self, name: str, given: dict[str, Any], wanted: dict[str, Any]) -> None:
        made = STRONG | {"localFrameA": UPRIGHT, "localFrameB": UPRIGHT} | given
        found = on_the_ground(body(7, "ball"), disc(2, 7), call(f"Create{name}Joint", **{"made": 3, "def": made}))
        (joint,) = found.scene.joints
        assert {key: getattr(joint, key) for key in wanted} == {
            key: pytest.approx(value) if isinstance(value, (float, tuple)) else value for key, value in wanted.items()
        }
        assert found.remarks == ()

    def test_setters_change_what_was_made(self) -> None:
        made = STRONG | {"localFrameA": UPRIGHT, "localFrameB": UPRIGHT}
        found = on_the_ground(
            body(7, "ball"), disc(2, 7), call("CreateRevoluteJoint", **{"made": 3, "def": made}),
            call("RevoluteJointEnableLimit", joint=3, enableLimit=1),
            call("RevoluteJointSetLimits", joint=3, lower=-0.5, upper=0.5),
            call("JointSetCollideConnected", joint=3, shouldCollide=1),
        )  # fmt: skip
        (joint,) = found.scene.joints
        assert (joint.upper, joint.collide) == (pytest.approx(math.degrees(0.5)), True)

    @pytest.mark.parametrize(
        ("given", "text"),
        [({"constraintHertz": 5.0}, "how stiff the joint itself is, is left out: joints hold here"),
         ({"maxVelocityForce": 1, "linearVelocity": (1, 0)},
          "the velocity that a motor joint drives is left out: it brakes")],
    )  # fmt: skip
    def test_what_a_scene_does_not_have_is_listed(self, given: dict[str, Any], text: str) -> None:
        made = STRONG | {"localFrameA": UPRIGHT, "localFrameB": UPRIGHT} | given
        found = on_the_ground(body(7, "ball"), disc(2, 7), call("CreateMotorJoint", **{"made": 3, "def": made}))
        assert [remark.text for remark in found.remarks] == [text]

    @pytest.mark.parametrize(("name", "kind"), [("Mover", "mover"), ("Pogo", "pogo")])
    def test_unknown_kinds_are_listed(self, name: str, kind: str) -> None:
        made = STRONG | {"localFrameA": UPRIGHT, "localFrameB": UPRIGHT}
        found = on_the_ground(body(7, "ball"), disc(2, 7), call(f"Create{name}Joint", **{"made": 3, "def": made}))
        assert [remark.text for remark in found.remarks] == [f'a joint of the type "{kind}" is left out']


@given(st.integers(4, len(WORLD) - 1), st.binary(min_size=0, max_size=6))
def test_damage_is_a_scene_error_or_another_scene(at: int, noise: bytes) -> None:
    try:
        opened(WORLD[:at] + noise + WORLD[at + len(noise) :])
        opened(WORLD[:at])
    except SceneError:
        pass
