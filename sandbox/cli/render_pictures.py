"""The pictures and films of `sandbox render`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from sandbox._printable import told
from sandbox.cli.document import print_document
from sandbox.cli.options import values_set
from sandbox.cli.render_options import FILM_SIZE, STILL_SIZE, RenderOptions, steps_asked_for, style_of
from sandbox.cli.running import run_in
from sandbox.errors import SandboxError
from sandbox.replay.recording.known_recording import holds_recording

if TYPE_CHECKING:
    from sandbox.cli.picture_progress import PictureProgress
    from sandbox.render.shots import Shooting
    from sandbox.replay.golden.run import RunStepper

FILM_STEPS = 300


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
    stepper, shooting, _ = _begin(options, size, options.step)
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
    stepper, shooting, end = _begin(options, size, _last(options, first, steps))
    _check_left(options, first, end)
    with PictureProgress() as progress:
        _skip(stepper, first, progress, shooting)
        count = save_film(stepper, shooting, end - first, options.output, fps, progress)
    _tell(options, size, stepper, count)


def _begin(options: RenderOptions, size: tuple[int, int], last: int | None) -> tuple[RunStepper, Shooting, int]:
    """The run at its start, who takes pictures of it, and its last step, which is `last` or where it ends by itself."""
    from sandbox.cli.compiling import announce_compilation
    from sandbox.render.shots import Shooting
    from sandbox.replay.golden.run import RunStepper

    run = run_in(options.scene, values_set(options.set), last)
    stepper = RunStepper(run.scene, run.commands)
    shooting = Shooting(stepper.world, style_of(options, size, stepper.world.names))
    announce_compilation()
    return stepper, shooting, run.steps


def _last(options: RenderOptions, first: int, steps: int | None) -> int | None:
    """The step to which a film goes; None for as many as a recording has."""
    if steps is None and holds_recording(options.scene):
        return None
    return first + (steps or FILM_STEPS)


def _check_left(options: RenderOptions, first: int, end: int) -> None:
    """Raises `SandboxError` where a recording has nothing left to be filmed."""
    if first > end:
        raise SandboxError(f"step {first}: {told(options.scene)} has {end} steps")
    if first == end:
        raise SandboxError(f"step {first}: {told(options.scene)} ends there, and a film needs steps")


def _skip(stepper: RunStepper, steps: int, progress: PictureProgress, shooting: Shooting) -> None:
    """Take steps that nobody sees; trails begin in them."""
    for _ in progress.count("simulating", range(steps)):
        stepper.advance()
        shooting.note(stepper.world)


def _tell(options: RenderOptions, size: tuple[int, int], stepper: RunStepper, pictures: int) -> None:
    world, output = stepper.world, options.output
    facts: dict[str, Any] = {
        "path": output.as_posix(),
        "bytes": output.stat().st_size,
        "width": size[0],
        "height": size[1],
        "pictures": pictures,
        "step": world.step_count,
        "digest": world.digest(),
    }
    if options.json:
        print_document(facts)
    else:
        what = f"{pictures} pictures" if pictures > 1 else "a picture"
        kilobytes = facts["bytes"] / 1000
        print(f"{told(output)}: {what}, {size[0]}x{size[1]}, {kilobytes:.0f} kB, at step {world.step_count}")
