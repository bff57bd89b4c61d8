"""The kinds of value a scene field can hold, each with its unit and its limits."""

from __future__ import annotations

import re
from typing import Annotated, Any

from pydantic import AfterValidator, Field, JsonValue, ValidationInfo
from pydantic_core import PydanticCustomError

from sandbox.scene.colors import COLOR_PATTERN, color_fault
from sandbox.scene.constraints import Listed, Range
from sandbox.scene.drawn import Drawn
from sandbox.scene.limits import MAX_HOLES, MAX_NAME, MAX_OUTLINE

_LENGTHS: dict[str, JsonValue] = {"minLength": 1, "maxLength": MAX_NAME}
_NAME = re.compile(rf"[\w.:-]{{1,{MAX_NAME}}}")


def is_name(value: str) -> bool:
    """Whether it can be an id, or the name of a prefab or material."""
    return bool(_NAME.fullmatch(value))


def _check_name(value: str) -> str:
    if not is_name(value):
        raise PydanticCustomError("name", f"must be 1 to {MAX_NAME} letters, digits or any of _ - . :")
    return value


def _check_color(value: str) -> str:
    fault = color_fault(value)
    if fault:
        raise PydanticCustomError("color", "{fault}", {"fault": fault})
    return value


def _check_order(pair: tuple[Any, Any]) -> tuple[Any, Any]:
    if pair[0] > pair[1]:
        raise PydanticCustomError("order", "the first number must not be greater than the second")
    return pair


def _check_bounce(restitution: float | None, info: ValidationInfo) -> float | None:
    """What comes back faster than it came is no mistake only where the author says so: `bumper` comes before."""
    if restitution is not None and restitution > 1.0 and not info.data.get("bumper", True):  # not there if it is wrong
        told = f'must not be above 1, or {MAX_BOUNCE:g} beside "bumper": true'
        raise PydanticCustomError("limit", told, {"without": "bumper"})
    return restitution


def _check_rectangle(box: Rectangle) -> Rectangle:
    if not (box[0] < box[2] and box[1] < box[3]):
        raise PydanticCustomError("order", "must be [left, bottom, right, top] with left < right and bottom < top")
    return box


MAX_BOUNCE = 5.0
"""Highest restitution, that of a bumper."""

Coordinate = Annotated[float, Range(-1e9, 1e9, "m")]
Size = Annotated[float, Range(1e-6, 1e7, "m")]
Rounding = Annotated[float, Range(0, 1e7, "m", least=1e-6)]
Local = Annotated[float, Range(-1e7, 1e7, "m")]
Distance = Annotated[float, Range(0, 1e9, "m")]
Velocity = Annotated[float, Range(-1e6, 1e6, "m/s")]
Speed = Annotated[float, Range(0, 1e6, "m/s")]
Acceleration = Annotated[float, Range(-1e6, 1e6, "m/s^2")]
Degrees = Annotated[float, Range(-1e6, 1e6, "degrees")]
Turning = Annotated[float, Range(-1e6, 1e6, "degrees/s")]
Density = Annotated[float, Range(0, 1e9, "kg/m^2", least=1e-6)]
Mass = Annotated[float, Range(1e-9, 1e15, "kg")]
Inertia = Annotated[float, Range(1e-12, 1e20, "kg m^2")]
Damping = Annotated[float, Range(0, 1e4, "1/s")]
Units = Annotated[float, Range(1e-6, 1e6)]
Hertz = Annotated[float, Range(1, 1e4, "Hz")]
Ratio = Annotated[float, Range(0, 1e3)]
Factor = Annotated[float, Range(-1e3, 1e3)]
Bounce = Annotated[float, Range(0, MAX_BOUNCE), AfterValidator(_check_bounce)]
Force = Annotated[float, Range(0, 1e15, "N")]
Torque = Annotated[float, Range(0, 1e15, "N m")]
Frequency = Annotated[float, Range(0, 1e4, "Hz")]
Seconds = Annotated[float, Range(0, 1e6, "s")]
Step = Annotated[int, Range(0, 1_000_000)]
Number = Annotated[float, Range(-1e12, 1e12)]
Bits = Annotated[int, Range(0, 0xFFFFFFFF)]

Name = Annotated[str, AfterValidator(_check_name), Field(json_schema_extra=_LENGTHS)]
Color = Annotated[str, AfterValidator(_check_color), Field(json_schema_extra={"pattern": COLOR_PATTERN})]

Point = Annotated[tuple[Coordinate, Coordinate], Listed("[x, y]", 2, 2)]
Displacement = Point
LocalPoint = Annotated[tuple[Local, Local], Listed("[x, y]", 2, 2)]
Velocity2 = Annotated[tuple[Velocity, Velocity], Listed("[x, y]", 2, 2)]
Acceleration2 = Annotated[tuple[Acceleration, Acceleration], Listed("[x, y]", 2, 2)]
Size2 = Annotated[tuple[Size, Size], Listed("[width, height]", 2, 2)]
Ends = Annotated[tuple[LocalPoint, LocalPoint], Listed("[[x, y], [x, y]]", 2, 2)]
Outline = Annotated[tuple[LocalPoint, ...], Listed("[[x, y], [x, y], [x, y], ...]", 3, MAX_OUTLINE), Drawn()]
ChainPoints = Annotated[tuple[LocalPoint, ...], Listed("[[x, y], [x, y], ...]", 2, MAX_OUTLINE), Drawn(may_close=False)]
Holes = Annotated[tuple[Outline, ...], Listed("of holes [[[x, y], [x, y], [x, y], ...], ...]", 0, MAX_HOLES)]
Rectangle = Annotated[
    tuple[Coordinate, Coordinate, Coordinate, Coordinate],
    Listed("[left, bottom, right, top]", 4, 4),
    AfterValidator(_check_rectangle),
]
Steps = Annotated[tuple[Step, Step], Listed("[first, last]", 2, 2), AfterValidator(_check_order)]
Speeds = Annotated[tuple[Speed, Speed], Listed("[lowest, highest]", 2, 2), AfterValidator(_check_order)]
Angles = Annotated[tuple[Degrees, Degrees], Listed("[lowest, highest]", 2, 2), AfterValidator(_check_order)]
