"""Generators: many bodies of one prefab from a few lines. Their bodies are named after the generator's id."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, Tag

from sandbox.scene.base import Model
from sandbox.scene.constraints import Range
from sandbox.scene.limits import MAX_BODIES
from sandbox.scene.quantities import (
    Angles,
    Degrees,
    Displacement,
    Distance,
    Force,
    Name,
    Number,
    Point,
    Rectangle,
    Size,
    Size2,
)
from sandbox.scene.union import TAG, by_key

Count = Annotated[int, Range(1, MAX_BODIES)]


class Generator(Model):
    """What all generators have."""

    id: Name = Field(description='Begins the id of every body made: "wall" gives "wall-1" and so on.')
    params: dict[Name, Number] = Field(
        default={}, description="Parameters of the prefab, by name; they may count the copies with i, row and column."
    )


class Place(Generator):
    """One copy at a place, or `count` of them, each where expressions over `i` say: ID, or ID-1, ID-2, ..."""

    place: Name = Field(description="The prefab to copy.")
    count: Count | None = Field(default=None, description="How many, counted by i from 1; default: one, called ID.")
    at: Point = Field(default=(0.0, 0.0), description="Where its origin comes to lie, m.")
    angle: Degrees = Field(default=0.0, description="How far it is turned, degrees, counter-clockwise.")


class Row(Generator):
    """`count` bodies, each `step` from the one before: ID-1, ID-2, ..."""

    row: Name = Field(description="The prefab to repeat.")
    count: Count = Field(description="How many.")
    at: Point = Field(default=(0.0, 0.0), description="Position of the first body, m.")
    step: Displacement | None = Field(
        default=None,
        description="From one body to the next [x, y], m; default: one prefab width to the right.",
    )


class Stack(Generator):
    """`count` bodies on top of each other: ID-1 is the lowest."""

    stack: Name = Field(description="The prefab to repeat.")
    count: Count = Field(description="How many.")
    at: Point = Field(default=(0.0, 0.0), description="Position of the lowest body, m.")
    spacing: Size | None = Field(default=None, description="From centre to centre, m; default: the prefab's height.")


class Grid(Generator):
    """`columns` by `rows` bodies: ID-ROW-COLUMN, counted from 1 at the lower left."""

    grid: Name = Field(description="The prefab to repeat.")
    columns: Count = Field(description="How many side by side.")
    rows: Count = Field(description="How many above each other.")
    at: Point = Field(default=(0.0, 0.0), description="Position of the lower left body, m.")
    spacing: Size2 | None = Field(
        default=None, description="From centre to centre [x, y], m; default: the prefab's width and height."
    )
    stagger: Distance = Field(default=0.0, description="Shifts every second row to the right, m.")


class Pyramid(Generator):
    """`rows` bodies in the lowest row, one less in each above: ID-ROW-COLUMN, from 1 at the lower left."""

    pyramid: Name = Field(description="The prefab to repeat.")
    rows: Count = Field(description="How many rows; the top one has one body.")
    at: Point = Field(default=(0.0, 0.0), description="The middle of the lowest row, at the height of its bodies, m.")
    spacing: Size2 | None = Field(
        default=None, description="From centre to centre [x, y], m; default: the prefab's width and height."
    )


class Scatter(Generator):
    """`count` bodies at random places of a rectangle, the same ones for the same seed: ID-1, ID-2, ..."""

    scatter: Name = Field(description="The prefab to repeat.")
    count: Count = Field(description="How many.")
    inside: Rectangle = Field(description="[left, bottom, right, top] of the positions, m.")
    seed: Annotated[int, Range(0, 2**63 - 1)] = Field(default=1, description="Another seed, another arrangement.")
    apart: Distance | None = Field(
        default=None,
        description="Least distance between two positions, m; default: so that none can overlap.",
    )
    angle: Angles | None = Field(
        default=None, description="Random angle [lowest, highest], degrees; default: the prefab's."
    )


class Chain(Generator):
    """`count` bodies along a line, each hinged to the next: ID-1, ID-2, ...; the hinges are ID-joint-1, ..."""

    chain: Name = Field(description="The prefab to repeat; its x axis is turned along the chain.")
    count: Count = Field(description="How many.")
    at: Point = Field(default=(0.0, 0.0), description="Where the chain begins: the outer end of the first body, m.")
    step: Displacement | None = Field(
        default=None, description="From one hinge to the next [x, y], m; default: one prefab width to the right."
    )
    pin: Literal["none", "start", "end", "both"] = Field(
        default="none", description="Which ends are hinged to the world; they are ID-joint-0 and the last one."
    )
    collide: bool = Field(default=False, description="true: neighbours collide with each other.")
    break_force: Force | None = Field(default=None, description="Hinges break under more than this, N; default: never.")


GENERATORS: dict[str, type[Generator]] = {
    "place": Place,
    "row": Row,
    "stack": Stack,
    "grid": Grid,
    "pyramid": Pyramid,
    "scatter": Scatter,
    "chain": Chain,
}
"""Every kind of generator by its key."""

AnyGenerator = Annotated[
    Annotated[Place, Tag(TAG + "place")]
    | Annotated[Row, Tag(TAG + "row")]
    | Annotated[Stack, Tag(TAG + "stack")]
    | Annotated[Grid, Tag(TAG + "grid")]
    | Annotated[Pyramid, Tag(TAG + "pyramid")]
    | Annotated[Scatter, Tag(TAG + "scatter")]
    | Annotated[Chain, Tag(TAG + "chain")],
    by_key("generator", GENERATORS),
]
"""Any generator; exactly one of the keys of `GENERATORS` tells which and names the prefab."""


def kind_of(generator: Generator) -> str:
    """The key of a generator: `pyramid` and so on."""
    return next(key for key, kind in GENERATORS.items() if isinstance(generator, kind))


def spacing_field(generator: Generator) -> str:
    """The field that says how far apart the copies stand."""
    return {Row: "step", Chain: "step", Scatter: "apart"}.get(type(generator), "spacing")


def body_count(generator: Generator) -> int:
    """How many bodies a generator makes of a prefab of one; nothing is made for the answer."""
    match generator:
        case Place():
            return generator.count or 1
        case Row() | Stack() | Scatter() | Chain():
            return generator.count
        case Grid():
            return generator.columns * generator.rows
        case Pyramid():
            return generator.rows * (generator.rows + 1) // 2
    raise TypeError(type(generator).__name__)


def body_names(generator: Generator) -> list[str]:
    """The ids of the bodies a generator makes, in order."""
    name = generator.id
    match generator:
        case Grid():
            places = [(r, c) for r in range(generator.rows) for c in range(generator.columns)]
        case Pyramid():
            places = [(r, c) for r in range(generator.rows) for c in range(generator.rows - r)]
        case Place(count=None):
            return [name]
        case _:
            return [f"{name}-{k + 1}" for k in range(body_count(generator))]
    return [f"{name}-{r + 1}-{c + 1}" for r, c in places]
