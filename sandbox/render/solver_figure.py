"""Pictures of the simple solver at work: one impulse, the passes of a substep, curves over time, how it ends."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sandbox.reference.simple.collisions import Placed
from sandbox.reference.simple.trace import Course, Passes, Spot
from sandbox.reference.simple.vectors import Vec
from sandbox.render.chart import Chart, legend
from sandbox.render.number_text import plain, short
from sandbox.render.sat_plane import Plane
from sandbox.render.solver_page import EDGE, HEAD, KINDS, Run, SolverFigure, card
from sandbox.render.svg import Svg

_WIDE, _HIGH = 680, 420
_PANEL = (360.0, 330.0)
_NAMED = 4
"""Most contact points that a legend names."""
_ARROW = 90.0
"""Pixels of the longest arrow of a velocity."""

MEASURES = {
    "top": ("height of the highest body, m", 1.0),
    "height": ("height of the common centre of mass, m", 1.0),
    "penetration": ("deepest overlap, mm", 1e3),
    "energy": ("energy, J", 1.0),
}
"""Fields of `Measures`: what a chart calls them with their unit, and the factor to it."""


def draw_impulse(figure: SolverFigure) -> Svg:
    """The shapes, and at each contact point the velocity before, the impulse, and the velocity after all passes."""
    passes = _passes(figure.runs[0])
    words = "how b moves against a where they touch, before and after the impulse"
    svg = card(_WIDE + 2 * EDGE, HEAD + _HIGH + EDGE, figure.title, words)
    entries = [("velocity before", "b"), ("impulse", "mtv"), ("velocity after", "gap")]
    legend(svg, (EDGE, HEAD - 6), entries)
    most = max([abs(complex(*spot.velocity)) for spot in passes.spots] or [1.0]) or 1.0
    hardest = max(passes.rows[-1]) or 1.0
    with Plane(svg, (EDGE, HEAD), (_WIDE, _HIGH), _corners(passes.shapes), _ARROW + 34.0) as plane:
        _draw_shapes(plane, passes.shapes)
        for k, spot in enumerate(passes.spots):
            given = passes.rows[-1][k]
            push = spot.normal[0] * given, spot.normal[1] * given
            _arrow(plane, spot.place, spot.velocity, (_ARROW / most, "m/s"), "b", "thick")
            _arrow(plane, spot.place, push, (_ARROW / hardest, "N s"), "mtv", "")
            _arrow(plane, spot.place, passes.velocities[k], (_ARROW / most, "m/s"), "gap", "thick")
            plane.dot(spot.place, "out dot")
    return svg


def draw_passes(figure: SolverFigure) -> Svg:
    """The impulses given so far after each pass, a panel for each run; dashes where many passes lead to."""
    count = len(figure.runs)
    width, height = (float(_WIDE) if count == 1 else _PANEL[0]), _PANEL[1]
    words = f"normal impulse given so far, after each pass over the contacts; step {figure.step}"
    svg = card(EDGE + count * (width + EDGE), HEAD + 44 + height + EDGE, figure.title, words)
    spots = _passes(figure.runs[0]).spots
    legend(
        svg, (EDGE, HEAD - 2), [(point_name(spots, k), KINDS[k % len(KINDS)]) for k in range(min(len(spots), _NAMED))]
    )
    given = [value for run in figure.runs for row in (*_passes(run).rows, _passes(run).settled) for value in row]
    for k, run in enumerate(figure.runs):
        rows, settled = _passes(run).rows, _passes(run).settled
        at = EDGE + k * (width + EDGE), HEAD + 44
        svg.text((at[0] + 62, at[1] - 26), run.label, "strong")
        chart = Chart(svg, at, (width, height), (0, len(rows)), (0.0, max(given)))
        chart.paper("passes", "N s")
        for point in range(len(settled)):  # others may touch than in the first run
            kind = KINDS[point % len(KINDS)]
            chart.level(settled[point], kind)
            chart.curve([(0, 0.0), *((i, row[point]) for i, row in enumerate(rows, 1))], kind, len(rows) <= 20)
    return svg


def draw_curves(figure: SolverFigure) -> Svg:
    """One measure over time, a curve for each run."""
    name, factor = MEASURES[figure.measure]
    svg = card(_WIDE + 2 * EDGE, HEAD + 20 + _HIGH - 60 + EDGE, figure.title, name)
    legend(svg, (EDGE, HEAD - 2), [(run.label, KINDS[k % len(KINDS)]) for k, run in enumerate(figure.runs)])
    courses = [_course(run) for run in figure.runs]
    values = [[factor * getattr(each, figure.measure) for each in course.measures] for course in courses]
    flat = [value for row in values for value in row]
    times = courses[0].times
    chart = Chart(svg, (EDGE, HEAD + 20), (_WIDE, _HIGH - 60), (times[0], times[-1]), (min(flat), max(flat)))
    chart.paper("time, s", "")
    # The scene as it is comes last, so that it lies on top.
    for k in reversed(range(len(courses))):
        chart.curve(list(zip(times, values[k], strict=True)), KINDS[k % len(KINDS)])
    return svg


def draw_ends(figure: SolverFigure) -> Svg:
    """Where all shapes lie at the end, a panel for each run in one scale: side by side what is tall, else in rows."""
    courses = [_course(run) for run in figure.runs]
    seen = [corner for course in courses for corner in _corners(course.end)]
    wide = max(x for x, _ in seen) - min(x for x, _ in seen)
    high = max(y for _, y in seen) - min(y for _, y in seen)
    words = f"after {plain(round(courses[0].times[-1], 2))} s"
    if high > wide:
        size = round(min(max(_HIGH * wide / high + 20.0, 140.0), 300.0)), _HIGH
        ways = [(EDGE + k * (size[0] + EDGE), HEAD) for k in range(len(courses))]
    else:
        size = _WIDE, round(min(max(_WIDE * high / wide, 90.0), 300.0))
        ways = [(EDGE, HEAD + k * (size[1] + 44.0)) for k in range(len(courses))]
    svg = card(ways[-1][0] + size[0] + EDGE, ways[-1][1] + size[1] + 44 + EDGE, figure.title, words)
    for at, run, course in zip(ways, figure.runs, courses, strict=True):
        with Plane(svg, at, size, seen, 14.0) as plane:
            _draw_shapes(plane, course.end)
        for line, part in enumerate(run.label.split(", ") if high > wide else [run.label]):
            svg.text((at[0] + size[0] / 2, at[1] + size[1] + 24 + 18 * line), part, "small strong", "middle")
    return svg


def _draw_shapes(plane: Plane, shapes: Sequence[Placed]) -> None:
    for shape in shapes:
        plane.shape(shape, "a shape" if shape.moves else "other shape")


def _arrow(plane: Plane, start: Vec, way: Vec, measure: tuple[float, str], kind: str, look: str) -> None:
    """An arrow with its length in words; `measure` is the pixels to a unit, and the unit's name."""
    size, (pixels, unit) = abs(complex(*way)), measure
    if size * pixels <= 2.0:
        return
    reach = pixels / plane.scale
    plane.arrow(start, (start[0] + way[0] * reach, start[1] + way[1] * reach), f"{kind} {look}".strip())
    (x, y), far = plane.pixel(start), (size * pixels + 16.0) / size
    words = f"{short(size)} {unit}"
    # Words grow to the side that they are on.
    anchor = "middle" if abs(way[0]) < 0.5 * size else "end" if way[0] < 0.0 else "start"
    plane.svg.text((x + way[0] * far, y - way[1] * far + 5.0), words, f"{kind} strong small", anchor)


def _corners(shapes: Sequence[Placed]) -> list[Vec]:
    """Corners of the boxes around all that moves, or around everything if nothing does."""
    moving = [shape for shape in shapes if shape.moves] or list(shapes)
    boxes = [shape.box() for shape in moving]
    return [corner for left, low, right, high in boxes for corner in ((left, low), (right, high))]


def point_name(spots: Sequence[Spot], k: int) -> str:
    """The two bodies of a point, and which of their points it is if there are several."""
    pair = spots[k].names
    same = [i for i, spot in enumerate(spots) if spot.names == pair]
    return " on ".join(reversed(pair)) + (f", point {same.index(k) + 1}" if len(same) > 1 else "")


def _passes(run: Run) -> Passes:
    assert run.passes is not None
    return run.passes


def _course(run: Run) -> Course:
    assert run.course is not None
    return run.course


STEP_FIGURES: dict[str, Callable[[SolverFigure], Svg]] = {"impulse": draw_impulse, "passes": draw_passes}
"""Figures that look into one step, by their names on the command line."""

TIME_FIGURES: dict[str, Callable[[SolverFigure], Svg]] = {"curves": draw_curves, "ends": draw_ends}
"""Figures of a whole run."""
