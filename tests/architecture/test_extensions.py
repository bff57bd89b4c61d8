"""What comes in kinds is told apart in many places: a kind, or a field of a surface, that one of them lacks is named
here, before it fails there or is taken for another."""

from __future__ import annotations

import inspect
import re
from collections.abc import Collection
from dataclasses import fields
from pathlib import Path
from typing import Any

import pytest

import sandbox
from sandbox.engine.commands.set_surface import SetSurface
from sandbox.engine.joints.part_layout import slots_of
from sandbox.render import joint_strokes
from sandbox.render.overlays import registry
from sandbox.report import joint_data
from sandbox.scene import snippets
from sandbox.scene.flat import FlatShape
from sandbox.scene.joints import JOINTS
from sandbox.scene.material import Material, Surface
from sandbox.window.panels.inspector import surfaces
from sandbox.world.export import joint_geometry, joint_settings
from sandbox.world.joint_records import JOINT, KINDS, NUMBERS
from sandbox.world.records import SHAPE, SURFACE
from tests.joints.linkages import KINDS as LINKAGES
from tests.joints.test_settings import CHANGES
from tests.naive.joint_rows import slots

ROOT = Path(sandbox.__file__).parents[1]


def with_rows() -> list[str]:
    """The kinds that have a row in the solver, for some spring, limit or motor."""

    def rows(kind: str) -> bool:
        try:
            return len(slots_of(NUMBERS[kind], False, False, False)) > 0  # type: ignore[index]
        except KeyError:
            return False

    return [kind for kind in KINDS if rows(kind)]


def with_naive_rows() -> list[str]:
    table = JOINT.zeros(len(KINDS))
    table.kind = range(len(KINDS))
    return [kind for kind, row in zip(KINDS, table, strict=True) if slots(row)]


def names(numbers: Collection[int]) -> list[str]:
    return [kind for kind in KINDS if NUMBERS[kind] in numbers]


def in_guide() -> list[str]:
    """The kinds that have a line in the table of joints."""
    guide = (ROOT / "scenes" / "README.md").read_text(encoding="utf-8")
    return re.findall(r'^\| `"(\w+)"` \|', guide[guide.index("\n## Joints") :], re.MULTILINE)


JOINT_PLACES: dict[str, Collection[str]] = {
    "scene/joints/any_joint.py, JOINTS": JOINTS,
    "scene/snippets.py, KINDS": snippets.KINDS["joint"],
    "scenes/README.md, the table of joints": in_guide(),
    "_names.py": [kind for kind, model in JOINTS.items() if model.__name__ in sandbox.__all__],
    "engine/joints/part_layout.py, slots_of": with_rows(),
    "world/export/joint_settings.py, PLAIN": joint_settings.PLAIN,
    "world/export/joint_geometry.py, _WRITERS": joint_geometry._WRITERS,
    "render/joint_strokes.py, _DRAW": names(joint_strokes._DRAW),
    "report/joint_data.py, _LOOKS": names(joint_data._LOOKS),
    "tests/naive/joint_rows.py, slots": with_naive_rows(),
    "tests/joints/linkages.py, KINDS": {kind.split()[0] for kind in LINKAGES} | {"gear"},  # a field of `Linkage`
    "tests/joints/test_settings.py, CHANGES": CHANGES,
}


@pytest.mark.parametrize("place", JOINT_PLACES)
def test_every_kind_of_joint_is_known_in(place: str) -> None:
    assert sorted(set(KINDS) - set(JOINT_PLACES[place])) == []


def test_every_joint_of_a_scene_has_a_number() -> None:
    assert sorted(JOINTS) == sorted(KINDS)


def names_of(kind: Any) -> list[str]:
    return [field.name for field in fields(kind)]


SURFACE_PLACES: dict[str, Collection[str]] = {
    "scene/material.py, Material": Material.model_fields,
    "scene/material.py, Surface": Surface.model_fields,
    "scene/flat_body.py, FlatShape": names_of(FlatShape),
    "world/records.py, SHAPE": SHAPE.dtype.names or (),
    "engine/commands/set_surface.py, SetSurface": names_of(SetSurface),
    "engine/views/body.py, set_surface": ["density", *inspect.signature(sandbox.BodyView.set_surface).parameters],
    "window/panels/inspector/surfaces.py, _FIELDS": surfaces._FIELDS,
}


@pytest.mark.parametrize("place", SURFACE_PLACES)
def test_every_field_of_a_surface_is_known_in(place: str) -> None:
    assert sorted(set(SURFACE) - set(SURFACE_PLACES[place])) == []


def test_a_material_has_no_field_that_is_no_column_of_a_surface() -> None:
    assert sorted(set(Material.model_fields) - {"bumper"}) == sorted(SURFACE)


def test_every_file_with_an_overlay_is_in_the_registry() -> None:
    files = Path(registry.__file__).parent.glob("*.py")
    having = {path.stem for path in files if "\nOVERLAY = " in path.read_text(encoding="utf-8")}
    assert having == {module.__name__.rpartition(".")[2] for module in registry._MODULES}
