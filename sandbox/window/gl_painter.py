"""The OpenGL painter: a whole picture in a few instanced draw calls of signed-distance quads."""

from __future__ import annotations

from typing import Any

import moderngl
import numpy as np

from sandbox.render.camera import Camera
from sandbox.render.draw_list import DrawList
from sandbox.render.field_drawing import RegionFill
from sandbox.render.geometry import Mesh
from sandbox.render.materials.textures import TILE, textures
from sandbox.window.instances import PLAIN, Kind, pack, pack_strokes, triangles_of
from sandbox.window.quads import Quads, shader

TEXTURE_WIDTH = 1024


class GlPainter:
    """Draws draw lists into the current framebuffer of a moderngl context (OpenGL 3.3 core)."""

    def __init__(self, context: Any) -> None:
        self.context = context
        self._corners = context.buffer(np.array([-1, -1, 1, -1, -1, 1, 1, 1], "f4").tobytes())
        self._mesh: Mesh | None = None
        self._vertices: Any = None
        self._quads: dict[Kind, Quads] = {}
        """By what they need of the shader: a program is made when the first of its kind is drawn."""
        self._textures: Any = None
        self._region_program = context.program(shader("region.vert.glsl"), shader("region.frag.glsl"))

    def paint(self, picture: DrawList) -> None:
        """Clear the framebuffer and draw the picture; the viewport has to be the size of its camera."""
        self._upload(picture.mesh)
        for quads in self._quads.values():
            quads.begin(picture.camera)
        self._vertices.use(0)
        if self._textures is not None:
            self._textures.use(1)
        self.context.clear(*picture.theme.background)
        self.context.enable_only(moderngl.BLEND)
        self.context.blend_func = moderngl.SRC_ALPHA, moderngl.ONE_MINUS_SRC_ALPHA
        self._triangles([_triangles(fill) for fill in picture.region_fills], picture)
        for run in pack(picture):
            self._quads_of(run.kind, picture.camera).draw(run.instances)
        for layer in picture.marks:
            self._triangles([triangles_of(fills) for fills in layer.fills], picture)
            self._quads_of(PLAIN, picture.camera).draw(pack_strokes(layer.strokes))

    def _quads_of(self, kind: Kind, camera: Camera) -> Quads:
        if kind.textured and self._textures is None:
            self._textures = _texture_array(self.context)
            self._textures.use(1)
        if kind not in self._quads:
            self._quads[kind] = Quads(self.context, self._corners, kind)
            self._quads[kind].begin(camera)
        return self._quads[kind]

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


def _texture_array(context: Any) -> Any:
    """The textures of materials, with smaller ones for when they are seen from afar."""
    tiles = textures()
    array = context.texture_array((TILE, TILE, len(tiles)), 1, tiles.tobytes(), dtype="f4")
    array.build_mipmaps()
    array.filter = moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR
    array.repeat_x = array.repeat_y = True
    return array


def _triangles(fill: RegionFill) -> Any:
    """A convex polygon as a fan (k, 6): x, y in pixels, sRGB, opacity."""
    points = fill.points
    fan = np.stack([np.broadcast_to(points[0], points[2:].shape), points[1:-1], points[2:]], axis=1).reshape(-1, 2)
    return np.hstack([fan, np.tile([*fill.color, fill.opacity], (len(fan), 1))])
