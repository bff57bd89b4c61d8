"""The head of a recording, and of the snapshot behind it: version, and how the world is set up.

The snapshot is an image of Box2D's memory; only its beginning is read (`b2SerWorldConfig` of `src/world_snapshot.c`).
Bodies in it are refused: where their values stand depends on how Box2D was compiled.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sandbox.formats.b2rec.cursor import Cursor
from sandbox.formats.b2rec.layouts import fields_of
from sandbox.formats.reading import MisreadError

MAGIC = b"B2RC"
_VERSION = (3, 4)
_SNAPSHOT = (0x32534E42, 4)
_HEADER = fields_of(
    "magic:U32 major:U16 minor:U16 reserved2:U32 lengthScale:F32 reserved3:U8 pointerWidth:U8 bigEndian:U8 "
    "validation:U8 reserved1:U32 snapshotSize:U64"
)
_CONFIG = fields_of(
    "magic:U32 version:U32 layoutHash:U32 flags:U32 gravity:VEC2 hitEventThreshold:F32 restitutionThreshold:F32 "
    "maxLinearSpeed:F32 contactSpeed:F32 contactHertz:F32 contactDampingRatio:F32 contactRecycleDistance:F32 "
    "stepIndex:U64 splitIslandId:I32 inv_h:F32 inv_dt:F32 endEventArrayIndex:I32 "
    "staticShapes:I32 dynamicShapes:I32 staticBodies:I32 dynamicBodies:I32 contacts:I32 settings:U8 "
    "nextBody:I32 freeBodies:I32"
)
_DOUBLE = 2
_SLEEP, _WARM, _SPECULATIVE = 1, 2, 16


@dataclass(frozen=True)
class Head:
    """Settings of the world, by their names in Box2D; the byte at which the calls begin; how long a metre is."""

    settings: dict[str, Any]
    calls: int
    double: bool
    length_scale: float


def read_head(data: bytes) -> Head:
    """The head of a recording. Raises `MisreadError` for other versions, and for a world that has bodies already."""
    cursor = Cursor(data, 0, len(data))
    version = cursor.structure(fields_of("magic:U32 major:U16 minor:U16"))
    _check_version((version["major"], version["minor"]))
    cursor.at = 0
    header = cursor.structure(_HEADER)
    if header["bigEndian"]:
        raise MisreadError((), "this recording was made on a big-endian machine, which cannot be read")
    calls = cursor.at + header["snapshotSize"]
    if calls > len(data):
        raise cursor.fault(f"a snapshot of {header['snapshotSize']} bytes should follow, and the file ends before")
    cursor.end = calls
    config = cursor.structure(_CONFIG)
    if (config["magic"], config["version"]) != _SNAPSHOT:
        raise MisreadError((), "the snapshot in this recording is of another version of Box2D")
    if config["nextBody"] != config["freeBodies"]:
        hint = "call b2World_StartRecording right after b2CreateWorld, before bodies are made"
        raise MisreadError((), "this recording begins with bodies in the world: of those it holds only an image of "
                               "Box2D's memory, which depends on how that was compiled", hint)  # fmt: skip
    flags = config["settings"]
    config |= {"sleeping": bool(flags & _SLEEP), "warmStarting": bool(flags & _WARM)}
    config["speculative"] = bool(flags & _SPECULATIVE)
    return Head(config, calls, bool(config["flags"] & _DOUBLE), header["lengthScale"])


def _check_version(version: tuple[int, int]) -> None:
    if version != _VERSION:
        known, found = (".".join(map(str, each)) for each in (_VERSION, version))
        raise MisreadError((), f"this recording is of version {found}; version {known} can be read")
