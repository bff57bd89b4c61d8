"""What a world has already, so that a part of a scene can be read that refers to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Known:
    """The types of bodies and the kinds of joints by id, and how many convex shapes there are."""

    types: Mapping[str, str] = field(default_factory=dict)
    kinds: Mapping[str, str] = field(default_factory=dict)
    shapes: int = 0


NOTHING = Known()
