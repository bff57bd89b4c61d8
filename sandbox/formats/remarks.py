"""What of a file is not carried over, or otherwise than it says there: each with its place."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

_SHOWN = 5


class Remark(NamedTuple):
    """What became of something (`text`), and where in the file it is; "" is the whole file."""

    place: str
    text: str


class Remarks:
    """Collects remarks in the order in which they come up, each once."""

    def __init__(self) -> None:
        self._found: dict[Remark, None] = {}

    def note(self, place: str, text: str) -> None:
        """Something is not carried over as it is."""
        self._found[Remark(place, text)] = None

    def __iter__(self) -> Iterator[Remark]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)


def remark_lines(remarks: tuple[Remark, ...]) -> list[str]:
    """A line for each text, with the first places that it holds for."""
    places: dict[str, list[str]] = {}
    for place, text in remarks:
        places.setdefault(text, []).append(place)
    return [text + _listed([place for place in found if place]) for text, found in places.items()]


def _listed(places: list[str]) -> str:
    if not places:
        return ""
    more = f" and {len(places) - _SHOWN} more" if len(places) > _SHOWN else ""
    return f": {', '.join(places[:_SHOWN])}{more}"
