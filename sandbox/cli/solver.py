"""`sandbox solver`: the simple solver at work, pass by pass within a step or over time, as a table or a picture."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from sandbox.cli.document import JSON, print_document
from sandbox.cli.options import SET, takes, values_set
from sandbox.errors import SandboxError
from sandbox.resources import find_scene

if TYPE_CHECKING:
    from sandbox.render.solver_page import SolverFigure

_SCENE = typer.Argument(metavar="SCENE", help="A scene file, or the name of a shipped scene.")
_VARY = typer.Option(
    "--vary", metavar="TEXT", show_default=False,
    help='Solve it another way beside (may be repeated), such as "soft=off" or "substeps=1,iterations=4".',
)  # fmt: skip
_STEP = typer.Option(min=1, max=100_000, metavar="N", help="The step to look into, pass by pass.")
_ITERATIONS = typer.Option(min=1, max=1000, metavar="N", help="Passes over the contacts in a substep.")
_TIME = typer.Option("--over-time", help="Run the whole scene instead of looking into one step.")
_STEPS = typer.Option(
    min=1, max=100_000, metavar="N", show_default=False, help="With --over-time: steps instead of the scene's number."
)
_MEASURE = typer.Option(
    metavar="NAME", show_default=False,
    help="With --over-time: top (the default), height, penetration or energy.",
)  # fmt: skip
_FIGURE = typer.Option(
    metavar="NAME", show_default=False,
    help="What to draw: passes (the default) or impulse; with --over-time curves (the default) or ends.",
)  # fmt: skip
_SVG = typer.Option("--svg", show_default=False, metavar="FILE", help="Also draw it into this SVG file.")


@dataclass(frozen=True)
class SolverOptions:
    """What `sandbox solver` was asked for."""

    scene: Annotated[Path, _SCENE]
    vary: Annotated[list[str] | None, _VARY] = None
    step: Annotated[int, _STEP] = 1
    iterations: Annotated[int, _ITERATIONS] = 1
    over_time: Annotated[bool, _TIME] = False
    steps: Annotated[int | None, _STEPS] = None
    measure: Annotated[str, _MEASURE] = ""
    figure: Annotated[str, _FIGURE] = ""
    svg: Annotated[Path | None, _SVG] = None
    set: Annotated[list[str] | None, SET] = None
    json: Annotated[bool, JSON] = False


@takes(SolverOptions)
def solver(options: SolverOptions) -> None:
    """Show sequential impulses at work: the simple solver, which is written to be read, on a scene of contacts.

    Without --over-time: the normal impulse of every contact point after each pass, in the first substep of one step,
    and what many passes come to. The techniques that the scene switches off are off here too.

    Exit code 2: the scene, or an option, could not be used.
    """
    _check_options(options)
    from sandbox.cli.solver_text import facts, passes_lines, time_lines

    over_time, svg = options.over_time, options.svg
    shown = _over_time(options) if over_time else _passes(options)
    if svg is not None:
        _draw(shown, options.figure, svg)
    if options.json:
        print_document(facts(shown))
        return
    for line in time_lines(shown) if over_time else passes_lines(shown):
        typer.echo(line)
    if svg is not None:
        typer.echo(f"{svg}: {svg.stat().st_size / 1000:.0f} kB")


def _check_options(options: SolverOptions) -> None:
    from sandbox.cli.picture_options import writable_picture
    from sandbox.render.solver_figure import MEASURES, STEP_FIGURES, TIME_FIGURES

    over_time, measure, figure, svg = options.over_time, options.measure, options.figure, options.svg
    if not over_time and (options.steps is not None or measure):
        raise SandboxError(f"{'--measure' if measure else '--steps'} is for --over-time: give both")
    if figure and svg is None:
        raise SandboxError("--figure chooses what --svg FILE draws: give both")
    _check_name("--measure", measure, MEASURES)
    elsewhere = STEP_FIGURES if over_time else TIME_FIGURES
    if figure in elsewhere:
        raise SandboxError(f"--figure {figure} is drawn {'without' if over_time else 'with'} --over-time")
    _check_name("--figure", figure, TIME_FIGURES if over_time else STEP_FIGURES)
    if svg is not None:
        writable_picture(svg, {".svg"}, [options.scene])


def _check_name(option: str, name: str, known: Iterable[str]) -> None:
    from sandbox.scene.near_names import did_you_mean

    names = list(known)
    if name and name not in names:
        hint = did_you_mean(name, names) or f"there are {', '.join(names)}"
        raise SandboxError(f"{option} {name}: there is none of that name; {hint}")


def _passes(options: SolverOptions) -> SolverFigure:
    from rich.console import Console

    from sandbox.cli.opening import open_any
    from sandbox.cli.progress import SceneProgress
    from sandbox.cli.solver_runs import runs_of
    from sandbox.reference.simple.trace import MANY, watch_passes
    from sandbox.render.solver_page import Run, SolverFigure

    scene = open_any(find_scene(options.scene), values_set(options.set))
    flat, step = scene.flatten(), options.step
    wanted = runs_of(flat, options.vary or [], options.iterations)
    runs = []
    with SceneProgress(Console(stderr=True), len(wanted), "steps and passes") as progress:
        for label, techniques in wanted:
            progress.begin(label, step - 1 + MANY)
            runs.append(Run(label, watch_passes(flat, techniques, step, progress.done)))
    return SolverFigure(scene.title or options.scene.name, tuple(runs), step=step)


def _over_time(options: SolverOptions) -> SolverFigure:
    from rich.console import Console

    from sandbox.cli.opening import open_any
    from sandbox.cli.progress import SceneProgress
    from sandbox.cli.solver_runs import runs_of
    from sandbox.reference.simple.trace import run_course
    from sandbox.render.solver_page import Run, SolverFigure
    from sandbox.scene.duration import planned_steps

    scene = open_any(find_scene(options.scene), values_set(options.set))
    flat = scene.flatten()
    total = planned_steps(scene) if options.steps is None else options.steps
    wanted = runs_of(flat, options.vary or [], options.iterations)
    runs = []
    with SceneProgress(Console(stderr=True), len(wanted)) as progress:
        for label, techniques in wanted:
            progress.begin(label, total)
            runs.append(Run(label, course=run_course(flat, techniques, total, progress.done)))
    return SolverFigure(scene.title or options.scene.name, tuple(runs), measure=options.measure or "top")


def _draw(shown: SolverFigure, figure: str, svg: Path) -> None:
    from sandbox.render.solver_figure import STEP_FIGURES, TIME_FIGURES

    usual = "passes" if shown.runs[0].course is None else "curves"
    (STEP_FIGURES | TIME_FIGURES)[figure or usual](shown).save(svg)
