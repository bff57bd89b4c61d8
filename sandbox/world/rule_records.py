"""The records of what rules and controls know: all of it, so that a snapshot goes on as the world would have.

Tables have rows only in scenes that use them.
"""

from __future__ import annotations

from sandbox.tables import COUNT, FLAG, STEP_OR_NEVER, Field, Table, Values, whole
from sandbox.world.bounds import PLACE, SHARE

OPEN, WON, LOST = 0, 1, 2

CONTROL = Table(
    "control",
    (
        Field("value", "1", "how far it is held, -1 to 1; 0 is let go", values=SHARE),
        Field("pointer_x", "m", "where the pointer is", values=PLACE),
        Field("pointer_y", "m", "where the pointer is", values=PLACE),
        whole("pressed", "1 from when it is pressed until the next step", FLAG),
        whole("released", "1 from when it is let go until the next step", FLAG),
    ),
)

TALLY = Table("tally", (Field("value", "1", "of a named counter"),))

RULE = Table(
    "rule",
    (
        whole("count", "how often it was followed", COUNT),
        whole("last_step", "step after which it was followed last; -1 if never", STEP_OR_NEVER),
    ),
)

SPAWNER = Table(
    "spawner",
    (
        whole("count", "the number that the last body of this name got", COUNT),
        whole("last_step", "step after which that came; -1 if never", STEP_OR_NEVER),
    ),
)
"""One row for each id that bodies get by which rules and controls bring them."""

SENSING = Table(
    "sensing",
    (
        whole("sensor_body", "index of the body that carries a sensor", Values(0, row_of="body")),
        whole("body", "index of a body that was in it after the last step", Values(0, row_of="body")),
    ),
)
"""What rules about sensors compare with, sorted."""

PATH = Table(
    "path",
    (
        whole("body", "index of the body that follows it", Values(0, row_of="body")),
        Field("origin_x", "m", "where the path counts from", values=PLACE),
        Field("origin_y", "m", "where the path counts from", values=PLACE),
        Field("origin_angle", "rad", "what its angles count from", values=PLACE),
        whole("steps", "steps that it has gone on for", COUNT),
        whole("enabled", "1 while it goes on", FLAG),
    ),
)

OUTCOME = Table(
    "outcome",
    (
        whole("result", "0 open, 1 won, 2 lost", Values(OPEN, LOST)),
        whole("text", "number of the text, in the order of the scene", COUNT),
        whole("step", "after which step; -1 while it is open", STEP_OR_NEVER),
    ),
)
"""One row in scenes with rules, counters or controls."""
