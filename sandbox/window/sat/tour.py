"""The test told in steps: axes, one projection after the other, exit, minimum, orientation, clipping, points."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from sandbox.geometry.sat_rows import SatRow, author_edges
from sandbox.render.number_text import metres, short
from sandbox.render.sat_labels import axis_name
from sandbox.window.sat.inspection import Inspection

Kind = Literal["axes", "project", "exit", "minimum", "orientation", "reference", "cut", "points"]


@dataclass(frozen=True)
class Step:
    """One step of the tour: what it is about, a sentence with the numbers of this pair, and the axis it looks at."""

    kind: Kind
    title: str
    text: str
    row: int | None = None


def tour_of(seen: Inspection) -> list[Step]:
    """All steps, in order."""
    return list(_steps(seen))


def _steps(seen: Inspection) -> Iterator[Step]:
    yield Step("axes", "Axes", _axes(seen))
    for row in seen.table.rows[: seen.tested]:
        yield _projection(seen, row)
    if seen.table.stopped is not None:
        yield _exit(seen, seen.table.stopped)
        return
    least = seen.deciding
    yield Step("minimum", "The least overlap", _minimum(seen, least), least.number)
    yield Step("orientation", "Which way", _orientation(seen, least), least.number)
    yield from _clipping(seen)


def _axes(seen: Inspection) -> str:
    first, second = len(author_edges(seen.a)), len(author_edges(seen.b))
    count = len(seen.table.rows)
    parts = [f"{number} of {name}" for number, name in zip((first, second), seen.names, strict=True) if number]
    edges = f"An axis across every edge: {' and '.join(parts)}" if parts else "Discs have no edges"
    rounded = ", and one between the two nearest vertices, for what is round" if count > first + second else ""
    return f"{edges}{rounded}. {count} in all; one that leaves a gap is enough."


def _projection(seen: Inspection, row: SatRow) -> Step:
    a, b = seen.names
    title = f"Axis {row.number} of {len(seen.table.rows)}, {axis_name(row, seen.names)}"
    reach = f"{a} reaches from {short(row.amin)} to {short(row.amax)}, {b} from {short(row.bmin)} to {short(row.bmax)}"
    if row.gap:
        end = "they have nothing in common: a gap."
    else:
        end = f"they overlap by {metres(-row.separation)}, so this axis does not part them."
    return Step("project", title, f"{reach}: {end}", row.number)


def _exit(seen: Inspection, row: SatRow) -> Step:
    rest = len(seen.table.rows) - row.number
    spared = f"{'The other' if rest > 1 else 'The last'} {rest if rest > 1 else 'axis'}" if rest else ""
    spared = f" {spared}{' are' if rest > 1 else ' is'} never looked at." if rest else " It was the last one."
    gap = "They only touch there" if row.separation == 0.0 else f"A gap of {metres(row.separation)}"
    return Step("exit", "Early exit", f"{gap} on axis {row.number}: they do not collide.{spared}", row.number)


def _minimum(seen: Inspection, least: SatRow) -> str:
    second = seen.table.runner_up
    words = (
        f"Divided by the axis' length, the overlap on axis {least.number} is the least: {metres(-least.separation)}."
    )
    if second is None:
        return words
    margin = metres(least.separation - second.separation)
    return f"{words} Next is axis {second.number} with {metres(-second.separation)}, {margin} more."


def _orientation(seen: Inspection, row: SatRow) -> str:
    forwards, backwards = row.amax - row.bmin, row.bmax - row.amin
    way, less = ("along", "<=") if row.way > 0 else ("against", ">")
    return (
        f"amax - bmin = {short(forwards)} {less} bmax - amin = {short(backwards)}, so {seen.names[1]} leaves {way} "
        f"the axis, by {metres(-row.separation)}. The centres play no part."
    )


def _clipping(seen: Inspection) -> Iterator[Step]:
    contact, clip = seen.table.contact, seen.clip
    points = len(contact.points) if contact is not None else 0
    if clip is None:
        yield Step("points", "Contact point", "Where a disc or two corners meet there is nothing to clip: one point, "
                   "half way between the two surfaces.")  # fmt: skip
        return
    mine, other = seen.names if clip.owner == "a" else seen.names[::-1]
    yield Step("reference", "Reference and incident edge",
               f"Edge {clip.reference_edge} of {mine} gave the axis: it is the reference face. Edge "
               f"{clip.incident_edge} of {other} faces it most: the incident edge.")  # fmt: skip
    yield Step("cut", "Clipping", "The incident edge is cut off at the two sides of the reference face.")
    kept = sum(gap <= 0.0 for gap in clip.gaps)
    yield Step("points", "Contact points" if points > 1 else "Contact point",
               f"{kept} of its ends lie{'s' * (kept == 1)} beneath the face: "
               f"{points} contact point{'s' * (points > 1)}, "
               "half way between the surfaces.")  # fmt: skip
