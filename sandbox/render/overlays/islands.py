"""Islands: bodies that contacts and joints hold together, each island in a colour."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.render.body_colors import mix
from sandbox.render.geometry import Ints
from sandbox.render.marks import Marks
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen
from sandbox.tables import plain
from sandbox.world.records import DYNAMIC

ASLEEP = 0.4
"""How far the colours of sleepers move towards the background."""


def _draw(look: Look) -> Marks:
    pen = Pen(look)
    island = islands_of(look)
    own, number, size = np.unique(island, return_inverse=True, return_counts=True)
    part = (island >= 0).astype(np.float64)
    alone = (size[number] == 1) & (island >= 0)
    colors = look.palette.categories(own[number])
    colors[alone] = look.palette.quiet
    asleep = (look.frame.type == DYNAMIC) & ~look.frame.awake
    colors[asleep] = mix(colors[asleep], look.theme.background, ASLEEP)
    pen.tint(colors, part)
    count = int((size[own >= 0] > 1).sum())
    largest = int(size[own >= 0].max(initial=0))
    pen.legend(look.palette.text, f"islands of several bodies: {count}, the largest of {largest}")
    pen.legend(look.palette.quiet, f"bodies alone: {int(alone.sum())}")
    return pen.marks(calm=False)


def islands_of(look: Look) -> Ints:
    """The lowest row of each body's island (n,), as the engine joins them; -1 for bodies that are not dynamic."""
    bodies: Any = plain(look.world.state.bodies)
    dynamic = bodies["type"] == DYNAMIC
    awake = dynamic & (bodies["awake"] == 1)
    contacts: Any = plain(look.world.contacts)
    links = [np.column_stack([contacts["body_a"], contacts["body_b"]])]
    joints = look.world.scratch.joints
    if joints is not None:
        ties: Any = plain(joints.ties)
        links.append(np.column_stack([ties["low"], ties["high"]]))
    pairs = np.concatenate(links)
    pairs = pairs[((pairs >= 0) & (pairs < len(bodies))).all(axis=1)]
    island = lowest_row(len(bodies), pairs[awake[pairs].all(axis=1)])
    island = np.where(dynamic & ~awake & (bodies["island"] > 0), bodies["island"] - 1, island)
    found: Ints = np.where(dynamic, island, -1)
    return found


def lowest_row(count: int, pairs: Ints) -> Ints:
    """For each of `count` nodes the lowest one that `pairs` (p, 2) connect it with, over others as well."""
    lowest = np.arange(count)
    while True:
        before = lowest.copy()
        least = np.minimum(lowest[pairs[:, 0]], lowest[pairs[:, 1]])
        for side in (0, 1):
            np.minimum.at(lowest, lowest[pairs[:, side]], least)
            np.minimum.at(lowest, pairs[:, side], least)
        lowest = lowest[lowest]
        if (lowest == before).all():
            return lowest


OVERLAY = Overlay("islands", "Islands", "Bodies held together by contacts and joints, a colour for each island.", _draw)
