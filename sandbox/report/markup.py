"""HTML as a tree: text can never become markup."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import TypeAlias
from xml.etree import ElementTree

from sandbox.render.theme import DARK, LIGHT, Theme
from sandbox.report.body_data import hex_of

Node: TypeAlias = ElementTree.Element
_FOLDER = Path(__file__).parent / "page"
PLAYER = ("codec.js", "shapes.js", "joints.js", "viewport.js", "plot.js", "player.js")
"""What a film needs to be played."""


def node(tag: str, kind: str = "", *inside: Node | str, **attributes: str) -> Node:
    """An element of class `kind` with text and elements inside."""
    made = ElementTree.Element(tag, {**({"class": kind} if kind else {}), **attributes})
    for part in inside:
        if not isinstance(part, str):
            made.append(part)
        elif len(made):
            made[-1].tail = (made[-1].tail or "") + part
        else:
            made.text = (made.text or "") + part
    return made


def text_of(tree: Node) -> str:
    """The HTML of an element."""
    return ElementTree.tostring(tree, encoding="unicode", method="html")


def film_script(name: str, film: str) -> Node:
    """A film inside a page, as `packed` makes it, under an id."""
    return node("script", "", film, type="text/plain", id=name)


def whole_page(
    title: str,
    body: list[str],
    kind: str,
    scripts: Sequence[str] = (*PLAYER, "start.js"),
    styles: Sequence[str] = ("page.css",),
    theme: Theme = DARK,
) -> str:
    """A page that needs nothing but itself; `kind` is the class of its body."""
    frame = _resource("frame.html")
    styles = (*styles, "light.css") if theme is LIGHT else styles
    parts = {
        "title": text_of(node("title", "", title)),
        "style": _palette(theme) + "\n".join(_resource(name) for name in styles),
        "kind": kind,
        "body": "\n".join(body),
        "script": "\n".join(_resource(name) for name in scripts),
    }
    for name, text in parts.items():
        head, mark, tail = frame.partition(f"<!--{name}-->")
        assert mark, name
        frame = head + text + tail
    return frame


def _palette(theme: Theme) -> str:
    """The colours of the window as variables of CSS."""
    colors = {f.name: getattr(theme, f.name) for f in dataclasses.fields(theme) if f.type == "Color"}
    rules = (f"--{name.replace('_', '-')}: {hex_of(color)};" for name, color in colors.items())
    return ":root { " + " ".join(rules) + " }\n"


def _resource(name: str) -> str:
    return (_FOLDER / name).read_text(encoding="utf-8")
