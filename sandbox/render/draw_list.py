"""Frame -> draw list: what is to be drawn, in pixels and in order, as arrays. All painters read it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sandbox.render.body_colors import BodyColors, FrameColors, frame_colors, mix
from sandbox.render.camera import Camera, Floats
from sandbox.render.field_drawing import RegionFill, field_strokes, region_fills
from sandbox.render.frame import Frame
from sandbox.render.geometry import Ints, Mesh
from sandbox.render.grid import grid_lines
from sandbox.render.joint_strokes import joint_strokes
from sandbox.render.label import Label
from sandbox.render.line import Line
from sandbox.render.markers import markers
from sandbox.render.marks import Marks
from sandbox.render.materials.textures import NONE
from sandbox.render.theme import Theme
from sandbox.world.records import DYNAMIC, SEGMENT, STATIC

MIN_HALF_PIXELS, THIN_HALF_PIXELS = 0.6, 1.1
"""Smaller shapes are drawn this large, so that dust stays visible from afar; and thin ones this thick, so that planks,
rods and ropes are more than hairlines.
"""
THIN = 4.0
"""Shapes that are so many times as long as thick are thin."""
SEGMENT_HALF_PIXELS = 1.0
"""Half the least width of a segment, which is drawn in the outline's colour throughout."""
SENSOR_FILL, SENSOR_EDGE = 0.85, 0.3
"""How far the colours of sensors move towards the background."""
HOLLOW_PIXELS, HOLLOW_OPACITY = 1.6, 0.1
"""Width of the outline of hollow shapes, and how much of their fill is left."""
CALM = 0.45
"""How far bodies move towards the background below what overlays draw."""
MARK_FROM_PIXELS, MARK_FULL_PIXELS = 3.0, 8.0
"""Half thickness at which orientation marks begin to show, and at which they show fully."""
COARSEST = 0.5
"""Metres: the unit of length of a texture is half the smallest width of its shape, but no more than this."""
TEXTURE_FROM_PIXELS, TEXTURE_FULL_PIXELS = 4.0, 12.0
"""Pixels of that unit at which textures begin to show, and at which they show fully."""
SHADOW_SOFT, SHADOW_DROP = 9.0, 2.0
"""Pixels in which a shadow fades, and by which it lies lower than what casts it."""
SHADOW_FROM_PIXELS, SHADOW_FULL_PIXELS = 2.5, 8.0
"""Half thickness at which shadows begin to show, and at which they show fully."""


@dataclass(frozen=True)
class ShapeItems:
    """The visible shapes in drawing order, one row each.

    `index` row in the mesh; `origin` (k, 2) pixels of the shape frame's origin; `axis` (k, 2) its x axis on
    screen (cos, sin with y down); `grow` (k,) pixels added to the radius of what is too small to see; `line`
    (k,) outline width in pixels; `fill`, `edge`, `mark` (k, 3) sRGB; `mark_opacity` (k,); `hatched` (k,) 1
    for frozen bodies and for sensors; `opacity` (k,) of what is within the outline; `texture` (k,) number of the
    material's texture, whose unit of length is `unit` (k,) pixels, and which starts at `shift` (k, 2) of a tile, with
    `grain` (k,) 0..1 of its strength, lying across where the shape is `upright` (k,) in its frame; `moving` (k,) for
    what is drawn over what stands still; `shadow` (k,) 0..1.
    """

    index: Ints
    origin: Floats
    axis: Floats
    grow: Floats
    line: Floats
    fill: Floats
    edge: Floats
    mark: Floats
    mark_opacity: Floats
    hatched: Floats
    opacity: Floats
    texture: Ints
    unit: Floats
    shift: Floats
    grain: Floats
    upright: NDArray[np.bool_]
    moving: NDArray[np.bool_]
    shadow: Floats


@dataclass(frozen=True)
class DrawList:
    """One picture: region fills, strokes below, shapes, strokes above, then the layers of overlays (`marks`).

    `camera.scale` turns the mesh into pixels.
    """

    camera: Camera
    theme: Theme
    mesh: Mesh
    below: Sequence[Line]
    shapes: ShapeItems
    above: Sequence[Line]
    region_fills: Sequence[RegionFill] = ()
    marks: Sequence[Marks] = ()

    @property
    def hollow(self) -> bool:
        """Whether little more than the outlines of shapes is seen."""
        return any(layer.hollow for layer in self.marks)

    @property
    def labels(self) -> list[Label]:
        """All words on the picture, which lie over everything else."""
        return [label for layer in self.marks for label in layer.labels]


def build_draw_list(
    frame: Frame,
    camera: Camera,
    body_colors: BodyColors,
    above: Sequence[Line] = (),
    marks: Sequence[Marks] = (),
    depth: bool = True,
) -> DrawList:
    """The draw list of a frame seen through a camera.

    `above` are strokes of tools, such as the drag line; `marks` what `draw_overlays` gives; `depth`: bodies that move
    cast a soft shadow on what is behind them.
    """
    theme, body_colors = body_colors.theme, body_colors.for_frame(frame)
    colors = _tinted(frame_colors(frame, body_colors), theme, marks)
    shapes = _shapes(frame, camera, body_colors, colors, marks)
    if not depth:
        shapes = replace(shapes, shadow=np.zeros(len(shapes.index)))
    marks = (markers(frame, camera, colors.fill), *marks)
    strokes = [*joint_strokes(frame.joints, camera, theme), *above]
    below = [*grid_strokes(camera, theme), *field_strokes(frame.fields, camera, theme)]
    fills = region_fills(frame.fields, camera, theme)
    return DrawList(camera, theme, frame.mesh, below, shapes, strokes, fills, marks)


def grid_strokes(camera: Camera, theme: Theme) -> list[Line]:
    """The metre grid as strokes one pixel wide, on pixel centres so that they are crisp."""
    width, height = camera.size
    colors = (theme.grid_minor, theme.grid_major, theme.grid_axis)
    lines = []
    for line in grid_lines(camera):
        at = np.floor(line.pixel) + 0.5
        start, end = ((at, -1.0), (at, height + 1.0)) if line.vertical else ((-1.0, at), (width + 1.0, at))
        lines.append(Line(start, end, 1.0, colors[line.rank]))
    return lines


def stroke_sizes(mesh: Mesh, scale: float) -> tuple[Floats, Floats]:
    """`grow` and `line` of every shape in the mesh (m,) at `scale` pixels a metre; see `ShapeItems`."""
    half = mesh.thickness * scale
    segment = mesh.kind == SEGMENT
    least = np.where(mesh.reach > THIN * mesh.thickness, THIN_HALF_PIXELS, MIN_HALF_PIXELS)
    grow = np.maximum(np.where(segment, SEGMENT_HALF_PIXELS, least) - half, 0.0)
    return grow, np.where(segment, half + grow, np.clip(0.16 * half, 0.0, 1.4))


def hollow_lines(mesh: Mesh, scale: float) -> Floats:
    """The outline width of every shape in the mesh (m,) where only outlines are drawn."""
    return np.minimum(HOLLOW_PIXELS, mesh.thickness * scale + stroke_sizes(mesh, scale)[0])


def _shapes(
    frame: Frame, camera: Camera, body_colors: BodyColors, colors: FrameColors, marks: Sequence[Marks]
) -> ShapeItems:
    mesh = frame.mesh
    hollow, tinted = any(layer.hollow for layer in marks), any(layer.tints for layer in marks)
    flat = hollow or any(layer.calm for layer in marks)
    world, axis = frame.shape_poses()
    origin = camera.to_screen(world)
    index = _visible(origin, mesh.reach * camera.scale, camera)
    grain = _ramp(np.minimum(mesh.thickness, COARSEST) * camera.scale, TEXTURE_FROM_PIXELS, TEXTURE_FULL_PIXELS)
    texture = np.where(grain > 0.0, body_colors.texture[mesh.body], NONE)
    index = _in_order(frame, index, texture[index] != NONE)
    body = mesh.body[index]
    sensor = mesh.sensor[index]
    half = mesh.thickness[index] * camera.scale
    grow, line = stroke_sizes(mesh, camera.scale)
    if hollow:
        line = hollow_lines(mesh, camera.scale)
    moving = frame.type[body] != STATIC
    unit = np.minimum(mesh.thickness[index], COARSEST) * camera.scale
    plain = sensor | frame.frozen[body] | (mesh.kind[index] == SEGMENT) | hollow | tinted
    own_opacity = body_colors.opacity[body]
    return ShapeItems(
        index=index,
        origin=origin.take(index, axis=0),
        axis=axis.take(index, axis=0) * (1.0, -1.0),
        grow=grow[index],
        line=line[index],
        fill=_faded(_fills(colors, body, mesh.kind[index] == SEGMENT), sensor, body_colors.theme, SENSOR_FILL),
        edge=_faded(colors.edge.take(body, axis=0), sensor, body_colors.theme, SENSOR_EDGE),
        mark=(colors.edge if hollow else colors.mark).take(body, axis=0),
        mark_opacity=np.where(sensor, 0.0, _mark_opacity(half, frame.type[body])),
        hatched=np.where(sensor, 1.0, colors.hatched[body]),
        opacity=np.where(hollow & ~sensor, HOLLOW_OPACITY, np.where(plain, 1.0, own_opacity)),
        texture=np.where(plain, NONE, texture[index]),
        unit=unit,
        shift=np.column_stack([body * 0.6180339887, body * 0.7548776662]) % 1.0,
        grain=grain[index],
        upright=mesh.half[index, 1] > mesh.half[index, 0],
        moving=moving & ~sensor,
        shadow=np.where(moving & ~sensor & (not flat), _ramp(half, SHADOW_FROM_PIXELS, SHADOW_FULL_PIXELS), 0.0),
    )


def _tinted(colors: FrameColors, theme: Theme, marks: Sequence[Marks]) -> FrameColors:
    """The colours of the bodies, faded and with those that overlays lay over them."""
    if any(layer.calm for layer in marks):
        fill, edge, mark = (mix(own, theme.background, CALM) for own in (colors.fill, colors.edge, colors.mark))
        colors = replace(colors, fill=fill, edge=edge, mark=mark)
    for tint in (tint for layer in marks for tint in layer.tints):
        share = tint.amount[:, None]
        fill = colors.fill * (1.0 - share) + tint.color * share
        edge = colors.edge * (1.0 - share) + mix(tint.color, theme.light, theme.outline) * share
        colors = replace(colors, fill=fill, edge=edge, mark=mix(fill, theme.ink, 0.55))
    return colors


def _fills(colors: FrameColors, body: Ints, segment: NDArray[np.bool_]) -> Floats:
    fill = colors.fill.take(body, axis=0)
    fill[segment] = colors.edge[body[segment]]
    return fill


def _faded(colors: Floats, sensor: NDArray[np.bool_], theme: Theme, amount: float) -> Floats:
    """Sensors are hardly more than their stripes: one sees what they are, and what is in them."""
    colors[sensor] = mix(colors[sensor], theme.background, amount)
    return colors


def _visible(origin: Floats, reach: Floats, camera: Camera) -> Ints:
    outside = np.maximum(np.abs(origin - np.asarray(camera.size) / 2) - np.asarray(camera.size) / 2, 0.0)
    return np.flatnonzero(np.hypot(outside[:, 0], outside[:, 1]) <= reach + 2.0)


def _in_order(frame: Frame, index: Ints, textured: NDArray[np.bool_]) -> Ints:
    """Sensors first, then static bodies, so that what moves is never hidden; of each of them what has a texture last,
    which OpenGL draws in a call of its own.
    """
    rank = np.where(frame.type[frame.mesh.body[index]] == STATIC, 1, 3) + textured
    rank[frame.mesh.sensor[index]] = 0
    return index[np.argsort(rank, kind="stable")]


def _mark_opacity(half: Floats, types: Ints) -> Floats:
    return np.where(types == DYNAMIC, _ramp(half, MARK_FROM_PIXELS, MARK_FULL_PIXELS), 0.0)


def _ramp(values: Floats, start: float, full: float) -> Floats:
    """0 up to `start`, 1 from `full` on."""
    ramp: Floats = np.clip((values - start) / (full - start), 0.0, 1.0)
    return ramp
