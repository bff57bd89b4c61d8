"""What the step keeps of every body while it solves: velocities, forces, flags and colours."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Integers, Records, Table
from sandbox.world.records import BODY

INVERSE_MASS = BODY.run("inverse_mass", "inverse_inertia", "force_x", "force_y")
TORQUE = BODY.run("torque", "linear_damping", "angular_damping", "gravity_scale")
"""Of a row of the state's bodies, what is read at once."""

MOTION = Table(
    "motion",
    (
        Field("velocity_x", "m/s", "what the solver works on"),
        Field("velocity_y", "m/s", "what the solver works on"),
        Field("angular_velocity", "rad/s", "what the solver works on"),
        Field("delta_x", "m", "displacement of the centre since the step began"),
        Field("delta_y", "m", "displacement of the centre since the step began"),
        Field("delta_cos", "1", "rotation since the step began"),
        Field("delta_sin", "1", "rotation since the step began"),
        Field("delta_angle", "rad", "rotation since the step began"),
    ),
)
"""One row a body, one cache line: all that the solver gathers and scatters. A last one is that of the world, at rest:
some joints hold bodies to it."""
VELOCITY = MOTION.run("velocity_x", "velocity_y", "angular_velocity", "delta_x")
POSE = MOTION.run("delta_y", "delta_cos", "delta_sin", "delta_angle")
"""Either half of such a row, which is read at once."""

IMPACT_VELOCITIES = (
    Field("start_x", "m/s", "velocity when the substep began"),
    Field("start_y", "m/s", "velocity when the substep began"),
    Field("start_w", "rad/s", "velocity when the substep began"),
    Field("free_x", "m/s", "velocity at its end if nothing touches the body"),
    Field("free_y", "m/s", "velocity at its end if nothing touches the body"),
    Field("free_w", "rad/s", "velocity at its end if nothing touches the body"),
)
"""What an impact changes of a body."""

FREE_MOTION = Table(
    "free_motion",
    (
        *IMPACT_VELOCITIES,
        Field("substep_level", "-", "its island takes 2**substep_level times the substeps of the scene", "i8"),
        Field("buoyed", "-", "1 when it floats at rest", "i8"),
    ),
)
"""One row a body: where an unhindered body would go, and how its island is solved."""
START = FREE_MOTION.run("start_x", "start_y", "start_w", "free_x")
FREE_Y = FREE_MOTION.run("free_y", "free_w", "substep_level", "buoyed")
"""Either half of such a row."""

BODY_FORCES = Table(
    "body_forces",
    (
        Field("change_x", "m/s", "what gravity and forces add to the velocity in a substep"),
        Field("change_y", "m/s", "the same"),
        Field("change_w", "rad/s", "what torques add to it"),
        Field("linear_decay", "1", "share of the velocity that damping leaves"),
        Field("angular_decay", "1", "share of the angular velocity that damping leaves"),
        Field("extent", "m", "that of the body"),
        Field("moves", "-", "1 when the solver moves it, 2 when it is kinematic, 0 for the others"),
        Field("by_end", "-", "not 0 when it moves by the velocity at the end of a substep, as its joints count on"),
    ),
)
"""One row a body, one cache line: all that the substeps ask of the body itself; floats, which vectors can hold."""


VELOCITY_PART = Table(
    "velocity_part",
    (
        Field("velocity_x", "m/s", "what contacts have given of the velocity, or all else"),
        Field("velocity_y", "m/s", "the same"),
        Field("angular_velocity", "rad/s", "the same"),
        Field("spare", "-", "no row lies in two cache lines"),
    ),
)
"""One row a body: one of the two parts of its velocity in a substep, see `velocity_parts`."""

IMPACT_BODY = Table(
    "impact_body",
    (
        *IMPACT_VELOCITIES,
        Field("moment", "s", "when the earliest of its contacts closes, of those that close in a turn"),
        Field("closing", "-", "how many of its contacts close in the turn", "i8"),
    ),
)
"""One row a body, one cache line: the velocities that one that has struck had before the impacts of the substep, as
those that do not end one by one are taken back; and which of them comes first (`restitution/earliest.py`)."""


class SolverBodies(NamedTuple):
    """Scratch memory with a row for each body, and one more of motions, beside the body table of the state.

    `parts` holds one of the two parts of each velocity (`contact_solver/velocity_parts.py`), `flags` the bits of
    `bodies/flags.py`, `colors` the colours that the contacts of a body have, `first_impact` the first of the contacts
    of a dynamic body that may have an impact, if there are any (`restitution/worklist.py`), `struck` whether it has had
    one, and in which turn or group (`restitution/groups.py`), `islands` the lowest row of its island where that is
    known, `batches` which batch that is in (0 for what does not move), `ccd` what continuous collision asks of bodies.
    """

    motions: Records
    free_motions: Records
    forces: Records
    impact_bodies: Records
    parts: Records
    flags: Integers
    colors: Integers
    first_impact: Integers
    struck: Integers
    islands: Integers
    batches: Integers
    ccd: Records
