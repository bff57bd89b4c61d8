"""How files of other programs are read: options that commands share, and what is told of such a file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from sandbox._printable import printable, told

if TYPE_CHECKING:
    from sandbox.formats import Imported

UNITS = typer.Option(
    "--units-per-metre", min=1e-6, max=1e9, metavar="N", show_default=False,
    help="How many units of the file make a metre; default: 32 pixels, in a map a tile's height.",
)  # fmt: skip


def tell(path: Path, imported: Imported) -> None:
    """A line on stderr for each thing that is not carried over."""
    from sandbox.formats import remark_lines

    for line in remark_lines(imported.remarks):
        typer.echo(f"{told(path)}: {printable(line)}", err=True)


def remark_data(imported: Imported) -> list[dict[str, Any]]:
    """The remarks as plain data."""
    return [remark._asdict() for remark in imported.remarks]
