"""The kinds of value a scene field can hold, each with its unit, its limits and its plain error message."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import AfterValidator, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from sandbox.scene.limits import MAX_VERTICES


def describe(value: object) -> str:
    """A value's kind in the words of a scene file."""
    names = {bool: "true or false", str: "text", int: "a number", float: "a number", type(None): "null"}
    if isinstance(value, (list, tuple)):
        return "a list"
    return names.get(type(value), "an object" if isinstance(value, dict) else "something else")


@dataclass(frozen=True)
class Range:
    """Annotates a number: the closed range it must lie in, and its unit."""

    low: float
    high: float
    unit: str = ""

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_after_validator_function(self._check, handler(source))

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {**handler(schema), "minimum": self.low, "maximum": self.high}

    def _check(self, value: float) -> float:
        if self.low <= value <= self.high:
            return value
        unit = f" {self.unit}" if self.unit else ""
        if value < self.low:
            limit = "negative" if self.low == 0 else f"below {self.low:g}{unit}"
        else:
            limit = f"above {self.high:g}{unit}"
        raise PydanticCustomError("limit", f"must not be {limit}")


@dataclass(frozen=True)
class Listed:
    """Annotates a tuple: takes a JSON list or any Python sequence. `form` shows the author how it looks."""

    form: str
    low: int
    high: int

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        inner = handler(source)
        inner["strict"] = False  # type: ignore[index]
        return core_schema.no_info_before_validator_function(self._check, inner)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        found = dict(handler(schema))
        items = found.get("items") or found["prefixItems"][0]
        return {"type": "array", "items": items, "minItems": self.low, "maxItems": self.high}

    def _check(self, value: Any) -> Any:
        value = value.tolist() if hasattr(value, "tolist") else value
        if not isinstance(value, (list, tuple)):
            raise PydanticCustomError("listed", f"must be a list {self.form}, not {describe(value)}")
        if self.low <= len(value) <= self.high:
            return value
        if self.low == self.high:
            text = f"needs {self.low} entries, {self.form}, and has {len(value)}"
        elif len(value) < self.low:
            text = f"needs at least {self.low} entries and has {len(value)}"
        else:
            text = f"has {len(value)} entries; {self.high} is the limit"
        raise PydanticCustomError("listed", text)


_NAME = re.compile(r"[\w.:-]{1,100}")
_COLOR = re.compile(r"#[0-9a-fA-F]{6}")


def _check_name(value: str) -> str:
    if not _NAME.fullmatch(value):
        raise PydanticCustomError("name", "must be 1 to 100 letters, digits or any of _ - . :")
    return value


def _check_color(value: str) -> str:
    if not _COLOR.fullmatch(value):
        raise PydanticCustomError("color", 'must be a colour such as "#3a7bd5"')
    return value


def _check_order(pair: tuple[Any, Any]) -> tuple[Any, Any]:
    if pair[0] > pair[1]:
        raise PydanticCustomError("order", "the first number must not be greater than the second")
    return pair


def _check_rectangle(box: Rectangle) -> Rectangle:
    if not (box[0] < box[2] and box[1] < box[3]):
        raise PydanticCustomError(
            "order", "must be [left, bottom, right, top] with left < right and bottom < top"
        )
    return box


Coordinate = Annotated[float, Range(-1e9, 1e9, "m")]
Size = Annotated[float, Range(1e-6, 1e7, "m")]
Rounding = Annotated[float, Range(0, 1e7, "m")]
Distance = Annotated[float, Range(0, 1e9, "m")]
Velocity = Annotated[float, Range(-1e6, 1e6, "m/s")]
Speed = Annotated[float, Range(0, 1e6, "m/s")]
Acceleration = Annotated[float, Range(-1e6, 1e6, "m/s^2")]
Degrees = Annotated[float, Range(-1e6, 1e6, "degrees")]
Turning = Annotated[float, Range(-1e6, 1e6, "degrees/s")]
Density = Annotated[float, Range(0, 1e9, "kg/m^2")]
Mass = Annotated[float, Range(1e-9, 1e15, "kg")]
Inertia = Annotated[float, Range(1e-12, 1e20, "kg m^2")]
Damping = Annotated[float, Range(0, 1e4, "1/s")]
Hertz = Annotated[float, Range(1, 1e4, "Hz")]
Ratio = Annotated[float, Range(0, 1e3)]
Factor = Annotated[float, Range(-1e3, 1e3)]
Fraction = Annotated[float, Range(0, 1)]
Step = Annotated[int, Range(0, 1_000_000)]
Bits = Annotated[int, Range(0, 0xFFFFFFFF)]

Name = Annotated[str, AfterValidator(_check_name)]
Color = Annotated[str, AfterValidator(_check_color)]

Point = Annotated[tuple[Coordinate, Coordinate], Listed("[x, y]", 2, 2)]
Displacement = Point
Velocity2 = Annotated[tuple[Velocity, Velocity], Listed("[x, y]", 2, 2)]
Acceleration2 = Annotated[tuple[Acceleration, Acceleration], Listed("[x, y]", 2, 2)]
Size2 = Annotated[tuple[Size, Size], Listed("[width, height]", 2, 2)]
Ends = Annotated[tuple[Point, Point], Listed("[[x, y], [x, y]]", 2, 2)]
Outline = Annotated[tuple[Point, ...], Listed("[[x, y], [x, y], [x, y], ...]", 3, MAX_VERTICES)]
Rectangle = Annotated[
    tuple[Coordinate, Coordinate, Coordinate, Coordinate],
    Listed("[left, bottom, right, top]", 4, 4),
    AfterValidator(_check_rectangle),
]
Steps = Annotated[tuple[Step, Step], Listed("[first, last]", 2, 2), AfterValidator(_check_order)]
Speeds = Annotated[tuple[Speed, Speed], Listed("[lowest, highest]", 2, 2), AfterValidator(_check_order)]
Angles = Annotated[tuple[Degrees, Degrees], Listed("[lowest, highest]", 2, 2), AfterValidator(_check_order)]
