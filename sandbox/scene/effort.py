"""What may be spent on the mistakes of one file: who is wrong a thousand times over is told so in time."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass

from sandbox.scene.limits import MAX_ALIKE

_COMPARED = 3_000_000


@dataclass
class Effort:
    """`compared`: pairs of characters that may still be compared to find near names; a third of a second, some hundred
    suggestions in a small file. `outlines`: wrong polygons that may still be looked into, of which each may take half a
    second; the others are let be then, as the file is refused anyway."""

    compared: int = _COMPARED
    outlines: int = MAX_ALIKE


_shared: ContextVar[Effort | None] = ContextVar("_shared", default=None)


def effort() -> Effort:
    """That of the file at hand; one of its own where there is none."""
    return _shared.get() or Effort()


@contextmanager
def one_effort() -> Iterator[None]:
    """What is checked in this context is checked with one effort."""
    if _shared.get() is not None:  # a part of something larger
        yield
        return
    token = _shared.set(Effort())
    try:
        yield
    finally:
        _shared.reset(token)
