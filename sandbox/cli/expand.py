"""`sandbox expand`: a scene with every body and joint written out."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from sandbox.cli.options import SET, values_set
from sandbox.cli.output import FORCE, OUTPUT, check_new, check_not_source, put
from sandbox.resources import find_scene

_SCENE = typer.Argument(metavar="SCENE", help="A scene file, or the name of one that comes with the package.")


def expand(
    scene: Annotated[Path, _SCENE],
    output: Annotated[Path | None, OUTPUT] = None,
    force: Annotated[bool, FORCE] = False,
    set: Annotated[list[str] | None, SET] = None,
) -> None:
    """Print what a scene comes down to: every body and joint that prefabs and generators make, written out.

    The scene that is printed runs to the same bits. What refers to it by a path, such as $schema, stays as it is.

    Exit code 0: it was written.
    Exit code 2: the scene could not be used, or there is a file of that name already.
    """
    file = find_scene(scene)
    if output is not None:
        check_new(output, force, [file])
    from sandbox.cli.opening import open_any
    from sandbox.scene.pretty import scene_text
    from sandbox.scene.write_out import written_out

    opened = open_any(file, values_set(set))
    if output is not None:
        check_not_source(output, opened.included_files)
    put(scene_text(written_out(opened)), output, over=force)
