"""`sandbox export`: a scene as a file of another program."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from sandbox._atomic_write import write_text
from sandbox._printable import printable, told
from sandbox.cli.document import JSON, print_document
from sandbox.cli.opening import open_any
from sandbox.cli.options import SET, takes, values_set
from sandbox.cli.output import check_new, check_not_source
from sandbox.errors import SandboxError
from sandbox.resources import SCENE_SUFFIX, find_scene

_SCENE = typer.Argument(metavar="SCENE", help="A scene, the name of a shipped one, or a file that `import` takes.")
_OUTPUT = typer.Option(
    "-o", "--output", metavar="FILE", show_default=False, help=".json: a world of planck.js; .py: a pymunk program."
)
_FORCE = typer.Option("--force", help="Write over a file that is there.")


@dataclass(frozen=True)
class ExportOptions:
    """What `sandbox export` was asked for."""

    scene: Annotated[Path, _SCENE]
    output: Annotated[Path, _OUTPUT]
    force: Annotated[bool, _FORCE] = False
    set: Annotated[list[str] | None, SET] = None
    json: Annotated[bool, JSON] = False


@takes(ExportOptions)
def export(options: ExportOptions) -> None:
    """Write a scene as a file of another program: a world of planck.js, or a Python program that uses pymunk.

    What such a file cannot carry over is listed on stderr, with the ids of the scene.

    Exit code 0: it was written.
    Exit code 2: a file could not be used, or there is one of that name already.
    """
    from sandbox.formats import export_scene, remark_lines

    name = _format_of(options.output)
    file = find_scene(options.scene)
    check_new(options.output, options.force, [file])
    scene = open_any(file, values_set(options.set))
    check_not_source(options.output, scene.included_files)
    exported = export_scene(scene, name)
    write_text(options.output, exported.text, over=options.force)
    if options.json:
        facts = {"path": options.output.as_posix(), "file_format": name}
        print_document({**facts, "remarks": [each._asdict() for each in exported.remarks]})
        return
    for line in remark_lines(exported.remarks):
        typer.echo(f"{told(options.output)}: {printable(line)}", err=True)
    print(f"{told(options.output)}: written in the format {name}")


def _format_of(output: Path) -> str:
    from sandbox.formats import TARGETS

    if output.name.endswith(SCENE_SUFFIX):
        raise SandboxError(f"{told(output)}: *{SCENE_SUFFIX} are scenes; a world of planck.js is named otherwise")
    if output.suffix.lower() in (".svg", ".png", ".html"):
        raise SandboxError(f"{told(output)}: pictures and pages are made by sandbox render")
    found = next((each.name for each in TARGETS if each.ending == output.suffix.lower()), None)
    if found is None:
        raise SandboxError(f"{told(output)}: the name must end in .json (planck.js) or .py (pymunk)")
    return found
