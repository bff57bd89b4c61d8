"""XML as a light tree, read so that no file can make more of itself than it is.

Entities that a file declares for itself are taken (drawing programs shorten namespaces by them) if they are short and
hold no others, and only in small files; what lies outside of the file is never looked at.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any
from xml.parsers import expat

from sandbox.errors import Problem, SceneError
from sandbox.scene.excerpt import excerpt

MAX_DEPTH = 200
"""Nesting of elements."""
_SVG = "http://www.w3.org/2000/svg"
_LONGEST_ENTITY = 200
_MOST_WITH_ENTITIES = 2 * 2**20
"""Characters of a file that declares entities."""
_MOST_TEXT = 64 * 2**20
"""Characters of text and attributes in all, entities replaced."""
_ENCODING = re.compile(r"""^(<\?xml[^>]*?)\s+encoding\s*=\s*["'][^"']*["']""")


@dataclass
class Element:
    """An element; `tag` and the keys of `attributes` as written, but tags without the prefix that means SVG."""

    tag: str
    attributes: dict[str, str]
    line: int
    children: list[Element] = field(default_factory=list)
    text: str = ""

    def get(self, name: str, default: str = "") -> str:
        """An attribute, or the default."""
        return self.attributes.get(name, default)

    def named(self, tag: str) -> Iterator[Element]:
        """The children of that tag."""
        return (child for child in self.children if child.tag == tag)

    def first(self, tag: str) -> Element | None:
        """The first child of that tag."""
        return next(self.named(tag), None)


class _RefusedError(Exception):
    pass


def parse_xml(text: str, source: str) -> Element:
    """The root of an XML text; `source` names it in messages. Raises `SceneError` with line and column."""
    # The text is decoded already, whatever it says of its bytes.
    builder = _Builder(len(text))
    try:
        builder.parser.Parse(_ENCODING.sub(r"\1", text.lstrip()).encode("utf-8", "replace"), True)
    except expat.ExpatError as error:
        raise _error(source, text, expat.errors.messages[error.code], error.lineno, error.offset) from None
    except _RefusedError as error:
        parser = builder.parser
        raise _error(source, text, str(error), parser.CurrentLineNumber, parser.CurrentColumnNumber) from None
    return builder.root


class _Builder:
    def __init__(self, size: int) -> None:
        self._size, self._taken = size, 0
        self._prefix = ""
        self._open: list[Element] = []
        self._root: Element | None = None
        self.parser = expat.ParserCreate()
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.CharacterDataHandler = self._characters
        self.parser.EntityDeclHandler = self._declare

    @property
    def root(self) -> Element:
        assert self._root is not None
        return self._root

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        if len(self._open) >= MAX_DEPTH:
            raise _RefusedError(f"nested deeper than {MAX_DEPTH} levels")
        self._take(sum(map(len, attributes.values())))
        if not self._open:
            self._prefix = next((f"{key[6:]}:" for key, value in attributes.items()
                                 if key.startswith("xmlns:") and value == _SVG), "svg:")  # fmt: skip
        element = Element(tag.removeprefix(self._prefix), attributes, self.parser.CurrentLineNumber)
        if self._open:
            self._open[-1].children.append(element)
        else:
            self._root = element
        self._open.append(element)

    def _end(self, _tag: str) -> None:
        self._open.pop()

    def _characters(self, text: str) -> None:
        self._take(len(text))
        self._open[-1].text += text

    def _take(self, count: int) -> None:
        self._taken += count
        if self._taken > _MOST_TEXT:
            raise _RefusedError("its entities make too much of it")

    def _declare(self, name: str, is_parameter: int, value: str | None, *_: Any) -> None:
        if is_parameter or value is None:
            raise _RefusedError("what lies outside of the file is not read: an entity refers to it")
        if len(value) > _LONGEST_ENTITY or "&" in value or self._size > _MOST_WITH_ENTITIES:
            raise _RefusedError(f"the entity {name[:40]} is refused: it could make too much of the file")


def _error(source: str, text: str, message: str, line: int, column: int) -> SceneError:
    start = sum(len(each) + 1 for each in text.split("\n")[: line - 1]) + column
    start = min(start, max(0, len(text) - 1))
    return SceneError(source, [Problem(message, line=line, column=column + 1, excerpt=excerpt(text, start, start + 1))])
