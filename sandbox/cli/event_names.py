"""Of which bodies and joints `sandbox events` can tell: those of the scene, and those that come while it runs."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase
from typing import Any

from sandbox.engine.commands.spawn import Spawn
from sandbox.errors import SandboxError
from sandbox.replay.golden.run import Run
from sandbox.scene import Scene
from sandbox.scene.near_names import did_you_mean
from sandbox.world.build_rules import spawned_names


def check_name(wanted: str, run: Run) -> None:
    """Raises `SandboxError` if no body and no joint of the run can have this id, or match this pattern."""
    flat = run.scene.flatten() if isinstance(run.scene, Scene) else run.scene
    names = [*(body.id for body in flat.bodies), *(joint.id for joint in flat.joints), *_named_by_commands(run)]
    coming = spawned_names(flat)  # they are called ID-1, ID-2, ...
    names += [f"{name}-1" for name in coming]
    if wanted.rpartition("-")[0] in coming or any(fnmatchcase(name, wanted) for name in names):
        return
    hint = did_you_mean(wanted, names) or 'ids such as "crate-*" stand for several'
    raise SandboxError(f"--body: no body or joint {wanted!r} in this scene; {hint}")


def _named_by_commands(run: Run) -> Iterator[str]:
    for _, command in run.commands:
        if isinstance(command, Spawn):
            yield from (str(entry["id"]) for entry in _entries(command) if "id" in entry)


def _entries(command: Spawn) -> Iterator[dict[str, Any]]:
    for given in (command.bodies, command.joints):
        yield from [given] if isinstance(given, dict) else given
