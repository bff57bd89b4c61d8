"""How actions say where: a point, or a name for something whose place is looked up when they are done."""

from __future__ import annotations

from typing import Annotated

from pydantic import Tag

from sandbox.scene.body_refs import Pattern
from sandbox.scene.constraints import Listed
from sandbox.scene.quantities import Coordinate, Point
from sandbox.scene.union import TAG, by_type

Place = Annotated[
    Annotated[Pattern, Tag(TAG + "text")] | Annotated[Point, Tag(TAG + "list")],
    by_type('a place [x, y], a body id, "@first", "@second" or "@pointer"'),
]
"""A point in the world, or that of a body or of the pointer."""

Along = Pattern
"""Which way x points: an id, "@self" or another "@" name."""

PartOf2 = Annotated[tuple[Coordinate | None, Coordinate | None], Listed("[x, y]", 2, 2)]
