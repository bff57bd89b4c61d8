"""Stage: positions from velocities, four bodies side by side."""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox._vectors import WIDTH, Number, absolute, any_lane, select
from sandbox.engine.bodies.integrate import SOLVED, Velocity
from sandbox.engine.records.bodies import BODY_FORCES, FREE_Y, POSE, START, VELOCITY, SolverBodies
from sandbox.engine.records.gather_fields import Rows, gather_fields, rows_from, scatter_fields
from sandbox.engine.records.workers import Workers
from sandbox.engine.workers.parallel_for import first_part, next_part
from sandbox.engine.workers.task_kinds import GRAVITY, IMPACTS, INTEGRATE_POSITIONS, SECONDS, UNITS
from sandbox.geometry.trig import cos_sin_lanes
from sandbox.tables import Integers

STRAIGHT = 0.01
"""Sine of the angle between change and velocity up to which a body starts or stops in a straight line: then the mean
velocity holds also where all of the velocity is new."""
FROM_REST = 1.001
"""What starts from rest changes by just its velocity, of which rounding is not to choose whether it changes by more."""
UNTOUCHED = 1e-9
"""Velocity (m/s) up to which what contacts have given and taken back again counts as nothing: it is rounding."""
_ANGULAR_DECAY = BODY_FORCES.run("angular_decay", "extent", "moves", "by_end")
"""Numbers of fields, from which on four are read at once."""


class Scale(NamedTuple):
    """What is gentle: no more than the strength of gravity (m/s^2) does; and how many units of length a metre is."""

    gravity: float
    units_per_meter: float


@kernel
def integrate_positions(
    active_bodies: Integers, solver: SolverBodies, scale: Scale, seconds: float, late_impacts: bool, workers: Workers
) -> None:
    """Move by the velocity the solver left, with all workers, as `integrate_some_positions` does."""
    workers.numbers[SECONDS] = seconds
    workers.numbers[GRAVITY] = scale.gravity
    workers.numbers[UNITS] = scale.units_per_meter
    workers.numbers[IMPACTS] = 1.0 if late_impacts else 0.0
    first, end = first_part(workers, INTEGRATE_POSITIONS, 0, active_bodies.shape[0])
    while first < end:
        integrate_some_positions(active_bodies[first:end], solver, scale, seconds, late_impacts)
        first, end = next_part(workers, first, end)


@kernel
def integrate_some_positions(
    rows: Integers, solver: SolverBodies, scale: Scale, seconds: float, late_impacts: bool
) -> None:
    """Move bodies by the velocity the solver left; one that nothing touched moves by the mean of both ends.

    The mean is exact under constant acceleration, so free flight follows the parabola to rounding. A body in
    contact keeps the direction of its end velocity, which is what the solver made safe, but where it is only slowed
    or sped up, by no more than forces do (`scale.gravity` is the measure), it moves by the mean velocity along it.
    What joints hold moves by the end velocity (`forces.by_end`).
    Before `late_impacts`, what the solver moves notes the velocity it has.
    """
    for k in range(0, rows.shape[0], WIDTH):
        _integrate_four(rows_from(rows, k), solver, scale, seconds, late_impacts)


@inlined_kernel
def _integrate_four(rows: Rows, solver: SolverBodies, scale: Scale, seconds: float, late_impacts: bool) -> None:
    vx, vy, w, x = gather_fields(solver.motions, rows, VELOCITY)
    y, cosine, sine, angle = gather_fields(solver.motions, rows, POSE)
    start_x, start_y, start_w, free_x = gather_fields(solver.free_motions, rows, START)
    free_y, free_w, level, buoyed = gather_fields(solver.free_motions, rows, FREE_Y)
    _, extent, moves, by_end = gather_fields(solver.forces, rows, _ANGULAR_DECAY)
    start = Velocity(start_x, start_y, start_w)
    mean = mean_velocity(start, Velocity(free_x, free_y, free_w), Velocity(vx, vy, w), extent, seconds, scale)
    solved = moves == SOLVED
    by_mean = solved & (by_end == 0.0)
    moving = moves > 0.0
    x = select(moving, x + seconds * select(by_mean, mean.x, vx), x)
    y = select(moving, y + seconds * select(by_mean, mean.y, vy), y)
    after = select(moving, angle + seconds * select(by_mean, mean.w, w), angle)
    turned = after != angle
    if any_lane(turned):
        new_cosine, new_sine = cos_sin_lanes(after)
        cosine = select(turned, new_cosine, cosine)
        sine = select(turned, new_sine, sine)
    scatter_fields(solver.motions, rows, VELOCITY, (vx, vy, w, x), 0, WIDTH)
    scatter_fields(solver.motions, rows, POSE, (y, cosine, sine, after), 0, WIDTH)
    if late_impacts:
        first = (select(solved, vx, start_x), select(solved, vy, start_y), select(solved, w, start_w))
        noted = select(solved, vx, free_x), select(solved, vy, free_y), select(solved, w, free_w)
        scatter_fields(solver.free_motions, rows, START, (first[0], first[1], first[2], noted[0]), 0, WIDTH)
        scatter_fields(solver.free_motions, rows, FREE_Y, (noted[1], noted[2], level, buoyed), 0, WIDTH)


@inlined_kernel
def mean_velocity(
    start: Velocity, free: Velocity, end: Velocity, extent: Number, seconds: float, scale: Scale
) -> Velocity:
    """The velocity by which bodies move in a substep that have `end` in the end, and would have `free` if nothing
    touched them."""
    gentle = 4.0 * seconds * scale.gravity  # change (m/s) up to which they are only slowed or sped up
    turns = absolute(end.w - free.w)
    untouched = (
        absolute(end.x - free.x) + absolute(end.y - free.y) + extent * turns <= UNTOUCHED * scale.units_per_meter
    )
    share = _mean_share(start.x - end.x, start.y - end.y, end.x, end.y, gentle)
    change = start.w - end.w
    gently = (absolute(change) * extent <= gentle) & (absolute(change) <= 0.5 * absolute(end.w))
    return Velocity(
        select(untouched, 0.5 * (start.x + end.x), end.x * share),
        select(untouched, 0.5 * (start.y + end.y), end.y * share),
        select(untouched, 0.5 * (start.w + end.w), select(gently, end.w + 0.5 * change, end.w)),
    )


@inlined_kernel
def _mean_share(change_x: Number, change_y: Number, vx: Number, vy: Number, gentle: float) -> Number:
    """Factor that turns the end velocity into the mean velocity along it; 1 after a change that is not gentle."""
    change = change_x * change_x + change_y * change_y
    square = vx * vx + vy * vy
    harsh = (change > gentle * gentle) | (change > FROM_REST * square) | (square == 0.0)
    turns = change_x * vy - change_y * vx
    bends = (change > 0.25 * square) & (turns * turns > STRAIGHT * STRAIGHT * change * square)
    share = 1.0 + 0.5 * (change_x * vx + change_y * vy) / select(square == 0.0, 1.0, square)
    return select(harsh | bends, 1.0, share)
