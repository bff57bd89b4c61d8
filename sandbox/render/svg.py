"""A thin layer over `xml.etree` for pictures made of lines, shapes and words: pixels, y down."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from xml.etree import ElementTree

from sandbox._atomic_write import write_text

Pixel = tuple[float, float]

FONT = "ui-sans-serif, system-ui, 'Segoe UI', Helvetica, Arial, sans-serif"


def number(value: float) -> str:
    """A coordinate in hundredths of a pixel, as short as it can be written."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def points_text(points: Iterable[Pixel]) -> str:
    """Points as an SVG attribute has them."""
    return " ".join(f"{number(x)},{number(y)}" for x, y in points)


class Svg:
    """One picture of `width` x `height` pixels; `title` is read out to those who cannot see it.

    Looks come from CSS classes (`kind`), so that one style sheet can serve light and dark pages.
    """

    def __init__(self, width: float, height: float, title: str, style: str) -> None:
        self.size = width, height
        self._root = ElementTree.Element(
            "svg", xmlns="http://www.w3.org/2000/svg", viewBox=f"0 0 {number(width)} {number(height)}",
            width=number(width), height=number(height), role="img",
        )  # fmt: skip
        self._into = self._root
        ElementTree.SubElement(self._root, "title").text = title
        ElementTree.SubElement(self._root, "style").text = "\n" + style + "\n"

    def window(self, x: float, y: float, width: float, height: float) -> None:
        """What is drawn from now on is cut at the edges of this rectangle, until `close_window`."""
        place = {"x": number(x), "y": number(y), "width": number(width), "height": number(height)}
        view = " ".join(place.values())
        self._into = ElementTree.SubElement(self._root, "svg", {**place, "viewBox": view})

    def close_window(self) -> None:
        """Draw on the whole picture again."""
        self._into = self._root

    def rectangle(self, x: float, y: float, width: float, height: float, kind: str, round_by: float = 0.0) -> None:
        """A rectangle by its upper left corner."""
        corner = {"rx": number(round_by)} if round_by else {}
        place = {"x": number(x), "y": number(y), "width": number(width), "height": number(height)}
        self._add("rect", kind, **place, **corner)

    def line(self, start: Pixel, end: Pixel, kind: str) -> None:
        """A straight line."""
        (x1, y1), (x2, y2) = start, end
        self._add("line", kind, x1=number(x1), y1=number(y1), x2=number(x2), y2=number(y2))

    def arrow(self, start: Pixel, end: Pixel, kind: str, head: float = 9.0) -> None:
        """A line with a head at its end; a short one gets a smaller head."""
        (x1, y1), (x2, y2) = start, end
        length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
        if length == 0.0:
            return
        ux, uy = (x2 - x1) / length, (y2 - y1) / length
        head = min(head, 0.6 * length)
        neck = x2 - ux * head, y2 - uy * head
        self.line(start, neck, kind)
        side = 0.45 * head
        self.polygon(
            [(neck[0] - uy * side, neck[1] + ux * side), (x2, y2), (neck[0] + uy * side, neck[1] - ux * side)],
            kind + " head",
        )

    def polygon(self, points: Iterable[Pixel], kind: str) -> None:
        """A closed outline through points."""
        self._add("polygon", kind, points=points_text(points))

    def path(self, steps: str, kind: str) -> None:
        """Any outline, in SVG's own path language."""
        self._add("path", kind, d=steps)

    def circle(self, center: Pixel, radius: float, kind: str) -> None:
        """A circle."""
        self._add("circle", kind, cx=number(center[0]), cy=number(center[1]), r=number(radius))

    def text(self, place: Pixel, words: str, kind: str, anchor: str = "start") -> None:
        """Words whose baseline begins, is centred (`middle`) or ends (`end`) at `place`."""
        where = {"x": number(place[0]), "y": number(place[1])}
        self._add("text", kind, **where, **({} if anchor == "start" else {"text-anchor": anchor})).text = words

    def spans(self, place: Pixel, parts: Iterable[tuple[str, str]], kind: str) -> None:
        """One line of (words, class) parts after another; the viewer knows how wide each is."""
        line = self._add("text", kind, x=number(place[0]), y=number(place[1]))
        for words, own in parts:
            ElementTree.SubElement(line, "tspan", {"class": own}).text = words

    def to_text(self) -> str:
        """The whole file."""
        text = ElementTree.tostring(self._root, encoding="unicode")
        # One element a line; inside a text, white space would show.
        return text.replace("><", ">\n<").replace("</tspan>\n<", "</tspan><").replace("\n<tspan", "<tspan") + "\n"

    def save(self, path: Path) -> None:
        """Write the picture. Raises `OSError`."""
        write_text(path, self.to_text())

    def _add(self, tag: str, kind: str, **attributes: str) -> ElementTree.Element:
        return ElementTree.SubElement(self._into, tag, {"class": kind, **attributes})
