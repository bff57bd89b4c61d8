"""`sandbox run`: a scene in a window."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import typer

from sandbox.cli.options import SET, WORKERS, takes, values_set
from sandbox.resources import find_scene

_SCENE = typer.Argument(
    metavar="SCENE",
    show_default=False,
    help="A scene file, the name of a shipped scene, or a recording; of two recordings the second is what is expected.",
)
_SIZE = typer.Option(
    metavar="WxH", show_default=False, help="Size of the window in pixels; default 1280x800, or as it was left."
)
_STEP = typer.Option(min=0, max=10_000_000, metavar="N", help="Start after this many steps.")
_FRAMES = typer.Option(
    min=1, metavar="N", show_default=False, help="Quit after this many pictures, with one physics step for each."
)
_SCRIPT = typer.Option(metavar="FILE", show_default=False, help="Do what this file of keys and clicks says, then quit.")
_SCREENSHOT = typer.Option(metavar="FILE.png", show_default=False, help="Write the last picture there.")


@dataclass(frozen=True)
class RunOptions:
    """What `sandbox run` was asked for."""

    scene: Annotated[list[Path] | None, _SCENE] = None
    size: Annotated[str | None, _SIZE] = None
    step: Annotated[int, _STEP] = 0
    frames: Annotated[int | None, _FRAMES] = None
    screenshot: Annotated[Path | None, _SCREENSHOT] = None
    script: Annotated[Path | None, _SCRIPT] = None
    workers: Annotated[int, WORKERS] = 1
    set: Annotated[list[str] | None, SET] = None


@takes(RunOptions)
def run(options: RunOptions) -> None:
    """Open a scene in a window; without a scene, choose one from a list.

    Space pauses, Left rewinds, Ctrl+Z undoes; the tools at the left throw, draw, join and erase. F1 shows all keys.
    S saves all that was done since the start as a recording in this folder.
    """
    from sandbox.cli.picture_options import parse_size, writable_picture

    pixels = parse_size(options.size) if options.size is not None else None
    paths = [find_scene(path) for path in options.scene or ()]
    if options.screenshot is not None:
        writable_picture(options.screenshot, {".png"}, paths)
    for path in paths:
        _check_readable(path)  # before there is a window, which would close again at once
    if len(paths) > 1:
        _check_two_recordings(paths)
    values = values_set(options.set)
    _check_values(paths, values)
    from sandbox.window.requirements import check_packages

    check_packages()
    from sandbox.window.options import Options
    from sandbox.window.start import run_window

    first, other = (*paths, None, None)[:2]
    seen = Options(
        first, pixels, options.step, options.frames, options.screenshot, options.workers, options.script, other, values
    )
    run_window(seen)


def _check_readable(path: Path) -> None:
    """Raises `SceneError` where no file can be read. The models of scenes, which know what to say then, take longer
    to be imported than a window takes to open.
    """
    from sandbox._bounded_read import read_bytes

    try:
        read_bytes(path, 0)
    except (OSError, ValueError):
        from sandbox.scene.read import check_readable

        check_readable(path)


def _check_values(paths: list[Path], values: dict[str, Any]) -> None:
    """Values are for one scene, and wrong ones are told here rather than in a window."""
    from sandbox.errors import SandboxError

    if values and not paths:
        raise SandboxError("--set is for a scene: name one")
    if values:
        from sandbox.cli.opening import open_or_replay

        for path in paths:
            open_or_replay(path, values)


def _check_two_recordings(paths: list[Path]) -> None:
    from sandbox._printable import told
    from sandbox.errors import SandboxError
    from sandbox.replay.recording.known_recording import holds_recording
    from sandbox.replay.recording.limits import SUFFIX

    if len(paths) > 2:
        raise SandboxError(f"{len(paths)} files: give one, or two recordings of which the second is what is expected")
    for path in paths:
        if not holds_recording(path):
            raise SandboxError(
                f"{told(path)} is no recording (*{SUFFIX}): two files are compared if both are recordings"
            )
