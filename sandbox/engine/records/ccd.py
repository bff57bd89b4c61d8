"""What continuous collision keeps of bodies, and the sweep under way."""

from __future__ import annotations

from typing import NamedTuple

from sandbox.tables import Field, Integers, Records, Table

OVERLAPS = 1
NEW = 2
"""It touches something that it was not even near to a step before."""
STRUCK = 4
"""A hard impact without restitution reaches it."""

CCD_BODY = Table(
    "ccd_body",
    (
        Field("thin", "m", "half the smallest width of its thinnest shape"),
        Field("deep", "-", "1 when it overlaps something immovable more than a little", "i8"),
        Field("unsettled", "-", "bits: `OVERLAPS` something deeply, touches a `NEW` body, is `STRUCK`", "i8"),
        Field("struck_x", "m/s", "of the velocity that the impact gives it, if it is `STRUCK`"),
        Field("struck_y", "m/s", "of that velocity"),
        Field("struck_mass", "kg", "of it and what comes along with it"),
        Field("fast", "-", "1 when it has to be swept along its displacement", "i8"),
        Field("may_stop", "-", "1 while it is told to its shapes that something may stop it during the step", "i8"),
    ),
)
"""One row a body: what continuous collision asks of it. By itself, as most steps hardly look at it."""

CCD_IMPACT = Table(
    "ccd_impact",
    (
        Field("time", "1", "time of impact, as a share of the step; 1 is none"),
        Field("stopped", "-", "look at a bullet's pair that stopped one of the two; -1 is none", "i8"),
        Field("bounces", "-", "1 when what stops it bounces it", "i8"),
        Field("touched", "-", "1 when it has touched what stops it from the start of the step on", "i8"),
        Field("round", "-", "when its sweep is to be made: 0, or the one after that in which it slid along", "i8"),
        Field("listed", "-", "1 when it is in the list of those that something may stop", "i8"),
        Field("other", "-", "the static body that stops it", "i8"),
        Field("normal_x", "1", "of what stops it, towards the body"),
        Field("normal_y", "1", "of what stops it, towards the body"),
        Field("arm_x", "m", "where it is stopped, from the centre of the body"),
        Field("arm_y", "m", "where it is stopped, from the centre of the body"),
        Field("restitution", "1", "of the body and what stops it"),
        Field("friction", "1", "of the body and what stops it"),
        Field("surface_speed", "m/s", "of the body and what stops it"),
    ),
)
"""One row a body: where it is stopped in mid-step."""


class Ccd(NamedTuple):
    """Memory of continuous collision, beside `SolverBodies.ccd`.

    `hit[1:]` are the rows of the bodies whose impacts say anything, `hit[0]` is how many those are. `boxes` has a row
    for each shape: of strays, that of their true displacement. `sweep` has one row, `posed` the cores as they lie at
    the time looked at.
    """

    impacts: Records
    hit: Integers
    boxes: Records
    sweep: Records
    posed: Records
    manifold: Records
