"""What a scene promises: each expectation has one time and one condition. Data only; `replay` judges it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, Tag

from sandbox.scene.body_refs import Ids, Pair, is_pattern, matching_ids
from sandbox.scene.expectation import Expectation
from sandbox.scene.quantities import (
    Angles,
    Coordinate,
    Degrees,
    Distance,
    Name,
    Number,
    Point,
    Rectangle,
    Speed,
    Speeds,
)
from sandbox.scene.union import TAG, by_key

__all__ = [
    "CONDITIONS",
    "Above",
    "AnyExpectation",
    "Apart",
    "Asleep",
    "Below",
    "CounterIs",
    "Ended",
    "Expectation",
    "Ids",
    "Inside",
    "Near",
    "Pair",
    "Rests",
    "Senses",
    "Speeding",
    "Stands",
    "Touches",
    "Turned",
    "is_pattern",
    "matching_ids",
]


class Rests(Expectation):
    """The bodies hardly move."""

    rests: Ids = Field(description="Bodies that must be at rest.")
    tolerance: Speed = Field(default=0.05, description="Slower counts as at rest: m/s, and rad/s of turning.")


class Stands(Expectation):
    """The bodies are still where they started."""

    stands: Ids = Field(description="Bodies that must not have moved away.")
    moved: Distance = Field(default=0.05, description="Nearer than this to its start counts as standing, m.")
    turned: Degrees | None = Field(
        default=None, description="If given: turned less than this since the start, degrees."
    )


class Inside(Expectation):
    """The positions lie in a rectangle."""

    inside: Rectangle = Field(description="[left, bottom, right, top], m.")
    of: Ids | None = Field(default=None, description="Which bodies; default: all dynamic ones.")


class Above(Expectation):
    """The positions lie above a height."""

    above: Coordinate = Field(description="y, m.")
    of: Ids | None = Field(default=None, description="Which bodies; default: all dynamic ones.")


class Below(Expectation):
    """The positions lie below a height."""

    below: Coordinate = Field(description="y, m.")
    of: Ids | None = Field(default=None, description="Which bodies; default: all dynamic ones.")


class Touches(Expectation):
    """Two bodies touch (with patterns: some body of the first touches some body of the second)."""

    touches: Pair = Field(description="The two bodies.")


class Apart(Expectation):
    """Two bodies do not touch (with patterns: no body of the first touches any of the second)."""

    apart: Pair = Field(description="The two bodies.")


class Senses(Expectation):
    """A sensor has a body in it (with patterns: some sensor has some body in it)."""

    senses: Pair = Field(description="The body that carries the sensor, and the body in it.")


class Asleep(Expectation):
    """The bodies are asleep."""

    asleep: Ids = Field(description="Bodies that must be asleep.")


class Near(Expectation):
    """The positions lie within a distance of a point."""

    near: Point = Field(description="[x, y], m.")
    of: Ids = Field(description="Which bodies.")
    tolerance: Distance = Field(default=0.05, description="How near, m.")


class Speeding(Expectation):
    """The speeds lie in a range."""

    speed: Speeds = Field(description="[lowest, highest], m/s.")
    of: Ids = Field(description="Which bodies.")


class Turned(Expectation):
    """The angles lie in a range; a full turn counts as 360."""

    angle: Angles = Field(description="[lowest, highest], degrees.")
    of: Ids = Field(description="Which bodies.")


class CounterIs(Expectation):
    """A counter has a value, or lies in a range."""

    counter: Name = Field(description="The name of a counter.")
    equals: Number | None = Field(default=None, description="It has this value.")
    least: Number | None = Field(default=None, description="It is at least this.")
    most: Number | None = Field(default=None, description="It is at most this.")


class Ended(Expectation):
    """The game is won, lost, or still open."""

    outcome: Literal["won", "lost", "open"] = Field(description='"won", "lost", or "open" while it is neither.')


CONDITIONS: dict[str, type[Expectation]] = {
    "rests": Rests,
    "stands": Stands,
    "inside": Inside,
    "above": Above,
    "below": Below,
    "touches": Touches,
    "apart": Apart,
    "senses": Senses,
    "asleep": Asleep,
    "near": Near,
    "speed": Speeding,
    "angle": Turned,
    "counter": CounterIs,
    "outcome": Ended,
}
"""Every kind of expectation by its key."""

AnyExpectation = Annotated[
    Annotated[Rests, Tag(TAG + "rests")]
    | Annotated[Stands, Tag(TAG + "stands")]
    | Annotated[Inside, Tag(TAG + "inside")]
    | Annotated[Above, Tag(TAG + "above")]
    | Annotated[Below, Tag(TAG + "below")]
    | Annotated[Touches, Tag(TAG + "touches")]
    | Annotated[Apart, Tag(TAG + "apart")]
    | Annotated[Senses, Tag(TAG + "senses")]
    | Annotated[Asleep, Tag(TAG + "asleep")]
    | Annotated[Near, Tag(TAG + "near")]
    | Annotated[Speeding, Tag(TAG + "speed")]
    | Annotated[Turned, Tag(TAG + "angle")]
    | Annotated[CounterIs, Tag(TAG + "counter")]
    | Annotated[Ended, Tag(TAG + "outcome")],
    by_key("expectation", CONDITIONS),
]
"""Any expectation; exactly one of the keys of `CONDITIONS` tells which."""
