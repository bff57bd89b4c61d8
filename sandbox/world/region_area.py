"""The area of a region as a scene file tells it, from the half-planes and the disc that its record has."""

from __future__ import annotations

from typing import Any

from sandbox.world.state import State

Vec = tuple[float, float]
Box = tuple[float, float, float, float]
"""Left, bottom, right, top in metres."""
_BOX_SIDES = ((-1.0, 0.0), (0.0, -1.0), (1.0, 0.0), (0.0, 1.0))


def side_count(state: State, row: int) -> int:
    """How many sides the area of a region has: its surface, if it has one, is an edge but no side."""
    return int(state.regions[row].edge_count) - state.census.regions.items[row].surfaced


def box_of(state: State, row: int) -> Box | None:
    """What `inside` says of a region; None for another area."""
    sides = _sides(state, row)
    if tuple((x, y) for x, y, _ in sides) != _BOX_SIDES:
        return None
    left, bottom, right, top = (offset for _, _, offset in sides)
    return 0.0 - left, 0.0 - bottom, right, top


def corners_of(state: State, row: int) -> list[Vec]:
    """The corners of the sides of a region (m), counter-clockwise; none if it has no sides."""
    sides = _sides(state, row)
    return [_crossing(*pair) for pair in zip(sides[-1:] + sides[:-1], sides, strict=True)]


def disc_of(state: State, row: int) -> tuple[float, float, float] | None:
    """What `disc` says of a region: x, y, radius in metres; None if it has none."""
    region: Any = state.regions[row]
    found = float(region.disc_x), float(region.disc_y), float(region.disc_radius)
    return found if found[2] > 0.0 else None


def level_of(state: State, row: int) -> float:
    """The height of the surface of water (m); of a region without one, how far its last side lies out."""
    region: Any = state.regions[row]
    return float(state.edges[region.first_edge + region.edge_count - 1].offset)


def _sides(state: State, row: int) -> list[tuple[float, float, float]]:
    first = int(state.regions[row].first_edge)
    edges = state.edges[first : first + side_count(state, row)]
    return [(float(edge.normal_x), float(edge.normal_y), float(edge.offset)) for edge in edges]


def _crossing(one: tuple[float, float, float], other: tuple[float, float, float]) -> Vec:
    """Where the lines at the edges of two half-planes cross."""
    (ax, ay, a), (bx, by, b) = one, other
    turn = ax * by - ay * bx
    return (a * by - b * ay) / turn, (ax * b - bx * a) / turn
