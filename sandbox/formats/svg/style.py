"""How elements are painted: presentation attributes, `style`, and style sheets of simple selectors.

Source: SVG 2, chapter 6 "Styling". Selectors are an element, `.class`, `#id`, `*`, or one of these joined; others
are counted by `Sheet.passed_over`.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from PIL import ImageColor

from sandbox.formats.xml_tree import Element

_INHERITED = ("fill", "stroke", "stroke-width", "fill-rule", "visibility", "color", "fill-opacity", "stroke-opacity")
_OWN = ("display", "clip-path", "mask", "opacity", "transform", "transform-origin")
_START = {"fill": "black", "stroke": "none", "stroke-width": "1", "fill-rule": "nonzero", "visibility": "visible"}
_COMMENT = re.compile(r"/\*.*?\*/|<!--|-->", re.DOTALL)
_RULE = re.compile(r"([^{}]+)\{([^{}]*)\}")
_SELECTOR = re.compile(r"([A-Za-z][\w-]*|\*)?((?:[.#][\w-]+)*)")

Style = dict[str, str]


class _Rule(NamedTuple):
    weight: tuple[int, int, int]
    """Ids and classes that it names, whether an element, and its place."""
    tag: str
    classes: frozenset[str]
    id: str
    style: Style


class Sheet:
    """All `<style>` of a file."""

    def __init__(self, text: str) -> None:
        self.passed_over = 0
        self._rules: list[_Rule] = []
        for selectors, body in _RULE.findall(_COMMENT.sub("", text)):
            if selectors.strip().startswith("@"):
                self.passed_over += 1
                continue
            for selector in selectors.split(","):
                self._add(selector.strip(), declarations(body))
        self._rules.sort(key=lambda rule: rule.weight)

    def of(self, element: Element) -> Style:
        """What the rules say of an element, the strongest last."""
        if not self._rules:
            return {}
        classes, name = set(element.get("class").split()), element.get("id")
        found: Style = {}
        for rule in self._rules:
            if rule.tag in ("", "*", element.tag) and rule.classes <= classes and rule.id in ("", name):
                found |= rule.style
        return found

    def _add(self, selector: str, style: Style) -> None:
        match = _SELECTOR.fullmatch(selector)
        if match is None or not selector:
            self.passed_over += 1
            return
        tag, parts = match[1] or "", re.findall(r"([.#])([\w-]+)", match[2])
        classes = frozenset(word for mark, word in parts if mark == ".")
        ids = [word for mark, word in parts if mark == "#"]
        weight = (len(ids), len(classes), int(tag not in ("", "*")))
        self._rules.append(_Rule(weight, tag, classes, ids[0] if ids else "", style))


def declarations(text: str) -> Style:
    """`fill: red; stroke: none` as a dictionary."""
    pairs = (part.partition(":") for part in text.split(";"))
    return {key.strip().lower(): value.replace("!important", "").strip() for key, _, value in pairs if value.strip()}


def style_of(element: Element, sheet: Sheet, parent: Style | None = None) -> Style:
    """The style of an element, with what it inherits."""
    style = dict(_START) if parent is None else {key: parent[key] for key in _INHERITED if key in parent}
    given = {key: element.get(key) for key in (*_INHERITED, *_OWN) if element.get(key)}
    given |= sheet.of(element)
    given |= declarations(element.get("style"))
    return style | {key: value for key, value in given.items() if key in (*_INHERITED, *_OWN) and value != "inherit"}


def is_painted(style: Style, what: str) -> bool:
    """Whether "fill" or "stroke" shows."""
    return style.get(what) not in ("none", "transparent") and not _is_clear(style.get(f"{what}-opacity", ""))


def is_hidden(style: Style) -> bool:
    """Whether nothing of an element shows, nor of what is in it."""
    return style.get("display") == "none" or _is_clear(style.get("opacity", ""))


def _is_clear(opacity: str) -> bool:
    return re.fullmatch(r"\+?0*\.?0*%?", opacity) is not None and "0" in opacity


def colour_of(style: Style) -> str:
    """The colour of the filling as a scene has it, "" if it is no plain one."""
    text = style.get("fill", "")
    if text == "currentColor":
        text = style.get("color", "")
    try:
        red, green, blue = ImageColor.getrgb(text)[:3]
    except ValueError:
        return ""
    return f"#{red:02x}{green:02x}{blue:02x}"
