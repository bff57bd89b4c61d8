"""`sandbox diff`: two runs side by side, and the first number in which they differ."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox.cli.document import JSON, print_document
from sandbox.cli.failures import FAILED, HOLDS
from sandbox.cli.options import SET, values_set

if TYPE_CHECKING:
    from sandbox.replay.golden.divergence import Divergence
    from sandbox.replay.golden.run import Run

_A = typer.Argument(metavar="A", show_default=False, help="A recording or a scene: what is expected.")
_B = typer.Argument(metavar="B", show_default=False, help="A recording or a scene: what is got.")


def diff(
    a: Annotated[Path, _A],
    b: Annotated[Path, _B],
    set: Annotated[list[str] | None, SET] = None,
    json: Annotated[bool, JSON] = False,
) -> None:
    """Run two recordings or scenes side by side and find the first step, body and number in which they differ.

    A scene beside a recording gets the recording's commands and steps, so that an edited scene can be held against
    the one that was recorded. --set puts values into B.

    Exit code 0: no difference.
    Exit code 1: there is one.
    Exit code 2: a file could not be used.
    """
    from sandbox.cli.compiling import announce_compilation

    one, two = _runs(a, b, values_set(set))
    announce_compilation()
    found = _find(one, two, f"{a.name}, {b.name}")
    _print_document(found, min(one.steps, two.steps)) if json else _print_lines(found, one, two)
    raise typer.Exit(HOLDS if found is None else FAILED)


def _runs(a: Path, b: Path, values: Mapping[str, Any]) -> tuple[Run, Run]:
    from sandbox.cli.opening import open_or_replay
    from sandbox.replay.golden.run import Run, run_of
    from sandbox.scene import Scene

    one, two = open_or_replay(a, {}), open_or_replay(b, values)
    if isinstance(one, Scene) and not isinstance(two, Scene):
        return Run(one, two.steps, two.commands), run_of(two)
    if isinstance(two, Scene) and not isinstance(one, Scene):
        return run_of(one), Run(two, one.steps, one.commands)
    return run_of(one), run_of(two)


def _find(one: Run, two: Run, name: str) -> Divergence | None:
    from rich.console import Console

    from sandbox.cli.progress import SceneProgress
    from sandbox.replay.golden.side_by_side import find_divergence

    with SceneProgress(Console(stderr=True), 1) as progress:
        progress.begin(name, min(one.steps, two.steps))
        return find_divergence(one, two, on_steps=progress.done)


def _print_lines(found: Divergence | None, one: Run, two: Run) -> None:
    steps = min(one.steps, two.steps)
    if found is None:
        print(f"no difference in {steps} steps")
    else:
        print("\n".join(found.lines()))
    if one.steps != two.steps:
        print(f"compared {steps} steps, for one has {one.steps} and the other {two.steps}")


def _print_document(found: Divergence | None, steps: int) -> None:
    from dataclasses import asdict

    facts = {"steps": steps, "divergence": None if found is None else asdict(found)}
    print_document(facts, HOLDS if found is None else FAILED)
