"""Values of maps."""

from __future__ import annotations

from typing import Any

from sandbox.formats.reading import Node
from sandbox.scene.finding import Path


class TiledNode(Node):
    """Numbers may be written as text, as converters from XML leave them."""

    def number_of(self, value: Any, path: Path) -> float:
        return super().number_of(_number(value) if isinstance(value, str) else value, path)

    def flag(self, key: str, default: bool = False) -> bool:
        value = self.value(key)
        return value in ("1", "true") if isinstance(value, str) else super().flag(key, default)


def _number(text: str) -> float | str:
    """The text itself if it is no number: it is told as what it is."""
    try:
        return float(text)
    except ValueError:
        return text
