"""`sandbox bisect`: which commit of the engine made a recording go another way."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox.cli.document import JSON, print_document
from sandbox.cli.failures import FAILED, HOLDS, NOTHING
from sandbox.cli.options import SET, values_set

if TYPE_CHECKING:
    from sandbox.replay.revisions.bisect import Found
    from sandbox.replay.revisions.worktree import Commit

_FILE = typer.Argument(metavar="FILE", show_default=False, help="A recording or a scene.")
_GOOD = typer.Option(metavar="REV", show_default=False, help="A git revision of the engine that is right.")
_BAD = typer.Option(metavar="REV", help="A later one that is not.")
_ENGINE = typer.Option(
    metavar="FOLDER", show_default=False, help="A git checkout of the engine; default: the one that is running."
)
_NO_JIT = typer.Option("--no-jit", help="Run the kernels as plain Python: nothing is compiled; for small scenes.")


def bisect(
    file: Annotated[Path, _FILE],
    good: Annotated[str, _GOOD],
    bad: Annotated[str, _BAD] = "HEAD",
    engine: Annotated[Path | None, _ENGINE] = None,
    no_jit: Annotated[bool, _NO_JIT] = False,
    set: Annotated[list[str] | None, SET] = None,
    json: Annotated[bool, JSON] = False,
) -> None:
    """Find the commit from which on a recording goes another way than at the good revision, by halving.

    Each revision is checked out in a temporary work tree and runs in a process of its own, with the scene as it is
    now. Revisions that cannot run it are skipped and named.

    Exit code 0: the commit was found.
    Exit code 1: it is one of several, for some cannot run it.
    Exit code 2: a file or a revision could not be used.
    Exit code 5: good and bad go the same way.
    """
    from sandbox.cli.opening import open_or_replay
    from sandbox.replay.golden.run import run_of
    from sandbox.replay.revisions.worktree import Repository

    what = open_or_replay(file, values_set(set))
    run = run_of(what)
    repository = Repository(engine)
    ends = repository.commit(good), repository.commit(bad)
    found = _search(repository, run, ends, no_jit, getattr(what, "digests", ()))
    code = {0: NOTHING, 1: HOLDS}.get(len(found.suspects), FAILED)
    _print_document(found, ends, code) if json else _print_lines(found, ends)
    raise typer.Exit(code)


def _search(repository: Any, run: Any, ends: tuple[Commit, Commit], no_jit: bool, digests: tuple[str, ...]) -> Found:
    from rich.console import Console

    from sandbox.cli.progress import SceneProgress
    from sandbox.replay.revisions.bisect import bisect as search

    most: list[int] = []
    with SceneProgress(Console(stderr=True), 1, "commits ruled out") as progress:
        progress.begin("good and bad", None)

        def on_left(left: int) -> None:
            if not most:
                most.append(left)
                progress.begin("halving", left)
            progress.done(most[0] - left)

        return search(repository, run, *ends, no_jit, on_left, digests)


def _print_lines(found: Found, ends: tuple[Commit, Commit]) -> None:
    if not found.suspects:
        print(f"no difference: {ends[1]}\ngoes the same way as {ends[0]}")
        print(_both(found.good_parts), end="")
        return
    if found.good_parts:
        print(f"the good revision does not do what was recorded either, from step {found.good_parts} on;")
        print("what follows is held against what it does")
    head = "the first that goes another way:" if len(found.suspects) == 1 else "one of these is the first:"
    print("\n".join([head, *(f"  {commit}" for commit in found.suspects)]))
    if found.divergence is not None:
        print("\n".join(f"  {line}" for line in found.divergence.lines()))
    for one in found.skipped:
        print(f"skipped {one.commit}\n  {one.reason}")
    print(f"show it: git show {found.suspects[-1].hash[:12]}")


def _both(parts: int | None) -> str:
    """What both do, by the step after which they leave the recording."""
    if parts is None:
        return ""
    if parts == 0:
        return "both do what was recorded\n"
    return f"neither does what was recorded, from step {parts} on: look for an earlier good revision\n"


def _print_document(found: Found, ends: tuple[Commit, Commit], code: int) -> None:
    from dataclasses import asdict

    print_document({"good": asdict(ends[0]), "bad": asdict(ends[1]), **asdict(found)}, code)
