"""Events as rows of one table: numbers only, with the ids looked up when they are shown."""

from __future__ import annotations

from typing import Any

import numpy as np

from sandbox.engine.events.events import KINDS, Events
from sandbox.engine.events.happening import HAPPENINGS

NOBODY = -1
STEP_KINDS = tuple(kind for kind in KINDS if kind not in HAPPENINGS)
ROW = np.dtype(
    [("step", "i8"), ("kind", "i8"), ("a", "i8"), ("b", "i8"), ("x", "f8"), ("y", "f8"), ("speed", "f8"),
     ("impulse", "f8")]
)  # fmt: skip
"""`kind` is a place in `KINDS`; `a` and `b` are rows of bodies, or `a` that of a joint or of what rules told."""


def rows_of(events: Events) -> Any:
    """All events of a step."""
    return np.concatenate([*(_of_kind(events, kind) for kind in STEP_KINDS), _of_rules(events)])


def sorts_of(kinds: Any) -> tuple[Any, Any, Any]:
    """Which rows speak of bodies, which of a joint, and which tell what a rule did."""
    of_joint, of_rule = kinds == KINDS.index("joint_break"), kinds >= len(STEP_KINDS)
    return ~(of_joint | of_rule), of_joint, of_rule


def told_by_rules(events: Events) -> tuple[str, ...]:
    """What rules and controls did in a step: figures and ids by name."""
    return tuple(
        "  ".join(f"{name} {value}" for name, value in happening.plain().items()) for happening in events.happenings
    )


def _of_rules(events: Events) -> Any:
    """What rules and controls did, as rows of the table that number what was told."""
    rows = np.zeros(len(events.happenings), ROW)
    rows["step"], rows["a"], rows["b"] = events.step, np.arange(len(rows)), NOBODY
    rows["kind"] = [KINDS.index(happening.event) for happening in events.happenings]
    rows["x"] = rows["y"] = np.nan
    return rows


def _of_kind(events: Events, kind: str) -> Any:
    """The events of one kind as rows of the table."""
    found: Any = getattr(events, kind)
    rows = np.zeros(len(found), ROW)
    rows["step"], rows["kind"], rows["b"] = events.step, KINDS.index(kind), NOBODY
    rows["x"] = rows["y"] = np.nan
    names = found.dtype.names
    if names is None:
        rows["a"] = found
    elif "sensor" in names:
        rows["a"], rows["b"] = found["sensor_body"], found["body"]
    else:
        for column, source in (("a", "body_a"), ("b", "body_b"), ("x", "x"), ("y", "y")):
            rows[column] = found[source]
        rows["speed"], rows["impulse"] = found["speed"], found["impulse"]
    return rows
