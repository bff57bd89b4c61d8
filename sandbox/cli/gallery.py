"""`sandbox gallery`: a page of scenes that plays them offline, or a sheet of their pictures."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from sandbox._atomic_write import check_writable
from sandbox._printable import told
from sandbox.cli.failures import NothingToDoError
from sandbox.cli.gallery_options import GalleryOptions
from sandbox.cli.options import takes
from sandbox.cli.output import check_not_source
from sandbox.errors import SandboxError
from sandbox.resources import SCENE_SUFFIX, files_below

if TYPE_CHECKING:
    from sandbox.scene.catalog import Entry

PAGES, SHEETS = (".html", ".htm"), (".png",)


@takes(GalleryOptions)
def gallery(options: GalleryOptions) -> None:
    """Make a page of scenes with pictures, a search, and a player that needs nothing else; or a sheet of pictures.

    A scene with a recording beside it is played as it was recorded. Themes are the names of folders.

    Exit code 0: it was written.
    Exit code 2: a scene could not be used (the others are shown), or the file cannot be written.
    Exit code 5: there was none to show.
    """
    suffix = options.output.suffix.lower()
    if suffix not in (*PAGES, *SHEETS):
        raise SandboxError(f"--output {told(options.output)}: the name must end in .html or .png")
    entries = _entries(options.folder)
    check_not_source(options.output, [entry.path for entry in entries])
    check_writable(options.output)
    from sandbox.cli.gallery_run import write_page, write_sheet

    raise typer.Exit((write_page if suffix in PAGES else write_sheet)(options, entries))


def _entries(folder: Path | None) -> Sequence[Entry]:
    from sandbox.scene.catalog import entry_of, shipped_entries

    if folder is None:
        return shipped_entries()
    if not os.path.isdir(folder):
        what = "it is no folder" if os.path.exists(folder) else "there is no such folder"
        raise SandboxError(f"{told(folder)}: {what}")
    files = files_below(folder, SCENE_SUFFIX)
    if not files:
        raise NothingToDoError(f"nothing to show: no *{SCENE_SUFFIX} in {told(folder)} or below")
    return [entry_of(file, file.parent.name if file.parent != folder else "") for file in files]
