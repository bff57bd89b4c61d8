"""Where a copy of a prefab stands, and what that makes of the places and directions in it.

What is no place because its author made a mistake is passed on as it is: the models tell it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sandbox.geometry.rotation import cos_sin_degrees
from sandbox.scene.plain import is_number

Entry = dict[str, Any]
_POINTS = ("anchor", "target")
_LISTS = ("anchors", "wheels")
_VECTORS = ("axis", "offset")
_UP = (0.0, 1.0)


@dataclass(frozen=True)
class Frame:
    """A place (m) and an angle (degrees) in the frame around it."""

    x: float = 0.0
    y: float = 0.0
    degrees: float = 0.0

    def within(self, outer: Frame) -> Frame:
        """This frame, given in `outer`, as `outer` is given."""
        x, y = outer.point((self.x, self.y))
        return Frame(x, y, self.degrees + outer.degrees)

    def vector(self, value: Any) -> Any:
        """A direction [x, y] of this frame in the outer one."""
        if not _is_pair(value):
            return value
        cos, sin = cos_sin_degrees(self.degrees)
        x, y = value
        return [cos * x - sin * y + 0.0, sin * x + cos * y + 0.0]

    def point(self, value: Any) -> Any:
        """A point [x, y] of this frame in the outer one."""
        turned = self.vector(value)
        return [self.x + turned[0], self.y + turned[1]] if _is_pair(turned) else turned

    def points(self, value: Any) -> Any:
        """A list of points."""
        return [self.point(entry) for entry in value] if isinstance(value, (list, tuple)) else value

    def vectors(self, value: Any) -> Any:
        """A list of directions."""
        return [self.vector(entry) for entry in value] if isinstance(value, (list, tuple)) else value


HERE = Frame()
"""The frame of the scene itself."""


def placed_body(body: Mapping[str, Any], frame: Frame) -> Entry:
    """An entry of `bodies` of a prefab, in the frame around the prefab."""
    placed = {**body, "position": frame.point(body.get("position", (0.0, 0.0)))}
    angle = body.get("angle", 0.0)
    if frame.degrees and is_number(angle):
        placed["angle"] = angle + frame.degrees
    if "velocity" in body:
        placed["velocity"] = frame.vector(body["velocity"])
    path = body.get("path")
    if isinstance(path, dict) and "to" in path:
        placed["path"] = {**path, "to": frame.vectors(path["to"])}
    return placed


def placed_joint(joint: Mapping[str, Any], frame: Frame) -> Entry:
    """An entry of `joints` of a prefab, in the frame around the prefab."""
    placed = dict(joint)
    if frame.degrees and joint.get("type") == "wheel":
        placed.setdefault("axis", _UP)
    placed |= {key: frame.point(placed[key]) for key in _POINTS if key in placed}
    placed |= {key: frame.points(placed[key]) for key in _LISTS if key in placed}
    return placed | {key: frame.vector(placed[key]) for key in _VECTORS if key in placed}


def _is_pair(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and len(value) == 2 and all(is_number(entry) for entry in value)
