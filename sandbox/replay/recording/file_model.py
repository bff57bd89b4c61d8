"""The members of a recording's file, as models that check them."""

from __future__ import annotations

import re
from functools import partial
from pathlib import PureWindowsPath
from typing import Annotated, Any

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from sandbox.replay.recording.limits import MAX_COMMANDS, MAX_STEPS
from sandbox.scene.base import Model
from sandbox.scene.constraints import Listed, Range
from sandbox.scene.quantities import Hertz

_FINGERPRINT = re.compile(r"[0-9a-f]{4}( [0-9a-f]{4}){3}")
_WAY = re.compile(r"(?!/)(?!.*//)[^\\]{1,1000}\.json")
_ID = re.compile(r"[\w.:-]{1,200}")  # a name of a scene, and the numbers that generators put behind it


def _check_fingerprint(value: str) -> str:
    if not _FINGERPRINT.fullmatch(value):
        raise PydanticCustomError("fingerprint", 'must be four times four hex digits: "1a2b 3c4d 5e6f 7081"')
    return value


def is_way(value: str) -> bool:
    """Whether a recording may name its scene's file so: the same file on every system, below or beside its folder."""
    return bool(_WAY.fullmatch(value)) and value.isprintable() and not PureWindowsPath(value).drive


def _check_path(value: str) -> str:
    if not is_way(value):
        raise PydanticCustomError("path", "must be the way to a .json file from here, with / between folders")
    return value


def _check_id(value: str) -> str:
    if not _ID.fullmatch(value):
        raise PydanticCustomError("id", "must be 1 to 200 letters, digits or any of _ - . :")
    return value


def _check_printable(value: str) -> str:
    if not value.isprintable():
        raise PydanticCustomError("printable", "must be one line that can be printed")
    return value


def _check_hex(digits: int, value: str) -> str:
    if not re.fullmatch(f"[0-9a-f]{{{digits}}}", value):
        raise PydanticCustomError("hex", f"must be {digits} hex digits")
    return value


Fingerprint = Annotated[str, AfterValidator(_check_fingerprint)]
RelativePath = Annotated[str, AfterValidator(_check_path)]
Hex4 = Annotated[str, AfterValidator(partial(_check_hex, 4))]
Hex16 = Annotated[str, AfterValidator(partial(_check_hex, 16))]
Id = Annotated[str, AfterValidator(_check_id)]
Words = Annotated[str, Field(max_length=200), AfterValidator(_check_printable)]
PoseRow = Annotated[tuple[float, float, float], Listed("[x, y, angle]", 3, 3)]


class SceneEntry(Model):
    """Which scene: by `path` from the recording's folder, with the values that were `set` in it, or by `content`.

    The hashes are what it came down to.
    """

    path: RelativePath | None = None
    content: dict[str, Any] | None = None
    set: dict[str, Any] = Field(default={})
    hash: Hex16
    world: Hex4
    bodies: dict[Id, Hex4]
    joints: dict[Id, Hex4] = Field(default={})


class CheckpointEntry(Model):
    """Figures of one step."""

    step: Annotated[int, Range(1, MAX_STEPS)]
    energy: float
    contacts: Annotated[int, Range(0, 1e9)]
    awake: Annotated[int, Range(0, 1e9)]
    deepest: float


class FileModel(Model):
    """The whole file."""

    format: int
    sandbox: Words
    arithmetic: Annotated[int, Range(1, 1e6)]
    environment: Words = ""
    scene: SceneEntry
    steps: Annotated[int, Range(1, MAX_STEPS)]
    step_rate: Hertz
    commands: Annotated[tuple[Any, ...], Listed("of commands", 0, MAX_COMMANDS)] = ()
    checkpoints: Annotated[tuple[CheckpointEntry, ...], Listed("of checkpoints", 0, MAX_STEPS)]
    digests: Annotated[tuple[Fingerprint, ...], Listed("of fingerprints", 1, MAX_STEPS)]
    final: dict[Id, PoseRow]
    digest: Hex16
