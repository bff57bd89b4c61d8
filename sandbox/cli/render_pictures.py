"""The pictures and films of `sandbox render`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sandbox._printable import told
from sandbox.cli.options import values_set
from sandbox.cli.render_options import FILM_SIZE, STILL_SIZE, RenderOptions, steps_asked_for, style_of
from sandbox.errors import SandboxError
from sandbox.replay.recording.known_recording import holds_recording

if TYPE_CHECKING:
    from sandbox.cli.picture_progress import PictureProgress
    from sandbox.render.shots import Shooting
    from sandbox.replay.golden.run import Run, RunStepper

FILM_STEPS = 300


def run_to_show(path: Path, given: Sequence[str] | None = None) -> Run:
    """What a scene, with what `--set` options say, or a recording does. Raises `SandboxError`."""
    from sandbox.cli.opening import open_or_replay
    from sandbox.replay.golden.run import run_of

    return run_of(open_or_replay(path, values_set(given)))


def write_still(options: RenderOptions, suffix: str) -> None:
    """One picture. Raises `SandboxError` and `OSError`."""
    from sandbox._atomic_write import write_text
    from sandbox.cli.picture_options import parse_size
    from sandbox.cli.picture_progress import PictureProgress
    from sandbox.render.image import save_png
    from sandbox.render.shots import still
    from sandbox.render.surface_painter import SurfacePainter
    from sandbox.render.svg_painter import svg_picture

    if options.range is not None or options.steps is not None or options.fps is not None:
        raise SandboxError(f"--range, --steps and --fps are for films; a {suffix[1:]} shows one step: --step N")
    size = parse_size(options.size or STILL_SIZE)
    stepper, shooting = _begin(options, size, 0)
    with PictureProgress() as progress:
        _skip(stepper, options.step, progress, shooting)
        picture = shooting.draw_list(still(stepper, shooting))
        if suffix == ".svg":
            write_text(options.output, svg_picture(picture, getattr(stepper.world.scene, "title", "")))
        else:
            save_png(SurfacePainter().paint(picture), options.output)
    _tell(options, size, stepper, 1)


def write_film(options: RenderOptions, suffix: str) -> None:
    """A film. Raises `SandboxError`, `MissingDependencyError` and `OSError`."""
    from sandbox.cli.picture_options import parse_size
    from sandbox.cli.picture_progress import PictureProgress
    from sandbox.render.film_file import FASTEST_GIF, GIF_FPS, VIDEO_FPS, save_film
    from sandbox.render.video import check_video

    gif = suffix == ".gif"
    fps = options.fps or (GIF_FPS if gif else VIDEO_FPS)
    if gif and fps > FASTEST_GIF:
        raise SandboxError(f"--fps {fps:g}: a GIF shows at most {FASTEST_GIF:g} pictures a second; a video more")
    if not gif:
        check_video(suffix)
    size = parse_size(options.size or FILM_SIZE)
    first, steps = steps_asked_for(options)
    stepper, shooting = _begin(options, size, first)
    steps = _length(options, stepper, first, steps)
    with PictureProgress() as progress:
        _skip(stepper, first, progress, shooting)
        count = save_film(stepper, shooting, steps, options.output, fps, progress)
    _tell(options, size, stepper, count)


def _begin(options: RenderOptions, size: tuple[int, int], first: int) -> tuple[RunStepper, Shooting]:
    """The run at its start and who takes pictures of it."""
    from sandbox.cli.compiling import announce_compilation
    from sandbox.render.shots import Shooting
    from sandbox.replay.golden.run import RunStepper

    run = run_to_show(options.scene, options.set)
    last = max(options.step, first)
    if _is_recording(options) and last > run.steps:
        raise SandboxError(f"step {last}: {told(options.scene)} has {run.steps} steps")
    stepper = RunStepper(run.scene, run.commands)
    shooting = Shooting(stepper.world, style_of(options, size, stepper.world.names))
    announce_compilation()
    return stepper, shooting


def _length(options: RenderOptions, stepper: RunStepper, first: int, steps: int | None) -> int:
    """How many steps a film shows: of a recording as many as there are."""
    if not _is_recording(options):
        return steps or FILM_STEPS
    left = run_to_show(options.scene, options.set).steps - first
    if steps is not None and steps > left:
        raise SandboxError(f"step {first + steps}: {told(options.scene)} has {first + left} steps")
    if left == 0:
        raise SandboxError(f"step {first}: {told(options.scene)} ends there, and a film needs steps")
    return steps or left


def _is_recording(options: RenderOptions) -> bool:
    return holds_recording(options.scene)


def _skip(stepper: RunStepper, steps: int, progress: PictureProgress, shooting: Shooting) -> None:
    """Take steps that nobody sees; trails begin in them."""
    for _ in progress.count("simulating", range(steps)):
        stepper.advance()
        shooting.note(stepper.world)


def _tell(options: RenderOptions, size: tuple[int, int], stepper: RunStepper, pictures: int) -> None:
    import json

    world, output = stepper.world, options.output
    facts: dict[str, Any] = {
        "file": str(output),
        "bytes": output.stat().st_size,
        "width": size[0],
        "height": size[1],
        "pictures": pictures,
        "step": world.step_count,
        "digest": world.digest(),
    }
    if options.json:
        print(json.dumps(facts, indent=2))
    else:
        what = f"{pictures} pictures" if pictures > 1 else "a picture"
        kilobytes = facts["bytes"] / 1000
        print(f"{told(output)}: {what}, {size[0]}x{size[1]}, {kilobytes:.0f} kB, at step {world.step_count}")
