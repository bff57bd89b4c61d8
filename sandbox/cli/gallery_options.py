"""The options of `sandbox gallery`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from sandbox.cli.document import JSON
from sandbox.cli.pool import JOBS
from sandbox.resources import SCENE_SUFFIX

_FOLDER = typer.Argument(
    metavar="FOLDER", show_default=False,
    help=f"Where to search for *{SCENE_SUFFIX}; without it, the scenes that come with the package.",
)  # fmt: skip
_OUTPUT = typer.Option(
    "-o", "--output", metavar="FILE", show_default=False, help="A page (.html), or a sheet of pictures (.png)."
)
_TITLE = typer.Option(metavar="TEXT", help="Headline of the page.")


@dataclass(frozen=True)
class GalleryOptions:
    """What `sandbox gallery` was asked for."""

    output: Annotated[Path, _OUTPUT]
    folder: Annotated[Path | None, _FOLDER] = None
    title: Annotated[str, _TITLE] = "Scenes"
    jobs: Annotated[int, JOBS] = 1
    json: Annotated[bool, JSON] = False
