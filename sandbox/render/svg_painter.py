"""Draw list -> SVG: a picture that stays sharp at any size, in the order and colours of the other painters."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any
from xml.etree import ElementTree

import numpy as np

from sandbox.render.contour import shape_contour
from sandbox.render.draw_list import DrawList, ShapeItems
from sandbox.render.label import Label
from sandbox.render.line import Line
from sandbox.render.marks import Marks
from sandbox.render.svg import FONT, number, points_text
from sandbox.render.theme import Color, Theme
from sandbox.world.records import CIRCLE

_ANCHORS = {"left": "start", "middle": "middle", "right": "end"}
_BASELINE = 0.36
"""Parts of its size by which the middle of a line of text lies above its baseline."""


def svg_picture(picture: DrawList, title: str = "") -> str:
    """The whole file; `title` is read out to those who cannot see it."""
    width, height = picture.camera.size
    root = ElementTree.Element(
        "svg", xmlns="http://www.w3.org/2000/svg", viewBox=f"0 0 {width} {height}", width=str(width),
        height=str(height), role="img",
    )  # fmt: skip
    ElementTree.SubElement(root, "title").text = title
    _hatches(root, picture.shapes)
    _add(root, "rect", width=str(width), height=str(height), fill=_hex(picture.theme.background))
    for fill in picture.region_fills:
        _polygon(root, fill.points, fill.color, fill.opacity)
    _lines(root, picture.below)
    _shapes(ElementTree.SubElement(root, "g"), picture)
    _lines(root, picture.above)
    for layer in picture.marks:
        _layer(ElementTree.SubElement(root, "g"), layer)
    _labels(root, picture.labels, picture.theme)
    text = ElementTree.tostring(root, encoding="unicode")
    return text.replace("><", ">\n<") + "\n"


def _shapes(group: Any, picture: DrawList) -> None:
    items = picture.shapes
    for i in range(len(items.index)):
        own = ElementTree.SubElement(group, "g", {"transform": _frame(items, i)})
        _body(own, picture, i)
        if items.mark_opacity[i] > 0.0:
            ends = picture.mesh.mark[items.index[i]] * picture.camera.scale
            width, opacity = 1.5 * max(float(items.line[i]), 0.7), float(items.mark_opacity[i])
            mark = Line((ends[0], 0.0), (ends[1], 0.0), width, tuple(items.mark[i]), opacity)
            _lines(own, [mark])


def _frame(items: ShapeItems, i: int) -> str:
    """From the shape frame, x right and y up, to the picture."""
    (x, y), (a, b) = items.origin[i].tolist(), items.axis[i].tolist()
    return f"matrix({a:.6g} {b:.6g} {b:.6g} {-a:.6g} {number(x)} {number(y)})"


def _body(group: Any, picture: DrawList, i: int) -> None:
    """A shape with its outline within its boundary, in its own frame."""
    items, mesh, scale = picture.shapes, picture.mesh, picture.camera.scale
    row, line = int(items.index[i]), float(items.line[i])
    look = {"fill": _hex(items.fill[i]), "stroke": _hex(items.edge[i]), "stroke-width": number(line)}
    if items.opacity[i] < 1.0:
        look["fill-opacity"] = _share(items.opacity[i])
    if row in mesh.outlines:
        pieces = _rings(mesh.outlines[row].sides * scale)
        shape = _add(group, "path", d=pieces, **look, **{"fill-rule": "evenodd", "stroke-linejoin": "round"})
    elif mesh.kind[row] == CIRCLE and mesh.count[row] == 0:
        radius = float(mesh.radius[row] * scale + items.grow[i]) - 0.5 * line
        shape = _add(group, "circle", r=number(max(radius, 0.1)), **look)
    else:
        radius = float(mesh.radius[row] * scale + items.grow[i])
        ring = shape_contour(mesh.core(row) * scale, radius, 0.5 * line)
        shape = _add(group, "polygon", points=points_text(ring.tolist()), **look)
    if items.hatched[i]:
        stripes = {"fill": f"url(#hatch-{look['stroke'][1:]})", "stroke": "none"}
        ElementTree.SubElement(group, shape.tag, {**shape.attrib, **stripes})


def _rings(sides: Any) -> str:
    """The sides (k, 2, 2) of a concave polygon as one path, ring after ring."""
    steps, end = [], None
    for start, after in sides.tolist():
        begins = end is None or start != end
        steps.append(f"{'M' if begins else 'L'}{number(start[0])} {number(start[1])}")
        end = after
    return "".join(steps).replace("M", " M").strip() + " Z"


def _hatches(root: Any, items: ShapeItems) -> None:
    """A pattern of diagonal stripes for each colour that has some."""
    defs = ElementTree.SubElement(root, "defs")
    for color in sorted({_hex(items.edge[i]) for i in np.flatnonzero(items.hatched).tolist()}):
        pattern = ElementTree.SubElement(
            defs, "pattern", id=f"hatch-{color[1:]}", width="7", height="7", patternUnits="userSpaceOnUse",
            patternTransform="rotate(45)",
        )  # fmt: skip
        _add(pattern, "rect", width="1.4", height="7", fill=color)


def _layer(group: Any, layer: Marks) -> None:
    for fills in layer.fills:
        for points, color, opacity in zip(fills.points, fills.color, fills.opacity.tolist(), strict=True):
            _polygon(group, points, color, opacity)
    strokes = layer.strokes
    rows = zip(
        strokes.start.tolist(), strokes.end.tolist(), strokes.width.tolist(), strokes.color.tolist(),
        strokes.opacity.tolist(), strict=True,
    )  # fmt: skip
    _lines(group, (Line((a[0], a[1]), (b[0], b[1]), width, (c[0], c[1], c[2]), o) for a, b, width, c, o in rows))


def _lines(group: Any, lines: Iterable[Line]) -> None:
    for line in lines:
        look = {"stroke": _hex(line.color), "stroke-width": number(line.width), "stroke-linecap": "round"}
        if line.opacity < 1.0:
            look["stroke-opacity"] = _share(line.opacity)
        (x1, y1), (x2, y2) = line.start, line.end
        _add(group, "line", x1=number(x1), y1=number(y1), x2=number(x2), y2=number(y2), **look)


def _polygon(group: Any, points: Any, color: Any, opacity: float) -> None:
    _add(group, "polygon", points=points_text(points.tolist()), fill=_hex(color), **{"fill-opacity": _share(opacity)})


def _labels(root: Any, labels: Iterable[Label], theme: Theme) -> None:
    group = ElementTree.SubElement(
        root, "g",
        {"font-family": FONT, "paint-order": "stroke", "stroke": _hex(theme.background), "stroke-width": "4",
         "stroke-linejoin": "round"},
    )  # fmt: skip
    for label in labels:
        x, y = label.at
        place = {"x": number(x), "y": number(y + _BASELINE * label.size), "text-anchor": _ANCHORS[label.anchor]}
        _add(group, "text", **place, **{"font-size": number(label.size)}, fill=_hex(label.color)).text = label.text


def _add(group: Any, tag: str, **attributes: str) -> Any:
    return ElementTree.SubElement(group, tag, attributes)


def _hex(color: Color | Any) -> str:
    return "#" + "".join(f"{round(255 * float(np.clip(part, 0.0, 1.0))):02x}" for part in color)


def _share(value: float) -> str:
    return f"{value:.3g}"
