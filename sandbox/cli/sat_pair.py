"""Which two shapes `sandbox sat` looks at: two bodies of a scene at a step, and of each the shape that matters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sandbox.errors import SandboxError, UnknownBodyError

if TYPE_CHECKING:
    from sandbox.engine.world import World
    from sandbox.geometry.shapes import Shape
    from sandbox.replay.golden.run import RunStepper

_SHOW_EVERY = 16
"""Steps after which is shown how many are done."""


@dataclass(frozen=True)
class SatPair:
    """Two shapes and where they come from; `world` is at the step asked for; `numbers` count shapes from 1."""

    names: tuple[str, str]
    a: Shape
    b: Shape
    world: World
    numbers: tuple[int, int]
    counts: tuple[int, int]

    @property
    def note(self) -> str:
        """How the two shapes were chosen, where the bodies have several; else nothing."""
        if self.counts == (1, 1):
            return ""
        parts = [
            f"shape {number} of the {count} of {name}" if count > 1 else name
            for name, number, count in zip(self.names, self.numbers, self.counts, strict=True)
        ]
        return f"{parts[0]} and {parts[1]}: of all pairs of their shapes the deepest, or else the nearest one"


def pair_in(path: Path, bodies: tuple[str, str] | None, step: int, values: Mapping[str, Any] | None = None) -> SatPair:
    """The pair of a scene, with `values` set in it, or of a recording.

    Raises `SandboxError` if the bodies do not make one.
    """
    from sandbox.cli.running import run_in, telling_refusals
    from sandbox.replay.golden.run import RunStepper

    run = run_in(path, values or {}, step)
    stepper = RunStepper(run.scene, run.commands)
    names = bodies or _only_two(stepper.world)
    _check(stepper.world, names)
    if step:
        with telling_refusals(path):
            _advance(stepper, step, path.name)
    return chosen_pair(stepper.world, names)


def _advance(stepper: RunStepper, steps: int, name: str) -> None:
    from rich.console import Console

    from sandbox.cli.compiling import announce_compilation
    from sandbox.cli.progress import SceneProgress

    announce_compilation()
    with SceneProgress(Console(stderr=True), 1) as progress:
        progress.begin(name, steps)
        for done in range(steps):
            if done % _SHOW_EVERY == 0:
                progress.done(done)
            stepper.advance()


def chosen_pair(world: World, names: tuple[str, str]) -> SatPair:
    """The deepest pair of shapes of two bodies; if none overlaps, the nearest; the first of equals."""
    from sandbox.geometry.nearest_pair import nearest_pair

    shapes = world.body(names[0]).shapes, world.body(names[1]).shapes
    i, j = nearest_pair(*shapes)
    return SatPair(names, shapes[0][i], shapes[1][j], world, (i + 1, j + 1), (len(shapes[0]), len(shapes[1])))


def _only_two(world: World) -> tuple[str, str]:
    if len(world.names) == 2:
        return world.names[0], world.names[1]
    count = f"{len(world.names)} bodies" if len(world.names) != 1 else "one body"
    mend = "; name two of them: --bodies " + " ".join(world.names[:2]) if len(world.names) > 2 else ""
    raise SandboxError(f"this scene has {count}, and the test takes two{mend}")


def _check(world: World, names: tuple[str, str]) -> None:
    from sandbox.scene.near_names import did_you_mean

    for name in names:
        if name not in world.names:
            hint = (
                did_you_mean(name, world.names)
                or f"it has {', '.join(world.names[:5])}{' ...' * (len(world.names) > 5)}"
            )
            raise UnknownBodyError(f"--bodies: no body {name!r} in this scene; {hint}")
    if names[0] == names[1]:
        raise SandboxError(f"--bodies {names[0]} {names[1]}: a body does not collide with itself; name two")
