"""A world that is led through what another revision did: it takes commands as always, and its tables from a trace."""

from __future__ import annotations

from typing import Any

from sandbox.errors import SandboxError
from sandbox.replay.golden.run import Run, RunStepper
from sandbox.replay.revisions.trace import Trace, TraceSamples
from sandbox.world.joint_records import JOINT
from sandbox.world.records import CONTACT

_COLUMNS = {
    "bodies": (
        "type", "awake", "frozen_step", "position_x", "position_y", "center_x", "center_y", "angle", "rotation_cos",
        "rotation_sin", "velocity_x", "velocity_y", "angular_velocity", "mass", "inertia", "gravity_scale",
    ),
    "contacts": ("touching", "point_count", "separation1", "separation2"),
    "joints": tuple(name for name in JOINT.hashed_fields if name not in ("body_a", "body_b")),
}  # fmt: skip
"""What is needed to draw a moment and to take its figures."""


def film_samples(end: int, every: int) -> TraceSamples:
    """Every so many steps up to `end`, and the last one."""
    return TraceSamples(tuple(dict.fromkeys([*range(every, end + 1, every), end])), _COLUMNS)


class TracePlayback(RunStepper):
    """A stepper whose steps are those of `trace`; where that holds no tables, only the count goes on."""

    def __init__(self, run: Run, trace: Trace) -> None:
        super().__init__(run.scene, run.commands)
        self._trace = trace

    def advance(self) -> None:
        """Apply what is due and go on to the next moment. Raises `SandboxError` if other bodies are there."""
        self.apply_due()
        step = self.step + 1
        self.world.state.counters["step_count"][0] = step
        if f"{step}.bodies" not in self._trace.arrays:
            return
        if self._trace.names(step) != self.world.names:
            raise SandboxError("there are other bodies in the other revision from here on")
        self._take_tables(step)

    def _take_tables(self, step: int) -> None:
        """Take over the tables of a step."""
        state, arrays = self.world.state, self._trace.arrays
        for name in ("bodies", "joints"):
            _fill(getattr(state, name), arrays.get(f"{step}.{name}"))
        contacts = arrays.get(f"{step}.contacts")
        count = 0 if contacts is None else len(contacts)
        if count > len(state.contacts):
            state.contacts = CONTACT.zeros(count)
        _fill(state.contacts[:count], contacts)
        state.counters["contact_count"][0] = count


def _fill(rows: Any, found: Any) -> None:
    """Copy the columns that both have; those of a joint come only if there are as many."""
    if found is None or len(found) != len(rows):
        return
    for name in found.dtype.names:
        if name in rows.dtype.names:
            rows[name] = found[name]
