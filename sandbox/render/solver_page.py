"""What all pictures of the simple solver share: what they show, and the card with its headline."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.reference.simple.trace import Course, Passes
from sandbox.render.sat_style import style_sheet
from sandbox.render.svg import Svg

KINDS = ("a", "b", "gap", "out", "mtv")
"""Colours of curves, in this order."""

HEAD, EDGE = 84.0, 24.0
"""Pixels above and beside what a card shows."""


@dataclass(frozen=True)
class Run:
    """One way to solve the scene: `label` says what is otherwise than the scene has it. Either half may be missing."""

    label: str
    passes: Passes | None = None
    course: Course | None = None


@dataclass(frozen=True)
class SolverFigure:
    """What a picture shows. `measure` is a field of `Measures` for the curves, `step` the one looked into."""

    title: str
    runs: tuple[Run, ...]
    measure: str = "top"
    step: int = 1


def card(width: float, height: float, title: str, subtitle: str) -> Svg:
    """An empty card with a headline on it."""
    svg = Svg(width, height, f"{title}: {subtitle}", style_sheet())
    svg.rectangle(0.5, 0.5, width - 1, height - 1, "card", 14.0)
    svg.text((EDGE, 38), title, "title")
    svg.text((EDGE, 60), subtitle, "soft")
    return svg
