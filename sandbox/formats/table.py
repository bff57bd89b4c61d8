"""Every format that can be read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from sandbox.formats.b2rec.reader import is_b2rec, read_b2rec
from sandbox.formats.body_editor import is_body_editor, read_body_editor
from sandbox.formats.draft import Draft
from sandbox.formats.physics_editor import is_physics_editor, read_physics_editor
from sandbox.formats.planck import is_planck, read_planck
from sandbox.formats.rube import is_rube, read_rube
from sandbox.formats.source import Options, Source
from sandbox.formats.svg.reader import is_svg, read_svg
from sandbox.formats.tiled.reader import is_tiled, read_tiled


@dataclass(frozen=True)
class Format:
    """A format by its `name`. `matches` tells from parsed data whether a file is of it; `read` fills a draft."""

    name: str
    title: str
    matches: Callable[[Any], bool]
    read: Callable[[Source, Draft, Options], None]


FORMATS = (
    Format("rube", "R.U.B.E. (b2dJson)", is_rube, lambda source, draft, _: read_rube(source.data, draft)),
    Format("planck", "planck.js world", is_planck, lambda source, draft, _: read_planck(source.data, draft)),
    Format("body-editor", "Physics Body Editor", is_body_editor, read_body_editor),
    Format("physics-editor", "PhysicsEditor of CodeAndWeb", is_physics_editor, read_physics_editor),
    Format("tiled", "map of Tiled", is_tiled, read_tiled),
    Format("b2rec", "recording of Box2D v3", is_b2rec, lambda source, draft, _: read_b2rec(source.data, draft)),
    Format("svg", "drawing in SVG", is_svg, read_svg),
)
"""In the order in which they are asked; no file is of two of them."""
