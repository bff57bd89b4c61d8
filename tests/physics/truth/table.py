"""All experiments with all engines that are installed."""

from __future__ import annotations

from collections.abc import Iterable
from importlib.util import find_spec

from tests.physics.truth import (
    blows,
    bouncing,
    colliding,
    falling,
    floating,
    hanging,
    mirrors,
    ours,
    pressing,
    resting,
    rolling,
    sliding,
    swinging,
    tipping,
    with_pymunk,
)
from tests.physics.truth.experiment import Engine, Experiment, LacksError

EXPERIMENTS: tuple[Experiment, ...] = (
    falling.free_fall,
    falling.projectile,
    falling.spinning_body,
    *sliding.INCLINES,
    sliding.settling,
    sliding.creeping,
    resting.first_steps,
    sliding.up_and_stay,
    sliding.stopping,
    sliding.conveyor,
    rolling.rolling,
    rolling.slipping,
    rolling.begins_to_roll,
    rolling.rolls_on,
    rolling.error_grows,
    rolling.on_a_board,
    tipping.tipping,
    resting.box_rests,
    resting.stack_rests,
    resting.sway,
    bouncing.series,
    bouncing.perfect,
    colliding.head_on,
    colliding.oblique,
    colliding.rough,
    colliding.corner,
    colliding.rod_end,
    blows.rebound_from_pyramid,
    blows.pyramid_stays,
    blows.rebound_from_stack,
    blows.rebound_from_low,
    pressing.pressed,
    mirrors.discs,
    mirrors.one_box,
    mirrors.boxes,
    mirrors.lopsided,
    hanging.still,
    hanging.at_rest,
    *swinging.PERIODS,
    swinging.amplitude_kept,
    swinging.dumbbell,
    floating.floating,
)
"""Rows of the table, in its order."""

ROUNDING = 1e-12
"""Errors that differ by less than this are called equal."""

Row = dict[str, float | None]
"""Relative error by the name of the engine; None where it has not got what the experiment is about."""


def engines() -> dict[str, Engine]:
    """Engines by name, ours first; Box2D only where pyb2d3 is installed (the `bench` extra)."""
    found: dict[str, Engine] = {ours.NAME: ours.OurRun, with_pymunk.NAME: with_pymunk.PymunkRun}
    if find_spec("pyb2d3") is not None:
        from tests.physics.truth import with_box2d

        found[with_box2d.NAME] = with_box2d.Box2dRun
    return found


def measure(experiments: Iterable[Experiment] = EXPERIMENTS) -> dict[str, Row]:
    """The error of every engine in every experiment."""
    return {each.name: measure_one(each) for each in experiments}


def measure_one(experiment: Experiment) -> Row:
    """The error of every engine in one experiment."""
    return {name: _error(experiment, engine) for name, engine in engines().items()}


def _error(experiment: Experiment, engine: Engine) -> float | None:
    try:
        return experiment.measure(engine)
    except LacksError:
        return None


def is_best(error: float | None, row: Row) -> bool:
    """Whether nobody in the row is better by more than rounding."""
    return error is not None and error <= min(each for each in row.values() if each is not None) + ROUNDING


def head(each: Experiment) -> str:
    """The first two cells of an experiment's row."""
    return f"| {each.name} | {each.against} |"


def as_markdown(rows: dict[str, Row], experiments: Iterable[Experiment] = EXPERIMENTS) -> str:
    """The table for `sandbox/TRUTH.md`, the best of each row in bold."""
    names = list(engines())
    lines = ["| experiment | error of | " + " | ".join(names) + " |", "|---|---|" + "---|" * len(names)]
    for each in experiments:
        row = rows[each.name]
        cells = [_cell(row[name], is_best(row[name], row)) for name in names]
        lines.append(f"{head(each)} " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _cell(error: float | None, best: bool) -> str:
    if error is None:
        return "-"
    text = "0" if error < ROUNDING else f"{error:.1e}".replace("e-0", "e-").replace("e+00", "")
    return f"**{text}**" if best else text
