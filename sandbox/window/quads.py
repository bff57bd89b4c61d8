"""Quads by the thousand on the graphics card: shaders, buffers, calls."""

from __future__ import annotations

from importlib.resources import files
from typing import Any

import moderngl

from sandbox.render.camera import Camera
from sandbox.window.instances import INSTANCE, Instances, Kind

_NAMES = tuple(INSTANCE.names or ())


def shader(name: str, *defined: str) -> str:
    """The source of a shader of this package, with these names defined."""
    version, rest = (files("sandbox.window") / "shaders" / name).read_text(encoding="utf-8").split("\n", 1)
    return "\n".join([version, *(f"#define {each}" for each in defined), rest])


class Quads:
    """Draws quads, a call for each run; a run has a buffer of its own, so that none waits for the one before it."""

    def __init__(self, context: Any, corners: Any, kind: Kind) -> None:
        """`corners` is a buffer with those of a quad; `kind` is what the shader is made to do for these quads."""
        defined = [name for name, wanted in (("TEXTURED", kind.textured), ("OUTLINED", kind.outlined)) if wanted]
        self.program = context.program(*(shader(f"shapes.{stage}.glsl", *defined) for stage in ("vert", "frag")))
        if kind.outlined:
            self.program["vertices"].value = 0
        if kind.textured:
            self.program["textures"].value = 1
        self._context, self._corners, self._kind = context, corners, kind
        self._slots: list[tuple[int, Any, Any]] = []
        self._drawn = 0

    def begin(self, camera: Camera) -> None:
        """A picture begins, as `camera` sees it."""
        self.program["screen"].value = camera.size
        if self._kind.outlined:
            self.program["scale"].value = camera.scale
        self._drawn = 0

    def draw(self, instances: Instances) -> None:
        """Draw them in one call."""
        if len(instances) == 0:
            return
        if self._drawn == len(self._slots):
            self._slots.append(self._slot(256))
        if self._slots[self._drawn][0] < len(instances):
            for part in reversed(self._slots[self._drawn][1:]):
                part.release()
            self._slots[self._drawn] = self._slot(2 * len(instances))
        _, buffer, quads = self._slots[self._drawn]
        buffer.write(instances)
        quads.render(moderngl.TRIANGLE_STRIP, instances=len(instances))
        self._drawn += 1

    def _slot(self, count: int) -> tuple[int, Any, Any]:
        """Room for `count` instances: how many, the buffer, and how it is read."""
        buffer = self._context.buffer(reserve=count * INSTANCE.itemsize, dynamic=True)
        layout, names = (
            ("2f 2f 4f 4f 3u4 4f/i", _NAMES) if self._kind.textured else ("2f 2f 4f 4f 3u4 16x/i", _NAMES[:-1])
        )
        parts = [(self._corners, "2f", "corner"), (buffer, layout, *names)]
        return count, buffer, self._context.vertex_array(self.program, parts)
