"""How files of other programs are read: options that commands share, and what is told of such a file."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sandbox._printable import printable, told
from sandbox.resources import SCENE_SUFFIX

if TYPE_CHECKING:
    from sandbox.formats import Imported
    from sandbox.scene import Scene

UNITS = typer.Option(
    "--units-per-metre", min=1e-6, max=1e9, metavar="N", show_default=False,
    help="How many units of the file make a metre; default: 32 pixels, in a map a tile's height.",
)  # fmt: skip


def open_any(path: Path, values: Mapping[str, Any] | None = None) -> Scene:
    """The scene in a file, with `values` as `load_scene` takes them.

    Of another program's file what it does not carry over is told on stderr.
    """
    from sandbox.scene import load_scene

    if path.name.endswith(SCENE_SUFFIX):
        return load_scene(path, values)
    from sandbox.formats import open_scene

    imported = open_scene(path, values)
    tell(path, imported)
    return imported.scene


def tell(path: Path, imported: Imported) -> None:
    """A line on stderr for each thing that is not carried over."""
    from sandbox.formats import remark_lines

    for line in remark_lines(imported.remarks):
        typer.echo(f"{told(path)}: {printable(line)}", err=True)


def remark_data(imported: Imported) -> list[dict[str, Any]]:
    """The remarks as plain data."""
    return [remark._asdict() for remark in imported.remarks]
