"""From a scene to a file of another program."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from sandbox.arguments import check_kind
from sandbox.errors import ArgumentError
from sandbox.formats.export.planck import planck_text
from sandbox.formats.export.pymunk_script import pymunk_text
from sandbox.formats.remarks import Remark, Remarks
from sandbox.scene.scene import Scene


@dataclass(frozen=True)
class Exported:
    """The `text` of a file, and `remarks`: what it does not carry over, with ids of the scene as places."""

    text: str
    remarks: tuple[Remark, ...]


@dataclass(frozen=True)
class Target:
    """A format that can be written: its `name`, what its files end in, and what makes the text."""

    name: str
    ending: str
    write: Callable[[Scene, Remarks], str]


TARGETS = (Target("planck", ".json", planck_text), Target("pymunk", ".py", pymunk_text))
"""Every format that can be written."""


def export_scene(scene: Scene, format: str) -> Exported:
    """The scene as the text of a file in `format`, one of the names of `TARGETS`. Raises `ArgumentError`."""
    check_kind("export_scene", "a Scene; load_scene reads one from a file", scene, Scene)
    check_kind("export_scene", "the name of a format", format, str)
    target = next((each for each in TARGETS if each.name == format), None)
    if target is None:
        known = ", ".join(each.name for each in TARGETS)
        raise ArgumentError(f"export_scene(format={format!r}): known formats are {known}")
    remarks = Remarks()
    return Exported(target.write(scene, remarks), tuple(remarks))
