"""What a notebook shows of a value. The package says who renders it, so that values need not know of pages."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

Renderer: TypeAlias = Callable[[Any], str]
"""From a value to HTML."""

_renderers: list[Renderer] = []


def render_with(renderer: Renderer) -> None:
    """Let `renderer` render every `Shown` value from now on."""
    _renderers[:] = [renderer]


class Shown:
    """A notebook shows a player of it."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        return _renderers[0](self) if _renderers else None  # None: the notebook shows its repr
