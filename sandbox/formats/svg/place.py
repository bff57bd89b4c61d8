"""What holds where an element of SVG stands: its map, its style, and what kind of body it should be."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from sandbox.formats.numbers import Vec
from sandbox.formats.outlines import Words
from sandbox.formats.svg.lengths import length, numbers
from sandbox.formats.svg.matrix import Matrix, fitted, parse_transform
from sandbox.formats.svg.sheet import Style
from sandbox.formats.xml_tree import Element

_ORIGIN = re.compile(r"\s*([+-]?\d*\.?\d+)(?:px)?[\s,]+([+-]?\d*\.?\d+)(?:px)?\s*")
_WORDS = ("static", "kinematic", "dynamic", "sensor")


@dataclass(frozen=True)
class Place:
    """`matrix` leads to metres, `size` is what 100 % are (pixels), `group` where shapes go that are of one body."""

    matrix: Matrix
    style: Style
    size: Vec
    kind: str = ""
    sensor: bool = False
    group: list[Words] | None = None
    uses: int = 0
    around: tuple[Element, ...] = ()
    """The elements that it stands in, the outermost first."""


def area_of(element: Element, whole: Vec) -> Vec:
    """Width and height of a view in pixels: as given, else those of the viewBox."""
    box = numbers(element.get("viewBox"))
    usual = (box[2], box[3]) if len(box) == 4 else (whole if min(whole) > 0.0 else (300.0, 150.0))
    width = length(element.get("width"), whole[0], usual[0])
    height = length(element.get("height"), whole[1], usual[1])
    return (width, height) if min(width, height) > 0.0 else usual


def within_view(element: Element, place: Place, is_root: bool) -> Place:
    """The place within an `svg` or `symbol`, which may reach beyond it."""
    size = area_of(element, place.size)
    box = numbers(element.get("viewBox"))
    inner = Matrix()
    if not is_root:
        inner = Matrix(e=length(element.get("x"), place.size[0]), f=length(element.get("y"), place.size[1]))
    if len(box) == 4 and min(box[2:]) > 0.0:
        way = element.get("preserveAspectRatio").strip().removeprefix("defer").strip()
        inner = inner.after(fitted((box[0], box[1], box[2], box[3]), size, way))
        size = (box[2], box[3])
    return replace(place, matrix=place.matrix.after(inner), size=size)


def placed(element: Element, place: Place) -> Place | None:
    """With the element's own transform and words; None where its transform cannot be read."""
    names = [*element.get("class").split(), *(element.get(key) for key in ("data-type", "id", "inkscape:label"))]
    said = [word for word in (re.split(r"[\s_.-]+", name.lower())[0] for name in names) if word in _WORDS]
    kind = next((word for word in said if word != "sensor"), place.kind)
    matrix = _transform(place.style)
    if matrix is None:
        return None
    inner = place.matrix.after(matrix)
    return replace(place, matrix=inner, kind=kind, sensor=place.sensor or "sensor" in said)


def _transform(style: Style) -> Matrix | None:
    """The map of an element, about its origin; None where one of them cannot be read."""
    text = style.get("transform", "none")
    if text == "none":
        return Matrix()
    matrix, origin = parse_transform(text), _ORIGIN.fullmatch(style.get("transform-origin", "0 0"))
    if matrix is None or origin is None:
        return None
    x, y = float(origin[1]), float(origin[2])
    return Matrix(e=x, f=y).after(matrix).after(Matrix(e=-x, f=-y))


def told(element: Element) -> str:
    """Where an element stands, as remarks tell it."""
    name = f' id="{element.get("id")[:40]}"' if element.get("id") else ""
    return f"line {element.line} <{element.tag}{name}>"
