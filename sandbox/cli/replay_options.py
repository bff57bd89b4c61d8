"""The options of `sandbox replay`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from sandbox.cli.document import JSON
from sandbox.cli.pool import JOBS

_PATHS = typer.Argument(metavar="PATH", help="Recordings, scenes, or folders to search for *.replay.json.")
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
_JUNIT = typer.Option(metavar="FILE.xml", show_default=False, help="Write a JUnit report as well.")
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


@dataclass(frozen=True)
class ReplayOptions:
    """What `sandbox replay` was asked for."""

    paths: Annotated[list[Path], _PATHS]
    jobs: Annotated[int, JOBS] = 1
    tolerance: Annotated[bool, _TOLERANCE] = False
    update: Annotated[str, _UPDATE] = ""
    prune: Annotated[bool, _PRUNE] = False
    heavy: Annotated[bool, _HEAVY] = False
    no_jit: Annotated[bool, _NO_JIT] = False
    json: Annotated[bool, JSON] = False
    junit: Annotated[Path | None, _JUNIT] = None
    report: Annotated[Path | None, _REPORT] = None
    last_failed: Annotated[bool, _LAST] = False
    shard: Annotated[str, _SHARD] = ""
    only: Annotated[str, _ONLY] = ""
    against: Annotated[str, _AGAINST] = ""
    engine: Annotated[Path | None, _ENGINE] = None
