"""A drawing in SVG as a scene: what is filled is a body, what is only drawn along its edge is a fixed line.

A class, `data-type`, id or label that begins with the word `static`, `kinematic`, `dynamic` or `sensor` says so of an
element and all within it; the class `body` makes one body of all within.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sandbox.formats.draft import Draft
from sandbox.formats.numbers import tidy_point
from sandbox.formats.outlines import Words
from sandbox.formats.reading import MisreadError
from sandbox.formats.source import Options, Source
from sandbox.formats.svg.figures import KINDS, Brush, filled_words, line_words
from sandbox.formats.svg.lengths import length
from sandbox.formats.svg.matrix import Matrix
from sandbox.formats.svg.place import Place, area_of, placed, told, within_view
from sandbox.formats.svg.placing import extent, moved
from sandbox.formats.svg.sheet import Sheet
from sandbox.formats.svg.style import colour_of, is_hidden, is_painted, style_of
from sandbox.formats.xml_tree import Element

PIXELS_PER_METRE = 32.0
_GROUPS = ("g", "a", "switch", "symbol", "svg")
_SILENT = {
    "title", "desc", "metadata", "defs", "style", "linearGradient", "radialGradient", "pattern", "clipPath", "mask",
    "filter", "marker", "symbol", "solidColor", "view",
}  # fmt: skip
_ANIMATIONS = ("animate", "animateTransform", "animateMotion", "set")
MOST_ELEMENTS = 50_000
"""Elements that are drawn, those counted again that `use` repeats."""
_MOST_USES = 30
"""How deep `use` may lead to `use`."""


def is_svg(data: Any) -> bool:
    """Whether parsed XML is a drawing."""
    return isinstance(data, Element) and data.tag == "svg"


def read_svg(source: Source, draft: Draft, options: Options) -> None:
    """Bring all of the drawing into the draft. Raises `MisreadError`."""
    _Reader(source, draft, options).read()


class _Reader:
    def __init__(self, source: Source, draft: Draft, options: Options) -> None:
        self._root, self._draft, self._remarks = source.data, draft, draft.remarks
        self._pixels = options.units_per_metre or PIXELS_PER_METRE
        self._by_id: dict[str, Element] = {}
        sheets: list[str] = []
        self._collect(self._root, sheets)
        self._sheet = Sheet("\n".join(sheets))
        self._count = 0
        self._size = area_of(self._root, (0.0, 0.0))
        self._tolerance = min(options.tolerance, max(self._size) / self._pixels / 400.0)

    def read(self) -> None:
        title = self._root.first("title")
        if title is not None and title.text.strip():
            self._draft.title = " ".join(title.text.split())[:100]
        if self._sheet.passed_over:
            place = f"({self._sheet.passed_over})"
            self._remarks.note(
                place, "rules of a style sheet with other selectors than elements, classes and ids are left out"
            )
        scale = 1.0 / self._pixels
        metres = Matrix(scale, 0.0, 0.0, -scale, 0.0, self._size[1] * scale)
        style = style_of(self._root, self._sheet)
        self._group(self._root, Place(metres, style, self._size, around=(self._root,)))

    def _collect(self, element: Element, sheets: list[str]) -> None:
        if name := element.get("id"):
            self._by_id.setdefault(name, element)
        if element.tag == "style":
            sheets.append(element.text)
        for child in element.children:
            self._collect(child, sheets)

    def _group(self, element: Element, place: Place) -> None:
        if element.tag in ("svg", "symbol"):
            place = within_view(element, place, is_root=element is self._root)
        for child in element.children:
            self._element(child, place)

    def _element(self, element: Element, outside: Place) -> None:
        self._count += 1
        if self._count > MOST_ELEMENTS:
            raise MisreadError((element.line,), f"it draws more than {MOST_ELEMENTS} elements")
        if element.tag in _SILENT or ":" in element.tag:
            return
        style = style_of(element, self._sheet, outside.style, outside.around)
        unseen = element.tag in KINDS and style.get("visibility") in ("hidden", "collapse")
        if unseen or is_hidden(style):
            self._remarks.note(told(element), "what is hidden is left out")
            return
        place = placed(element, replace(outside, style=style, around=(*outside.around, element)))
        if place is None:
            self._remarks.note(told(element), "what has a transform that cannot be read is left out")
            return
        if {style.get("clip-path", "none"), style.get("mask", "none")} != {"none"}:
            self._remarks.note(told(element), "clip paths and masks are left out")
        if element.tag in _GROUPS:
            self._grouped(element, place)
        elif element.tag == "use":
            self._use(element, place)
        elif element.tag in KINDS:
            self._figure(element, place)
        else:
            self._remarks.note(told(element), f"elements of the kind {element.tag[:30]} are left out")

    def _grouped(self, element: Element, place: Place) -> None:
        if place.group is not None or "body" not in element.get("class").split():
            self._group(element, place)
            return
        shapes: list[Words] = []
        self._group(element, replace(place, group=shapes))
        if shapes:
            self._bring(element, place, shapes, colour_of(place.style) if place.style["fill"] != "black" else "")

    def _use(self, element: Element, place: Place) -> None:
        name = (element.get("href") or element.get("xlink:href")).strip()
        meant = self._by_id.get(name[1:]) if name.startswith("#") else None
        if meant is None or place.uses >= _MOST_USES:
            self._remarks.note(told(element), "a use of what is not in the file is left out")
            return
        shift = Matrix(e=length(element.get("x"), place.size[0]), f=length(element.get("y"), place.size[1]))
        inner = replace(place, matrix=place.matrix.after(shift), uses=place.uses + 1)
        if meant.tag in ("symbol", "svg"):
            given = {key: element.get(key) for key in ("width", "height") if element.get(key)}
            meant = replace(meant, attributes=meant.attributes | given)
        if meant.tag == "symbol":
            self._group(meant, replace(inner, style=style_of(meant, self._sheet, place.style, place.around)))
        else:
            self._element(meant, inner)

    def _figure(self, element: Element, place: Place) -> None:
        style, where = place.style, told(element)
        brush = Brush(element, place.matrix, self._tolerance, place.size, self._remarks, where)
        if any(child.tag in _ANIMATIONS for child in element.children):
            self._remarks.note(where, "animations are left out")
        is_filled = is_painted(style, "fill") and element.tag != "line"
        if is_filled:
            shapes = filled_words(brush, style["fill-rule"] == "evenodd")
        elif is_painted(style, "stroke"):
            shapes = line_words(brush, length(style["stroke-width"], max(place.size), 1.0))
        else:
            self._remarks.note(where, "what is neither filled nor drawn is left out")
            return
        if is_filled and self._is_background(shapes, place):
            self._remarks.note(where, "a background that fills the drawing is left out")
            return
        if place.sensor:
            shapes = [words | {"sensor": True} for words in shapes]
        if place.group is not None:
            place.group.extend(shapes)
        elif shapes:
            usual = place if is_filled else replace(place, kind=place.kind or "static")
            self._bring(element, usual, shapes, colour_of(style) if is_filled else "")

    def _is_background(self, shapes: list[Words], place: Place) -> bool:
        """Whether it is a plain box as large as the drawing, of which nothing says what it should be."""
        if len(shapes) != 1 or place.kind or place.sensor or place.group is not None:
            return False
        (words,) = shapes
        is_box = "box" in words or (len(words.get("polygon", ())) == 4 and "holes" not in words)
        left, low, right, high = extent(shapes)
        wide, tall = self._size[0] / self._pixels, self._size[1] / self._pixels
        near = 0.01 * max(wide, tall)
        return is_box and left <= near and low <= near and right >= wide - near and high >= tall - near

    def _bring(self, element: Element, place: Place, shapes: list[Words], colour: str) -> None:
        """A body that stands at the middle of its shapes."""
        left, low, right, high = extent(shapes)
        middle = ((left + right) / 2.0, (low + high) / 2.0)
        words: Words = {} if place.kind in ("", "dynamic") else {"type": place.kind}
        if place.sensor and not place.kind:
            words["type"] = "static"
        words |= {"position": tidy_point(middle), "shapes": [moved(each, middle) for each in shapes]}
        if colour and words.get("type") != "static":
            words["color"] = colour
        self._draft.add_body(element.get("id") or element.get("inkscape:label"), words, told(element))
