"""Opens a file that may be of any format: JSON or XML, told by its first character."""

from __future__ import annotations

from pathlib import Path as FilePath

from sandbox.formats.source import Source
from sandbox.formats.xml_tree import parse_xml
from sandbox.scene.finding import Path
from sandbox.scene.parse import parse
from sandbox.scene.read import read_text


def open_source(path: FilePath) -> Source:
    """The file, parsed: the root element of XML, or the data of JSON. Raises `SceneError`."""
    text = read_text(path).removeprefix("\ufeff")
    if text.lstrip().startswith("<"):
        return Source(path, text, parse_xml(text, str(path)), _line)
    return Source(path, text, parse(text, str(path)).data)


def _line(path: Path) -> int:
    """Elements know their line: a path to something in XML begins with it."""
    return path[0] if path and isinstance(path[0], int) else 1
