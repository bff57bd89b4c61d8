"""How commands run what they are given without a window: a scene by itself, a recording with its commands."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sandbox._printable import told
from sandbox.errors import RefusedCommandError, SandboxError

if TYPE_CHECKING:
    from sandbox.replay.golden.run import Run


def run_in(path: Path, values: Mapping[str, Any], steps: int | None = None) -> Run:
    """What a recording does, or a scene with `values`, to its own end or in the first `steps` steps.

    Raises `FileError`, and `SandboxError` where a recording has not so many: what came then, nobody knows.
    """
    from sandbox.cli.opening import open_or_replay
    from sandbox.replay.golden.run import run_of
    from sandbox.scene import Scene

    what = open_or_replay(path, values)
    run = run_of(what)
    if steps is None:
        return run
    if steps > run.steps and not isinstance(what, Scene):
        raise SandboxError(f"step {steps}: {told(path)} has {run.steps} steps")
    return replace(run, steps=steps)


@contextmanager
def telling_refusals(path: Path) -> Iterator[None]:
    """Say at which place of a recording the command stands that is refused when its step comes."""
    try:
        yield
    except RefusedCommandError as error:
        from sandbox.replay.recording.command_file import refused_in

        raise refused_in(path, error) from None
