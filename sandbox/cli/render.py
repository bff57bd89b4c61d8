"""`sandbox render`: a scene as a PNG picture, a GIF film or a page that plays it, without a display and OpenGL."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox._atomic_write import write_text
from sandbox._printable import told
from sandbox.errors import SandboxError
from sandbox.resources import find_scene

if TYPE_CHECKING:
    from sandbox.engine.world import World
    from sandbox.replay.golden.run import Run
    from sandbox.report.film import Film

SUFFIXES = (".png", ".gif", ".html")
STILL_SIZE, FILM_SIZE = "1280x800", "640x400"
FILM_STEPS = 300

_SCENE = typer.Argument(help="A scene file, or the name of a shipped scene; for a page, a recording as well.")
_OUTPUT = typer.Option("-o", "--output", help="The file to write: NAME.png, NAME.gif or NAME.html.")
_STEP = typer.Option(min=0, max=10_000_000, help="Steps to take before the picture, or before the film begins.")
_STEPS = typer.Option(
    min=1, max=100_000, show_default=False, help="Length of a film in steps; default 300, of a page the whole run."
)
_FPS = typer.Option(min=1.0, max=50.0, help="Pictures a second in a film.")
_SIZE = typer.Option(
    metavar="WxH", show_default=False, help=f"Pixels; default {STILL_SIZE} for PNG, {FILM_SIZE} for GIF."
)
_JSON = typer.Option("--json", help="Print what was written as JSON.")


def render(
    scene: Annotated[Path, _SCENE],
    output: Annotated[Path, _OUTPUT],
    step: Annotated[int, _STEP] = 0,
    steps: Annotated[int | None, _STEPS] = None,
    fps: Annotated[float, _FPS] = 25.0,
    size: Annotated[str | None, _SIZE] = None,
    json: Annotated[bool, _JSON] = False,
) -> None:
    """Draw a scene into a PNG picture, a GIF film, or an HTML page that plays it offline.

    Needs no display and no OpenGL. The page also plays recordings.
    """
    from sandbox.cli.picture_options import parse_size, writable_picture

    suffix = writable_picture(output, SUFFIXES)
    if suffix == ".html":
        if size is not None:
            raise SandboxError("--size is for pictures: a page fits itself to its window")
        _write_page(scene, output, step, steps, json)
        return
    if scene.name.endswith(".replay.json"):
        raise SandboxError(f"{told(scene)}: pictures are of scenes; what shows a recording is a page: -o NAME.html")
    moving = suffix == ".gif"
    pixels = parse_size(size or (FILM_SIZE if moving else STILL_SIZE))
    world = _world(find_scene(scene))
    frames = _shoot(world, output, step, (steps or FILM_STEPS) if moving else 0, fps, pixels)
    _tell(json, output, pixels, world, frames)


def _world(path: Path) -> World:
    from sandbox.cli.compiling import announce_compilation
    from sandbox.engine.world import World
    from sandbox.scene import load_scene

    world = World(load_scene(path))
    announce_compilation()
    return world


def _shoot(world: World, output: Path, step: int, steps: int, fps: float, size: tuple[int, int]) -> int:
    """Simulate and draw; gives the number of pictures."""
    from sandbox.cli.picture_progress import PictureProgress
    from sandbox.render.film import film, gif_seconds
    from sandbox.render.frame import capture
    from sandbox.render.image import renderer_of, save_gif

    with PictureProgress() as progress:
        renderer = renderer_of(world, size)
        for _ in progress.count("simulating", range(step)):
            world.step()
        if steps == 0:
            renderer.save_png(capture(world.state), output)
            return 1
        seconds = gif_seconds(fps)
        frames = list(film(world, progress.count("simulating", range(steps)), seconds))
        save_gif(progress.count("drawing", renderer.film(frames), len(frames)), output, seconds)
        return len(frames)


def _tell(as_json: bool, output: Path, size: tuple[int, int], world: World, frames: int) -> None:
    import json

    facts: dict[str, Any] = {
        "file": str(output),
        "bytes": output.stat().st_size,
        "width": size[0],
        "height": size[1],
        "pictures": frames,
        "step": world.step_count,
        "digest": world.digest(),
    }
    if as_json:
        print(json.dumps(facts, indent=2))
    else:
        what = f"{frames} pictures" if frames > 1 else "a picture"
        kilobytes = facts["bytes"] / 1000
        print(f"{told(output)}: {what}, {size[0]}x{size[1]}, {kilobytes:.0f} kB, at step {world.step_count}")


def _write_page(path: Path, output: Path, skip: int, steps: int | None, as_json: bool) -> None:
    from rich.console import Console

    from sandbox.cli.compiling import announce_compilation
    from sandbox.cli.progress import SceneProgress
    from sandbox.report.filming import film_run
    from sandbox.report.player_page import player_page

    title, run = _run(path, skip, steps)
    announce_compilation()
    with SceneProgress(Console(stderr=True), 1) as progress:
        progress.begin(path.name, run.steps)
        film = film_run(run, skip=skip, on_steps=progress.done)
    write_text(output, player_page(title, film))
    _tell_page(as_json, output, film)


def _tell_page(as_json: bool, output: Path, film: Film) -> None:
    size = output.stat().st_size
    if as_json:
        import json

        facts = {"file": str(output), "bytes": size, "first_step": film.start, "last_step": film.end}
        print(json.dumps({**facts, "every": film.every, "bodies": len(film.bodies)}, indent=2))
    else:
        print(f"{told(output)}: a page, {size / 1000:.0f} kB, steps {film.start} to {film.end}")


def _run(path: Path, skip: int, steps: int | None) -> tuple[str, Run]:
    """A title and what to play."""
    from dataclasses import replace

    from sandbox.replay.golden.run import run_of
    from sandbox.replay.recording.limits import SUFFIX
    from sandbox.replay.recording.recording import Recording
    from sandbox.scene import load_scene

    what = Recording.load(path) if path.name.endswith(SUFFIX) else load_scene(find_scene(path))
    run = run_of(what)
    if steps is None and skip >= run.steps:
        raise SandboxError(f"--step {skip}: the run has {run.steps} steps; --steps says how many to show from there")
    title = getattr(run.scene, "title", "") or path.name
    return title, run if steps is None else replace(run, steps=skip + steps)
