"""How `sandbox solver` prints: a row a pass, or a row a moment; or all of it as JSON."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from sandbox.cli.sat_text import aligned
from sandbox.reference.simple.trace import Passes
from sandbox.render.solver_figure import MEASURES, point_name
from sandbox.render.solver_page import Run, SolverFigure

_ROWS = 12
_COLUMNS = 8
"""Most rows over time, and most contact points, that are printed."""


def passes_lines(shown: SolverFigure) -> list[str]:
    """For every run: the points as the first pass meets them, and their impulses after each pass."""
    lines: list[str] = []
    for run in shown.runs:
        assert run.passes is not None
        lines += ["", run.label, ""] if len(shown.runs) > 1 else []
        lines += [*_point_lines(run.passes), "", *_pass_lines(run)]
    more = len(shown.runs[0].passes.spots) - _COLUMNS if shown.runs[0].passes else 0
    return [*lines, *([f"{more} more points are in --json"] if more > 0 else [])]


def _point_lines(passes: Passes) -> list[str]:
    """Gap, speed along the normal and effective mass of each point."""
    rows = [["point", "", "gap m", "speed m/s", "mass kg"]]
    for k, spot in enumerate(passes.spots[:_COLUMNS]):
        cells = [f"{value:.4f}" for value in (spot.gap, spot.speed, spot.mass)]
        rows.append([str(k + 1), point_name(passes.spots, k), *map(_unsigned, cells)])
    return aligned(rows, left=(1,))


def _pass_lines(run: Run) -> list[str]:
    """Impulses in N s; the last row is what many passes come to."""
    assert run.passes is not None
    count = min(len(run.passes.spots), _COLUMNS)
    rows = [["pass", *(f"N s at {k + 1}" for k in range(count))]]
    for number, row in enumerate(run.passes.rows, 1):
        rows.append([str(number), *(f"{value:.4f}" for value in row[:count])])
    rows.append(["many", *(f"{value:.4f}" for value in run.passes.settled[:count])])
    return aligned(rows)


def time_lines(shown: SolverFigure) -> list[str]:
    """The measure of every run, a row a moment."""
    name, factor = MEASURES[shown.measure]
    courses = [run.course for run in shown.runs if run.course is not None]
    times = courses[0].times
    rows = [["time s", *(run.label for run in shown.runs)]]
    for k in sorted({round((len(times) - 1) * i / _ROWS) for i in range(_ROWS + 1)}):
        values = [factor * getattr(course.measures[k], shown.measure) for course in courses]
        rows.append([f"{times[k]:.2f}", *(_unsigned(f"{value:.3f}") for value in values)])
    return [name, "", *aligned(rows)]


def facts(shown: SolverFigure) -> dict[str, Any]:
    """Everything, as the document of `--json` has it."""
    runs = []
    for run in shown.runs:
        entry: dict[str, object] = {"label": run.label}
        if run.passes is not None:
            points = [asdict(spot) for spot in run.passes.spots]
            entry |= {"points": points, "passes": run.passes.rows, "settled": run.passes.settled}
        if run.course is not None:
            measures = [asdict(each) for each in run.course.measures]
            entry |= {"times": run.course.times, "measures": measures}
        runs.append(entry)
    return {"title": shown.title, "runs": runs}


def _unsigned(text: str) -> str:
    """A zero without a sign."""
    return text.lstrip("-") if float(text) == 0.0 else text
