"""Recordings of Box2D v3, written here by the same tables; damage is told, never a traceback."""

from __future__ import annotations

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
    [(recording(bodies=3), "begins in the middle"), (recording(version=(3, 2)), "version 3.2"),
     (WORLD[:-1], "byte"), (recording(b"\xee\0\0\0"), "unknown kind 0xEE")],
)  # fmt: skip
def test_what_cannot_be_read_is_told(data: bytes, message: str) -> None:
    with pytest.raises(SceneError, match=message):
        opened(data)


@given(st.integers(4, len(WORLD) - 1), st.binary(min_size=0, max_size=6))
def test_damage_is_a_scene_error_or_another_scene(at: int, noise: bytes) -> None:
    try:
        opened(WORLD[:at] + noise + WORLD[at + len(noise) :])
        opened(WORLD[:at])
    except SceneError:
        pass
