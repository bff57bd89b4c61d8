"""What a world has already, so that a part of a scene can be read that refers to it."""

from __future__ import annotations

from collections.abc import Collection, Container, Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Known:
    """The types of bodies and the kinds of joints by id, how many convex shapes there are, the ids of regions, and how
    many regions there are. Of the fields `lacking`, such as "materials", there is more than can be read."""

    types: Mapping[str, str] = field(default_factory=dict)
    kinds: Mapping[str, str] = field(default_factory=dict)
    shapes: int = 0
    regions: Container[str] = ()
    region_count: int = 0
    lacking: Collection[str] = ()


NOTHING = Known()
