"""The options of `sandbox check`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from sandbox.cli.document import JSON
from sandbox.cli.options import SET, WORKERS
from sandbox.cli.pool import JOBS
from sandbox.resources import SCENE_SUFFIX

_PATHS = typer.Argument(metavar="PATH", help=f"Scene files, or folders to search for *{SCENE_SUFFIX}.")
_STEPS = typer.Option(
    min=1,
    max=10_000_000,
    metavar="N",
    show_default=False,
    help="Steps to run instead of a scene's own number.",
)
_ONLY = typer.Option("-k", "--only", metavar="TEXT", show_default=False, help="Only files whose path contains TEXT.")
_REQUIRE = typer.Option("--require-expect", help="A scene that expects nothing fails.")
_JUNIT = typer.Option(metavar="FILE.xml", show_default=False, help="Write a JUnit report as well.")


@dataclass(frozen=True)
class CheckOptions:
    """What `sandbox check` was asked for."""

    paths: Annotated[list[Path], _PATHS]
    steps: Annotated[int | None, _STEPS] = None
    only: Annotated[str, _ONLY] = ""
    require_expect: Annotated[bool, _REQUIRE] = False
    jobs: Annotated[int, JOBS] = 1
    workers: Annotated[int, WORKERS] = 1
    set: Annotated[list[str] | None, SET] = None
    json: Annotated[bool, JSON] = False
    junit: Annotated[Path | None, _JUNIT] = None
