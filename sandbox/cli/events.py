"""`sandbox events`: what happens in a scene or a recording, step by step: contacts, sensors, sleep."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox._printable import printable
from sandbox.cli.document import JSON, print_document
from sandbox.cli.options import SET, values_set
from sandbox.errors import SandboxError
from sandbox.resources import find_scene

if TYPE_CHECKING:
    from sandbox.replay.golden.run import Run

_SCENE = typer.Argument(metavar="SCENE", help="A scene file, the name of a shipped scene, or a recording.")
_STEPS = typer.Option(
    min=1, max=10_000_000, metavar="N", show_default=False, help="Steps to run instead of its own number."
)
_KIND = typer.Option(
    "--kind", metavar="KIND", show_default=False,
    help="Only this kind (may be repeated): begin, end, hit, enter, leave, sleep, wake, freeze, joint_break; of "
    "what rules did: counter, spawn, delete, win, lose or refused.",
)  # fmt: skip
_BODY = typer.Option(
    "--body", metavar="ID", show_default=False, help='Only of bodies (or joints) with this id, or "crate-*".'
)


def events(
    scene: Annotated[Path, _SCENE],
    steps: Annotated[int | None, _STEPS] = None,
    kind: Annotated[list[str] | None, _KIND] = None,
    body: Annotated[str | None, _BODY] = None,
    set: Annotated[list[str] | None, SET] = None,
    json: Annotated[bool, JSON] = False,
) -> None:
    """Run a scene, or a recording with its commands, without a window and tell what happens in it.

    begin, end: two shapes touch, or have come apart. hit: they strike at 1 m/s or more. enter, leave: a sensor has, or
    no longer has, a body in it. sleep, wake: a body. freeze: bad numbers stopped a body. joint_break: a joint.
    What the rules of the scene did: counter, spawn, delete, win, lose; refused: an action that could not be done.

    Exit code 0: it ran.
    Exit code 2: the scene, or an option, could not be used.
    """
    kinds = _checked(kind or [])
    from sandbox.cli.compiling import announce_compilation
    from sandbox.cli.running import run_in, telling_refusals

    file = find_scene(scene)
    run = run_in(file, values_set(set), steps)
    if body is not None:
        from sandbox.cli.event_names import check_name

        check_name(body, run)
    announce_compilation()
    rows = (row for row in _happenings(run, file.name) if _is_wanted(row, kinds, body))
    with telling_refusals(file):
        _print_document(file, rows) if json else _print_lines(rows, run.scene.settings.step_rate)


def _checked(kinds: list[str]) -> list[str]:
    from sandbox.engine.events.events import KINDS

    for kind in kinds:
        if kind not in KINDS:
            raise SandboxError(f"there are no events of kind {kind!r}; there are {', '.join(KINDS)}")
    return kinds


def _is_wanted(row: dict[str, Any], kinds: list[str], body: str | None) -> bool:
    ids = [row[key] for key in ("a", "b", "sensor", "body", "joint") if key in row]
    return (not kinds or row["event"] in kinds) and (body is None or any(fnmatchcase(name, body) for name in ids))


def _happenings(run: Run, name: str) -> Iterator[dict[str, Any]]:
    from rich.console import Console

    from sandbox.cli.progress import SceneProgress
    from sandbox.replay.golden.run import RunStepper

    stepper = RunStepper(run.scene, run.commands)
    with SceneProgress(Console(stderr=True), 1) as progress:
        progress.begin(name, run.steps)
        for step in range(1, run.steps + 1):
            stepper.advance()
            yield from stepper.world.events
            if step % 16 == 0:
                progress.done(step)


def _print_lines(rows: Iterator[dict[str, Any]], rate: float) -> None:
    count = 0
    for row in rows:
        print(f"{row['step']:>6} {row['step'] / rate:>8.3f} s  {row['event']:<11} {_words(row)}")
        count += 1
    print(f"{count} events" if count != 1 else "1 event")


def _words(row: dict[str, Any]) -> str:
    if "sensor" in row:
        return (
            f"{row['body']} in {row['sensor']}" if row["event"] == "enter" else f"{row['body']} out of {row['sensor']}"
        )
    if "text" in row or "counter" in row:
        text = f"{row['counter']} {row['value']:g}" if "counter" in row else row["text"]
        return printable(f"{text} ({row['by']})" if "by" in row else text)
    if "body" in row or "joint" in row:
        return str(row.get("body") or row["joint"])
    text = f"{row['a']} and {row['b']}"
    if row["event"] == "end":
        return text
    x, y = row["point"]
    return f"{text} at ({x:.3f}, {y:.3f}), {row['speed']:.3g} m/s, {row['impulse']:.3g} N s"


def _print_document(file: Path, rows: Iterator[dict[str, Any]]) -> None:
    from collections import Counter

    found = list(rows)
    counts = Counter(row["event"] for row in found)
    print_document({"scene": file.as_posix(), "counts": counts, "events": found})
