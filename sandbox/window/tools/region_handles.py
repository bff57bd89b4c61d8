"""The handles of the selected region: what is dragged at its middle moves it, elsewhere at its edge resizes it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from sandbox.engine.commands.set_region import SetRegion
from sandbox.engine.world import World
from sandbox.render.camera import Vec
from sandbox.world.region_area import Box, box_of, corners_of, disc_of, level_of
from sandbox.world.state import State

Area = dict[str, Any]
"""Fields of `SetRegion` that say where a region is."""


@dataclass(frozen=True)
class Handle:
    """Something to drag, at a `place` (m): `moves` the whole or a part, and tells the `area` for another place.

    `alone` is what it does with Ctrl, if that is something else: one corner goes by itself. `gone` is the area without
    the corner. One that is `new` is no corner yet.
    """

    place: Vec
    moves: bool
    area: Callable[[Vec], Area]
    alone: Callable[[Vec], Area] | None = None
    gone: Area | None = None
    new: bool = False


def handles_of(world: World, name: str | None) -> list[Handle]:
    """Those of the region of that name: the one in the middle first; none if it has no area."""
    row = world.directory.find_region(name)
    return [] if row is None else [*_grip(world.state, row), *_rim(world.state, row)]


def middle_of(world: World, name: str) -> Vec | None:
    """The middle of the region's area (m); None if it has none."""
    return next((one.place for one in handles_of(world, name) if one.moves), None)


def command_of(name: str, handle: Handle, place: Vec, alone: bool = False) -> SetRegion:
    """What dragging a handle to a place does; `alone` as with Ctrl."""
    area = handle.alone if alone and handle.alone is not None else handle.area
    return SetRegion(name, **area(place))


def _grip(state: State, row: int) -> Iterator[Handle]:
    """The handle in the middle, which takes all that there is of the area along, and the surface of water."""
    box, corners, disc = box_of(state, row), corners_of(state, row), disc_of(state, row)
    around = corners or ([disc[:2]] if disc else [])
    if not around:
        return
    middle = sum(x for x, _ in around) / len(around), sum(y for _, y in around) / len(around)
    level = level_of(state, row) if state.census.regions.items[row].surfaced else None

    def moved(to: Vec) -> Area:
        x, y = to[0] - middle[0], to[1] - middle[1]
        area: Area = {"disc": (disc[0] + x, disc[1] + y, disc[2])} if disc else {}
        if box:
            area["inside"] = box[0] + x, box[1] + y, box[2] + x, box[3] + y
        elif corners:
            area["outline"] = tuple((a + x, b + y) for a, b in corners)
        return area if level is None else {**area, "surface": level + y}

    yield Handle(middle, True, moved)


def _rim(state: State, row: int) -> Iterator[Handle]:
    box, corners, disc = box_of(state, row), corners_of(state, row), disc_of(state, row)
    if box:
        yield from _box_handles(box, corners)
        if state.census.regions.items[row].surfaced:
            yield Handle((0.25 * box[0] + 0.75 * box[2], level_of(state, row)), False, lambda to: {"surface": to[1]})
    else:
        for number, corner in enumerate(corners):
            yield Handle(corner, False, partial(_pulled, corners, number), gone=_without(corners, number))
            yield Handle(_halfway(corners, number), False, partial(_inserted, corners, number), new=True)
    if disc:
        x, y, _ = disc
        yield Handle((x + disc[2], y), False, lambda to: {"disc": (x, y, math.dist((x, y), to))})


def _box_handles(box: Box, corners: list[Vec]) -> Iterator[Handle]:
    """Four corners and four sides; what is dragged past the opposite side comes out on its other side.

    A corner that goes by itself, is new or goes away makes it a polygon.
    """
    across = ((box[0], (0,)), (0.5 * (box[0] + box[2]), ()), (box[2], (2,)))
    upward = ((box[1], (1,)), (0.5 * (box[1] + box[3]), ()), (box[3], (3,)))

    def stretched(sides: tuple[int, ...], to: Vec) -> Area:
        left, bottom, right, top = (to[side % 2] if side in sides else box[side] for side in range(4))
        return {"inside": (min(left, right), min(bottom, top), max(left, right), max(bottom, top))}

    for x, x_sides in across:
        for y, y_sides in upward:
            if x_sides or y_sides:
                area, number = partial(stretched, (*x_sides, *y_sides)), _nearest(corners, (x, y))
                if x_sides and y_sides:
                    alone, gone = partial(_pulled, corners, number), _without(corners, number)
                    yield Handle((x, y), False, area, alone, gone)
                else:
                    halves = [_halfway(corners, number) for number in range(len(corners))]
                    yield Handle((x, y), False, area, partial(_inserted, corners, _nearest(halves, (x, y))))


def _pulled(corners: list[Vec], number: int, to: Vec) -> Area:
    """One corner elsewhere."""
    return {"outline": (*corners[:number], to, *corners[number + 1 :])}


def _inserted(corners: list[Vec], number: int, to: Vec) -> Area:
    """One corner more, after that of a number."""
    return {"outline": (*corners[: number + 1], to, *corners[number + 1 :])}


def _without(corners: list[Vec], number: int) -> Area | None:
    """One corner less, if enough are left."""
    return {"outline": (*corners[:number], *corners[number + 1 :])} if len(corners) > 3 else None


def _halfway(corners: list[Vec], number: int) -> Vec:
    """The middle of the side after a corner."""
    (ax, ay), (bx, by) = corners[number], corners[(number + 1) % len(corners)]
    return 0.5 * (ax + bx), 0.5 * (ay + by)


def _nearest(points: list[Vec], place: Vec) -> int:
    return min(range(len(points)), key=lambda number: math.dist(points[number], place))
