"""The OpenGL painter: a whole picture in one instanced draw call of signed-distance quads."""

from __future__ import annotations

from importlib.resources import files
from typing import Any

import moderngl
import numpy as np

from sandbox.render.draw_list import DrawList
from sandbox.render.field_drawing import RegionFill
from sandbox.render.geometry import Mesh
from sandbox.window.instances import INSTANCE, Instances, pack, pack_strokes, triangles_of

TEXTURE_WIDTH = 1024


def shader(name: str) -> str:
    """The source of a shader of this package."""
    return (files("sandbox.window") / "shaders" / name).read_text(encoding="utf-8")


class GlPainter:
    """Draws draw lists into the current framebuffer of a moderngl context (OpenGL 3.3 core)."""

    def __init__(self, context: Any) -> None:
        self.context = context
        self.program = context.program(shader("shapes.vert.glsl"), shader("shapes.frag.glsl"))
        self._corners = context.buffer(np.array([-1, -1, 1, -1, -1, 1, 1, 1], "f4").tobytes())
        self._capacity = 0
        self._mesh: Mesh | None = None
        self._vertices: Any = None
        self._reserve(1024)
        self._region_program = context.program(shader("region.vert.glsl"), shader("region.frag.glsl"))

    def paint(self, picture: DrawList) -> None:
        """Clear the framebuffer and draw the picture; the viewport has to be the size of its camera."""
        self._upload(picture.mesh)
        self.program["screen"].value = picture.camera.size
        self.program["scale"].value = picture.camera.scale
        self.context.clear(*picture.theme.background)
        self.context.enable_only(moderngl.BLEND)
        self.context.blend_func = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA
        self._triangles([_triangles(fill) for fill in picture.region_fills], picture)
        self._instances(pack(picture))
        for layer in picture.marks:
            self._triangles([triangles_of(fills) for fills in layer.fills], picture)
            self._instances(pack_strokes(layer.strokes))

    def _instances(self, instances: Instances) -> None:
        """Quads in one call."""
        if len(instances) == 0:
            return
        self._reserve(len(instances))
        self._buffer.write(instances.tobytes())
        self._vertices.use(0)
        self._quads.render(moderngl.TRIANGLE_STRIP, instances=len(instances))

    def _triangles(self, corners: list[Any], picture: DrawList) -> None:
        """Fills as triangles; few, so that their buffer is made anew for each picture."""
        if not corners:
            return
        buffer = self.context.buffer(np.vstack(corners).astype("f4").tobytes())
        triangles = self.context.vertex_array(self._region_program, [(buffer, "2f 4f", "pixel", "paint")])
        self._region_program["screen"].value = picture.camera.size
        triangles.render(moderngl.TRIANGLES)
        triangles.release()
        buffer.release()

    def _reserve(self, count: int) -> None:
        """Room for `count` instances."""
        if count <= self._capacity:
            return
        self._capacity = max(count, 2 * self._capacity)
        self._buffer = self.context.buffer(reserve=self._capacity * INSTANCE.itemsize, dynamic=True)
        layout = "2f 2f 4f 4f 4f 4f 4f/i"
        parts = [(self._corners, "2f", "corner"), (self._buffer, layout, *(INSTANCE.names or ()))]
        self._quads = self.context.vertex_array(self.program, parts)

    def _upload(self, mesh: Mesh) -> None:
        """Polygon vertices into a texture, once a mesh."""
        if mesh is self._mesh:
            return
        rows = max(-(-len(mesh.points) // TEXTURE_WIDTH), 1)
        texels = np.zeros((rows * TEXTURE_WIDTH, 2), "f4")
        texels[: len(mesh.points)] = mesh.points
        if self._vertices is not None:
            self._vertices.release()
        self._vertices = self.context.texture((TEXTURE_WIDTH, rows), 2, texels.tobytes(), dtype="f4")
        self._vertices.filter = moderngl.NEAREST, moderngl.NEAREST
        self._mesh = mesh


def _triangles(fill: RegionFill) -> Any:
    """A convex polygon as a fan (k, 6): x, y in pixels, sRGB, opacity."""
    points = fill.points
    fan = np.stack([np.broadcast_to(points[0], points[2:].shape), points[1:-1], points[2:]], axis=1).reshape(-1, 2)
    return np.hstack([fan, np.tile([*fill.color, fill.opacity], (len(fan), 1))])
