"""Two runs, laid side by side: the first step, body and number in which they differ, and how that grew."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import islice

import numpy as np

from sandbox.arguments import check_callback
from sandbox.engine.world import World
from sandbox.errors import CommandError, RefusedCommandError, SandboxError
from sandbox.replay.golden.differences import differences, first_group
from sandbox.replay.golden.divergence import Divergence, Growth
from sandbox.replay.golden.run import Run, RunStepper, run_of
from sandbox.replay.recording.fingerprint import fingerprint, first_difference
from sandbox.replay.recording.recording import Recording
from sandbox.scene import Scene

COUNTED = 10_000
"""Differing numbers counted at most."""


def find_divergence(
    expected: Run | Recording | Scene,
    got: Run | Recording | Scene,
    *,
    on_steps: Callable[[int], None] | None = None,
) -> Divergence | None:
    """Run both, step by step, and find the first difference; None if there is none in the steps that both have.

    Step 0 is the world as it was built. Commands count as part of the step that follows them. `growth` looks at 1, 2,
    4, 8, ... steps after the first and at the end. Raises `SceneError` if a scene cannot be used, `CommandError` if
    both runs refuse the same command, and `ArgumentError`.
    """
    one, two = run_of(expected, "find_divergence"), run_of(got, "find_divergence")
    check_callback("find_divergence", on_steps)
    a, b = RunStepper(one.scene, one.commands), RunStepper(two.scene, two.commands)
    steps = min(one.steps, two.steps)
    group = first_group(a.world, b.world)
    while group is None and a.step < steps:
        refused = _advance(a, b)
        if refused is not None:
            return refused
        if first_difference(fingerprint(a.world.state), fingerprint(b.world.state)) or a.step == steps:
            group = first_group(a.world, b.world)
        if on_steps is not None:
            on_steps(a.step)
    return None if group is None else _divergence(group, a, b, steps)


def compare_after(expected: Run, got: Run, parted: Divergence) -> Divergence:
    """The same divergence with the number that differs first after its step, and how it grew, if that shows there.

    Raises `CommandError` if both runs refuse the same command before.
    """
    a, b = RunStepper(expected.scene, expected.commands), RunStepper(got.scene, got.commands)
    while a.step < parted.step:
        if _advance(a, b) is not None:
            return parted
    found = list(islice(differences(parted.group, a.world, b.world), COUNTED))
    if not found:
        return parted
    growth = _growth(a, b, min(expected.steps, got.steps))
    return replace(parted, detail=found[0], others=len(found) - 1, growth=growth)


def _divergence(group: str, a: RunStepper, b: RunStepper, steps: int) -> Divergence:
    found = list(islice(differences(group, a.world, b.world), COUNTED))
    step, time, detail = a.step, a.world.time, found[0]
    expected, got = (fingerprint(stepper.world.state) for stepper in (a, b))
    parts = first_difference(expected, got)
    shown = parts[1:] if parts and parts[0] == group else (a.world.digest(), b.world.digest())
    return Divergence(step, time, group, *shown, detail, len(found) - 1, _growth(a, b, steps))


def _growth(a: RunStepper, b: RunStepper, steps: int) -> tuple[Growth, ...]:
    start, ahead, rows = a.step, 0, []
    while True:
        rows.append(Growth(a.step, *farthest(a.world, b.world)))
        if a.step >= steps:
            return tuple(rows)
        ahead = 2 * ahead or 1
        while a.step < min(start + ahead, steps):
            if _advance(a, b) is not None:
                return tuple(rows)


def farthest(a: World, b: World) -> tuple[str, float]:
    """The body whose positions are farthest apart, of those that both worlds have, and that distance (m)."""
    rows = {name: row for row, name in enumerate(b.names)}
    both = [(i, rows[name]) for i, name in enumerate(a.names) if name in rows]
    if not both:
        return "", 0.0
    ours, theirs = (np.array(column) for column in zip(*both, strict=True))
    one, two = a.state.bodies, b.state.bodies
    away = np.hypot(one.position_x[ours] - two.position_x[theirs], one.position_y[ours] - two.position_y[theirs])
    worst = int(np.argmax(away))
    return a.names[ours[worst]], float(away[worst])


def _advance(a: RunStepper, b: RunStepper) -> Divergence | None:
    """Take a step in both; where a command is refused in one only, that is where they part."""
    step, time = a.step, a.world.time
    refusals = [_try(stepper) for stepper in (a, b)]
    if refusals[0] == refusals[1]:
        if refusals[0]:
            raise CommandError(f"both runs refuse a command after step {step}: {refusals[0]}")
        return None
    words = [text or "the commands of this step can be applied" for text in refusals]
    return Divergence(step, time, "command", words[0], words[1])


def _try(stepper: RunStepper) -> str:
    try:
        stepper.advance()
    except RefusedCommandError as error:  # its index may differ, for one run may have other commands before
        return f"{error.command}: {error.reason}"
    except SandboxError as error:
        return str(error)
    return ""
