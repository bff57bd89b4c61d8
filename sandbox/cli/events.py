"""`sandbox events`: what happens in a scene, step by step: contacts, sensors, sleep."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox._printable import printable
from sandbox.cli.options import SET, values_set
from sandbox.errors import SandboxError
from sandbox.resources import find_scene

if TYPE_CHECKING:
    from sandbox.scene import Scene

_SCENE = typer.Argument(metavar="SCENE", help="A scene file, or the name of one that comes with the package.")
_STEPS = typer.Option(
    min=1, max=10_000_000, metavar="N", show_default=False, help="Steps to run instead of the scene's own number."
)
_KIND = typer.Option(
    "--kind", metavar="KIND", show_default=False,
    help="Only this kind (may be repeated): begin, end, hit, enter, leave, sleep, wake, freeze, joint_break; of "
    "what rules did: counter, spawn, delete, win, lose or refused.",
)  # fmt: skip
_BODY = typer.Option(
    "--body", metavar="ID", show_default=False, help='Only of bodies (or joints) with this id, or "crate-*".'
)
_JSON = typer.Option("--json", help="Print one JSON document instead of lines.")


def events(
    scene: Annotated[Path, _SCENE],
    steps: Annotated[int | None, _STEPS] = None,
    kind: Annotated[list[str] | None, _KIND] = None,
    body: Annotated[str | None, _BODY] = None,
    set: Annotated[list[str] | None, SET] = None,
    json: Annotated[bool, _JSON] = False,
) -> None:
    """Run a scene without a window and tell what happens in it.

    begin, end: two shapes touch, or have come apart. hit: they strike at 1 m/s or more. enter, leave: a sensor has, or
    no longer has, a body in it. sleep, wake: a body. freeze: bad numbers stopped a body. joint_break: a joint.
    What the rules of the scene did: counter, spawn, delete, win, lose; refused: an action that could not be done.

    Exit code 0: it ran.
    Exit code 2: the scene, or an option, could not be used.
    """
    kinds = _checked(kind or [])
    from sandbox.cli.compiling import announce_compilation
    from sandbox.cli.opening import open_any

    file = find_scene(scene)
    loaded = open_any(file, values_set(set))
    if body is not None:
        _check_body(body, loaded)
    announce_compilation()
    rows = (row for row in _happenings(loaded, file.name, steps) if _is_wanted(row, kinds, body))
    _print_document(file, rows) if json else _print_lines(rows, loaded.settings.step_rate)


def _checked(kinds: list[str]) -> list[str]:
    from sandbox.engine.events.events import KINDS

    for kind in kinds:
        if kind not in KINDS:
            raise SandboxError(f"there are no events of kind {kind!r}; there are {', '.join(KINDS)}")
    return kinds


def _check_body(wanted: str, scene: Scene) -> None:
    from sandbox.scene.near_names import did_you_mean

    flat = scene.flatten()
    names = [*(body.id for body in flat.bodies), *(joint.id for joint in flat.joints)]
    if not any(fnmatchcase(name, wanted) for name in names):
        hint = did_you_mean(wanted, names) or 'ids such as "crate-*" stand for several'
        raise SandboxError(f"--body: no body or joint {wanted!r} in this scene; {hint}")


def _is_wanted(row: dict[str, Any], kinds: list[str], body: str | None) -> bool:
    ids = [row[key] for key in ("a", "b", "sensor", "body", "joint") if key in row]
    return (not kinds or row["event"] in kinds) and (body is None or any(fnmatchcase(name, body) for name in ids))


def _happenings(scene: Scene, name: str, steps: int | None) -> Iterator[dict[str, Any]]:
    from rich.console import Console

    from sandbox.cli.progress import SceneProgress
    from sandbox.engine.world import World
    from sandbox.scene.duration import planned_steps

    total = planned_steps(scene, steps)
    world = World(scene)
    with SceneProgress(Console(stderr=True), 1) as progress:
        progress.begin(name, total)
        for step in range(1, total + 1):
            world.step()
            yield from world.events
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
    import json
    from collections import Counter

    found = list(rows)
    counts = Counter(row["event"] for row in found)
    print(json.dumps({"scene": file.as_posix(), "counts": counts, "events": found}, indent=2, ensure_ascii=False))
