"""A scene while it is being read from a foreign file."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sandbox.errors import SceneError
from sandbox.formats.naming import Names
from sandbox.formats.outlines import Words
from sandbox.formats.remarks import Remarks
from sandbox.scene.scene import Scene

_OF_STATIC = ("shapes", "position", "angle", "color")


class Draft:
    """Bodies and joints as a scene file has them, and remarks on what has no words there."""

    def __init__(self, title: str, remarks: Remarks) -> None:
        self.title, self.remarks = title, remarks
        self.bodies: list[Words] = []
        self.joints: list[Words] = []
        self.fields: Words = {}
        self.if_empty = "nothing of this file can be a body: the scene is empty"
        """The remark on a file that brings no bodies."""
        self._names, self._joint_names = Names(), Names()

    def add_body(self, name: str, words: Words, place: str = "") -> str:
        """Bring a body in; the id that it has got. One that should move but weighs nothing is static, with a remark."""
        found = self._names.take(name, f"body-{len(self.bodies) + 1}")
        if "type" not in words and "mass" not in words and not any(map(_has_mass, words["shapes"])):
            self.remarks.note(place or found, "a body that weighs nothing is static")
            words = {"type": "static", **{key: words[key] for key in words if key in _OF_STATIC}}
        self.bodies.append({"id": found, **words})
        return found

    def add_joint(self, name: str, words: Words) -> str:
        """Bring a joint in; the id that it has got."""
        found = self._joint_names.take(name, f"joint-{len(self.joints) + 1}")
        self.joints.append({"id": found, **words})
        return found

    def scene(self, source: str) -> Scene:
        """The finished scene. Raises `SceneError` where a number is past the limits of a scene."""
        data: dict[str, Any] = {"title": self.title, **self.fields, "bodies": self.bodies}
        if self.joints:
            data["joints"] = self.joints
        if not self.bodies:
            self.remarks.note("", self.if_empty)
        try:
            return Scene(**data)
        except SceneError as error:
            first, more = error.problems[0], len(error.problems) - 1
            others = f" (and {more} more like this)" if more else ""
            message = f"the scene made of this file is refused: {first.message}{others}"
            raise SceneError(source, [replace(first, message=message)]) from None


def _has_mass(shape: Words) -> bool:
    is_line = ("segment" in shape or "chain" in shape) and not shape.get("radius")
    return shape.get("density", 1.0) > 0.0 and not shape.get("sensor") and not is_line
