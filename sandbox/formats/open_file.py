"""Opens a file that may be of any format: a recording, JSON or XML, told by its first characters."""

from __future__ import annotations

from pathlib import Path as FilePath

from sandbox.formats.b2rec.header import MAGIC
from sandbox.formats.decoded import decoded, unwrapped
from sandbox.formats.source import Source
from sandbox.formats.xml_tree import parse_xml
from sandbox.scene.finding import Path
from sandbox.scene.parse import parse
from sandbox.scene.read import read_data


def open_source(path: FilePath) -> Source:
    """The file, parsed: the root element of XML, the data of JSON, or the bytes of a recording. Raises `SceneError`."""
    data = read_data(path)
    if data.startswith(MAGIC):
        return Source(path, "", data)
    text = decoded(path, data).removeprefix("\ufeff")
    if text.lstrip().startswith("<"):
        return Source(path, text, parse_xml(text, str(path)), _line)
    text = unwrapped(text)
    return Source(path, text, parse(text, str(path)).data)


def _line(path: Path) -> int:
    """Elements know their line: a path to something in XML begins with it."""
    return path[0] if path and isinstance(path[0], int) else 1
