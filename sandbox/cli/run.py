"""`sandbox run`: a scene in a window."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from sandbox.cli.options import WORKERS
from sandbox.resources import find_scene

_SCENE = typer.Argument(
    show_default=False,
    help="A scene file, the name of a shipped scene, or a recording; of two recordings the second is what is expected.",
)
_SIZE = typer.Option(
    metavar="WxH", show_default=False, help="Size of the window in pixels; default 1280x800, or as it was left."
)
_STEP = typer.Option(min=0, max=10_000_000, help="Start after this many steps.")
_FRAMES = typer.Option(min=1, show_default=False, help="Quit after this many pictures, with one physics step for each.")
_SCRIPT = typer.Option(show_default=False, help="Do what this file of keys and clicks says, then quit.")
_SCREENSHOT = typer.Option(show_default=False, help="Write the last picture to this PNG file.")


def run(
    scene: Annotated[list[Path] | None, _SCENE] = None,
    size: Annotated[str | None, _SIZE] = None,
    step: Annotated[int, _STEP] = 0,
    frames: Annotated[int | None, _FRAMES] = None,
    screenshot: Annotated[Path | None, _SCREENSHOT] = None,
    script: Annotated[Path | None, _SCRIPT] = None,
    workers: Annotated[int, WORKERS] = 1,
) -> None:
    """Open a scene in a window; without a scene, choose one from a list.

    Space pauses, Left rewinds, Ctrl+Z undoes; the tools at the left throw, draw, join and erase. F1 shows all keys.
    S saves all that was done since the start as a recording in this folder.
    """
    from sandbox.cli.picture_options import parse_size, writable_picture

    pixels = parse_size(size) if size is not None else None
    if screenshot is not None:
        writable_picture(screenshot, {".png"})
    from sandbox.scene.read import check_readable

    paths = [find_scene(path) for path in scene or ()]
    for path in paths:
        check_readable(path)  # before there is a window, which would close again at once
    if len(paths) > 1:
        _check_two_recordings(paths)
    from sandbox.window.requirements import check_packages

    check_packages()
    from sandbox.window.options import Options
    from sandbox.window.start import run_window

    first, other = (*paths, None, None)[:2]
    run_window(Options(first, pixels, step, frames, screenshot, workers, script, other))


def _check_two_recordings(paths: list[Path]) -> None:
    from sandbox._printable import told
    from sandbox.errors import SandboxError
    from sandbox.replay.recording.limits import SUFFIX

    if len(paths) > 2:
        raise SandboxError(f"{len(paths)} files: give one, or two recordings of which the second is what is expected")
    for path in paths:
        if not path.name.endswith(SUFFIX):
            raise SandboxError(
                f"{told(path)} is no recording (*{SUFFIX}): two files are compared if both are recordings"
            )
