"""Colours of the constraint graph: contacts of one colour share no moving body and are solved side by side."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.engine.contact_solver.blocks import KIND, MAX_COLORS
from sandbox.render.geometry import Ints
from sandbox.render.marks import Marks
from sandbox.render.number_text import counted
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.pen import Pen

_MOST_LEGEND = 8


def _draw(look: Look) -> Marks:
    pen, points = Pen(look), look.points
    color = contact_colors(look)[points.contact]
    known = color >= 0
    inks = look.palette.categories(np.maximum(color, 0))
    inks[~known] = look.palette.quiet
    first = np.unique(points.contact, return_index=True)[1]
    pen.dots(points.pixel, 3.5 if len(points) < 3000 else 2.0, inks)
    numbered = first[known[first]]
    pen.labels(map(str, color[numbered].tolist()), points.pixel[numbered], look.palette.text, gap=7.0)
    own, count = np.unique(color[known & np.isin(np.arange(len(color)), first)], return_counts=True)
    for each, contacts in list(zip(own.tolist(), count.tolist(), strict=True))[:_MOST_LEGEND]:
        name = f"colour {each}" if each < MAX_COLORS else "one by one"
        pen.legend(look.palette.categories(np.array([each]))[0], f"{name}: {counted(contacts, 'contact')}")
    if not known.all():
        pen.legend(look.palette.quiet, "not solved in the last pass: asleep, or of another substep level")
    return pen.marks()


def contact_colors(look: Look) -> Ints:
    """The colour of each contact (c,) in the last pass of the solver; -1 for those that were not in it."""
    world = look.world
    color = np.full(len(world.contacts), -1)
    active: Any = np.asarray(world.scratch.contacts.active)["contact"]
    rows = active[1 : 1 + int(active[0])]
    solved: Any = np.asarray(world.scratch.blocks.colors[: len(rows)])
    sound = (rows < len(color)) & (rows >= 0)
    color[rows[sound]] = (solved % KIND)[sound]
    return color


OVERLAY = Overlay("colors", "Graph colours", "Graph colour of each contact: those of one colour share no body.", _draw)
