"""`sandbox import`: a file of another program as a scene."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from sandbox._printable import told
from sandbox.cli.document import JSON, print_document
from sandbox.cli.import_options import UNITS, remark_data, tell
from sandbox.cli.options import takes
from sandbox.cli.output import check_new

if TYPE_CHECKING:
    from sandbox.formats import Imported

_FILE = typer.Argument(metavar="FILE", help="A file of another program.")
_OUTPUT = typer.Option("-o", "--output", metavar="SCENE", show_default=False, help="Where to write the scene.")
_FORMAT = typer.Option(metavar="F", show_default=False, help="The format of the file; default: told from its contents.")
_TOLERANCE = typer.Option(min=1e-5, max=1.0, metavar="M", help="How far flat sides may lie from a curve, m.")
_SOLID = typer.Option(
    "--solid", metavar="LAYER", show_default=False, help="A layer of a map that is solid all over. Repeatable."
)
_FORCE = typer.Option("--force", help="Write over a file that is there.")


@dataclass(frozen=True)
class ImportOptions:
    """What `sandbox import` was asked for."""

    file: Annotated[Path, _FILE]
    output: Annotated[Path, _OUTPUT]
    format: Annotated[str, _FORMAT] = ""
    units_per_metre: Annotated[float | None, UNITS] = None
    tolerance: Annotated[float, _TOLERANCE] = 0.01
    solid: Annotated[list[str] | None, _SOLID] = None
    force: Annotated[bool, _FORCE] = False
    json: Annotated[bool, JSON] = False


@takes(ImportOptions)
def import_(options: ImportOptions) -> None:
    """Make a scene of a file of another program: R.U.B.E., planck.js, Tiled, Physics Body Editor, PhysicsEditor, SVG.

    What a scene cannot carry over is listed on stderr, with its place in the file.

    Exit code 0: it was written.
    Exit code 2: a file could not be used, or there is one of that name already.
    """
    from sandbox.formats import import_scene

    check_new(options.output, options.force, [options.file])
    given = options.format, options.units_per_metre, options.tolerance, options.solid or ()
    imported = import_scene(options.file, *given)
    imported.scene.save(options.output, over=options.force)
    _report(options, imported)


def _report(options: ImportOptions, imported: Imported) -> None:
    scene, output = imported.scene, options.output
    if options.json:
        facts = {"path": output.as_posix(), "file_format": imported.format, "bodies": len(scene.bodies)}
        print_document({**facts, "joints": len(scene.joints), "remarks": remark_data(imported)})
        return
    tell(options.file, imported)
    counted = ((scene.bodies, "body", "bodies"), (scene.joints, "joint", "joints"))
    bodies, joints = (f"{len(each)} {one if len(each) == 1 else more}" for each, one, more in counted)
    print(f"{told(output)}: {bodies}, {joints}, from a file in the format {imported.format}")
