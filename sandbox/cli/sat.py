"""`sandbox sat`: the separating-axis test of two bodies, as a table, as a picture, or told step by step."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from sandbox.cli.document import JSON, print_document
from sandbox.cli.options import SET, takes, values_set
from sandbox.errors import SandboxError
from sandbox.resources import find_scene

if TYPE_CHECKING:
    from sandbox.cli.sat_pair import SatPair
    from sandbox.engine.world import World
    from sandbox.geometry.sat_table import SatTable
    from sandbox.render.sat_page import Member, Whole

_MOST_SHAPES = 1000
"""Most shapes that `--figure scene` draws, and most pairs of them for `--figure parts`."""
_NAME = 17
"""Letters of a body's name that fit into the headline of a picture."""

_SCENE = typer.Argument(metavar="SCENE", help="A scene file, the name of a shipped scene, or a recording.")
_BODIES = typer.Option(show_default=False, metavar="A B", help="The two bodies; needed unless the scene has just two.")
_STEP = typer.Option(min=0, max=10_000_000, metavar="N", help="Look at it after this many steps.")
_ALL = typer.Option("--all", help="Every axis, also those after the first gap, and where each comes from.")
_SVG = typer.Option("--svg", show_default=False, metavar="FILE", help="Also draw it into this SVG file.")
_FIGURE = typer.Option(
    show_default=False,
    metavar="NAME",
    help="What to draw: whole (the default), edges, perpendiculars, dot, parts, tilt, axis, mtv, clipping or scene.",
)
_AXIS = typer.Option(
    min=1, show_default=False, metavar="N", help="The axis for --figure axis or dot; default: the deciding one."
)
_STEPS = typer.Option("--step-by-step", help="Tell the test step by step, down to the contact points.")


@dataclass(frozen=True)
class SatOptions:
    """What `sandbox sat` was asked for."""

    scene: Annotated[Path, _SCENE]
    bodies: Annotated[tuple[str, str] | None, _BODIES] = None
    step: Annotated[int, _STEP] = 0
    all_axes: Annotated[bool, _ALL] = False
    json: Annotated[bool, JSON] = False
    svg: Annotated[Path | None, _SVG] = None
    figure: Annotated[str | None, _FIGURE] = None
    axis: Annotated[int | None, _AXIS] = None
    step_by_step: Annotated[bool, _STEPS] = False
    set: Annotated[list[str] | None, SET] = None


@takes(SatOptions)
def sat(options: SatOptions) -> None:
    """Show the separating-axis test of two bodies, axis by axis.

    Each row is an axis: how far the two shapes reach along it, and whether that leaves a gap. The first gap ends the
    test.
    """
    _check_options(options)
    from sandbox.cli.sat_pair import pair_in
    from sandbox.geometry.sat_table import sat_table

    pair = pair_in(find_scene(options.scene), options.bodies, options.step, values_set(options.set))
    table = sat_table(pair.a, pair.b, options.all_axes)
    svg, axis = options.svg, options.axis
    if svg is not None:
        _draw(pair, table, svg, options.figure or ("whole" if axis is None else "axis"), axis)
    _tell(pair, table, options)
    if svg is not None and not options.json:
        typer.echo(f"{svg}: {svg.stat().st_size / 1000:.0f} kB")


def _check_options(options: SatOptions) -> None:
    svg, figure, axis = options.svg, options.figure, options.axis
    if options.json and options.step_by_step:
        raise SandboxError("--step-by-step tells it in words, --json gives the data: give one of the two")
    if svg is None and (figure, axis) != (None, None):
        raise SandboxError(f"{'--axis' if figure is None else '--figure'} chooses what --svg FILE draws: give both")
    if axis is not None and figure not in (None, "axis", "dot"):
        raise SandboxError(f"--axis is for --figure axis or dot, not for --figure {figure}")
    if svg is not None:
        _check_picture(svg, figure, options.scene)


def _check_picture(svg: Path, figure: str | None, scene: Path) -> None:
    from sandbox.cli.picture_options import writable_picture
    from sandbox.render.sat_figure import FIGURES
    from sandbox.scene.near_names import did_you_mean

    writable_picture(svg, {".svg"}, [scene])
    if figure is not None and figure not in FIGURES:
        hint = did_you_mean(figure, FIGURES) or f"there are {', '.join(FIGURES)}"
        raise SandboxError(f"--figure {figure}: no figure of that name; {hint}")


def _draw(pair: SatPair, table: SatTable, svg: Path, figure: str, axis: int | None) -> None:
    from sandbox.geometry.sat_table import sat_table
    from sandbox.render.sat_figure import FIGURES
    from sandbox.render.sat_labels import shortened
    from sandbox.render.sat_page import SatFigure

    if axis is not None and axis > table.axis_count:
        raise SandboxError(f"--axis {axis}: these two shapes have {table.axis_count} axes")
    row = sat_table(pair.a, pair.b, all_axes=True).rows[axis - 1] if axis else None
    scene_shapes = _scene_shapes(pair.world) if figure == "scene" else ()
    wholes = _wholes(pair) if figure == "parts" else ()
    names = shortened(pair.names[0], _NAME), shortened(pair.names[1], _NAME)
    FIGURES[figure](SatFigure(table, names, row, scene_shapes, wholes)).save(svg)


def _scene_shapes(world: World) -> tuple[Member, ...]:
    """All shapes of the scene. Raises `SandboxError` if they are too many for a picture."""
    from sandbox.render.sat_page import Member

    count = len(world.state.shapes)
    if count > _MOST_SHAPES:
        raise SandboxError(f"--figure scene: {count} shapes are too many for a picture, at most {_MOST_SHAPES}")
    bodies = [(i, body.type == "dynamic", body.shapes) for i, body in enumerate(map(world.body, world.names))]
    return tuple(Member(shape, i, moves) for i, moves, shapes in bodies for shape in shapes)


def _wholes(pair: SatPair) -> tuple[Whole, ...]:
    """Both bodies as wholes. Raises `SandboxError` if their shapes make too many pairs for a picture."""
    from sandbox.cli.sat_whole import whole

    count = pair.counts[0] * pair.counts[1]
    if count > _MOST_SHAPES:
        raise SandboxError(
            f"--figure parts: {count} pairs of shapes are too many for a picture, at most {_MOST_SHAPES}"
        )
    return tuple(whole(pair.world, name) for name in pair.names)


def _tell(pair: SatPair, table: SatTable, options: SatOptions) -> None:
    if options.json:
        from sandbox.cli.sat_data import facts

        print_document(facts(pair, table))
        return
    if options.step_by_step:
        from sandbox.cli.sat_steps import explanation

        lines = explanation(pair, table)
    else:
        from sandbox.cli.sat_text import report

        lines = report(pair, table, options.all_axes)
    for line in lines:
        typer.echo(line)
