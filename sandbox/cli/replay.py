"""`sandbox replay`: run recordings again and compare."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperCommand

from sandbox.errors import SandboxError

if TYPE_CHECKING:
    from sandbox.replay.golden.examine import Demands

_PATHS = typer.Argument(metavar="PATH", help="Recordings, scenes, or folders to search for *.replay.json.")
_JOBS = typer.Option("-j", "--jobs", min=0, max=256, metavar="N", help="Processes at a time; 0: one a processor.")
_TOLERANCE = typer.Option(
    "--tolerance/--exact", help="Compare energies, counts and places within tolerances instead of bits."
)
_UPDATE = typer.Option(
    metavar="[missing|changed|all]",
    show_default=False,
    help="Write new recordings for scenes that lack one, for those that changed as well (the default), or for all.",
)
_PRUNE = typer.Option("--prune", help="Remove recordings whose scene is gone.")
_HEAVY = typer.Option("--heavy", help="Take every step from a restored snapshot as well, and compare.")
_NO_JIT = typer.Option("--no-jit", help="Run the kernels as plain Python: slow, and the same bits.")
_JSON = typer.Option("--json", help="Print one JSON document instead of the table.")
_JUNIT = typer.Option(metavar="FILE", show_default=False, help="Write a JUnit report as well.")
_REPORT = typer.Option(
    metavar="FILE.html", show_default=False, help="Write a page that shows what did not pass; it needs no server."
)
_LAST = typer.Option("--last-failed", help="Only those that failed the last time, here; all if none did.")
_SHARD = typer.Option(metavar="I/N", show_default=False, help="Only part I of N: every N-th file.")
_ONLY = typer.Option("-k", "--only", metavar="TEXT", show_default=False, help="Only files whose path contains TEXT.")
_AGAINST = typer.Option(
    metavar="REV", show_default=False, help="Hold them against what the engine did at a git revision, side by side."
)
_ENGINE = typer.Option(
    metavar="FOLDER", show_default=False, help="For --against: a git checkout of the engine, if it is not running."
)

UPDATES = ("missing", "changed", "all")


class CommandClass(TyperCommand):
    """`--update` stands for `--update=changed`."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Give a bare `--update` its value."""
        return super().parse_args(ctx, ["--update=changed" if arg == "--update" else arg for arg in args])


def replay(
    paths: Annotated[list[Path], _PATHS],
    jobs: Annotated[int, _JOBS] = 1,
    tolerance: Annotated[bool, _TOLERANCE] = False,
    update: Annotated[str, _UPDATE] = "",
    prune: Annotated[bool, _PRUNE] = False,
    heavy: Annotated[bool, _HEAVY] = False,
    no_jit: Annotated[bool, _NO_JIT] = False,
    json: Annotated[bool, _JSON] = False,
    junit: Annotated[Path | None, _JUNIT] = None,
    report: Annotated[Path | None, _REPORT] = None,
    last_failed: Annotated[bool, _LAST] = False,
    shard: Annotated[str, _SHARD] = "",
    only: Annotated[str, _ONLY] = "",
    against: Annotated[str, _AGAINST] = "",
    engine: Annotated[Path | None, _ENGINE] = None,
) -> None:
    """Run recordings again without a window and compare every step with what was recorded.

    passed: the same bits. diverged: other bits. stale: the scene was edited since. missing: a scene with expectations
    has no recording beside it. orphaned: the recording's scene is gone.

    Exit code 0: all passed, or were renewed as asked.
    Exit code 1: some did not.
    Exit code 2: a file or an option could not be used; the others still ran.
    Exit code 5: nothing was found to run.
    """
    demands = _demands(tolerance, heavy, update, prune)
    part = _part(shard)
    _check_report(report)
    if against and (tolerance or heavy or update or prune):
        raise SandboxError("--against: two revisions are compared bit for bit, and nothing is renewed")
    from sandbox.cli.replay_run import Work, run

    work = Work(tuple(paths), demands, jobs, no_jit, json, junit, last_failed, part, only, report, against, engine)
    raise typer.Exit(run(work))


def _demands(tolerance: bool, heavy: bool, update: str, prune: bool) -> Demands:
    if update and update not in UPDATES:
        raise SandboxError(f"--update={update}: there are {', '.join(UPDATES)}")
    if (update or prune) and os.environ.get("CI"):
        option = "--update" if update else "--prune"
        raise SandboxError(f"{option}: CI is set, and recordings are never written there; run it on your machine")
    from sandbox.replay.golden.examine import Demands
    from sandbox.replay.golden.tolerance import Tolerance

    return Demands(Tolerance() if tolerance else None, heavy, update, prune)  # type: ignore[arg-type]


def _check_report(path: Path | None) -> None:
    if path is None:
        return
    if path.suffix.lower() not in (".html", ".htm"):
        raise SandboxError(f"--report {path}: the name must end in .html")
    if not path.resolve().parent.is_dir():
        raise SandboxError(f"--report {path}: the folder {path.resolve().parent} does not exist")


def _part(text: str) -> tuple[int, int]:
    number, slash, count = text.partition("/")
    if not text:
        return 1, 1
    if not (slash and number.isdecimal() and count.isdecimal() and 1 <= int(number) <= int(count)):
        raise SandboxError(f"--shard={text}: write I/N, as in 1/4")
    return int(number), int(count)
