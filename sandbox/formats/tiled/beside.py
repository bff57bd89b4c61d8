"""Files that a map refers to: tilesets and templates that lie beside it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

from sandbox.formats.open_file import open_source
from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.source import Source
from sandbox.formats.tiled.tiled_node import TiledNode
from sandbox.formats.tiled.tmx import line_in
from sandbox.formats.xml_tree import Element

T = TypeVar("T")


class Beside:
    """Files in, and below, the folder of a map, or reached from it; `convert` makes JSON of their XML."""

    def __init__(self, folder: Path, convert: Callable[[Element], dict[str, Any]]) -> None:
        self._folder, self._convert = folder, convert

    def path(self, name: str) -> Path | None:
        """Where the file is; None if it is not there."""
        name = name.replace("\\", "/")
        try:
            path = self._folder / name
            return path if not Path(name).is_absolute() and path.is_file() else None
        except (OSError, ValueError):
            return None

    def read(self, name: str, use: Callable[[Node, Path], T]) -> T | None:
        """What `use` makes of the file; None if it is not there. Raises `SceneError` with the place in that file."""
        path = self.path(name)
        if path is None:
            return None
        source = open_source(path)
        if isinstance(source.data, Element):
            data = self._convert(source.data)
            source = Source(path, source.text, data, line_in(data))
        try:
            if not isinstance(source.data, dict):
                raise MisreadError((), "this is no file of Tiled")
            return use(TiledNode(source.data), path)
        except MisreadError as error:
            raise source.error(error) from None
