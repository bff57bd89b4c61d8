"""`sandbox render`: a scene as a PNG picture or a GIF film, without a display and without OpenGL."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox.resources import find_scene

if TYPE_CHECKING:
    from sandbox.engine.world import World

SUFFIXES = (".png", ".gif")
STILL_SIZE, FILM_SIZE = "1280x800", "640x400"

_SCENE = typer.Argument(help="A scene file, or the name of a shipped scene.")
_OUTPUT = typer.Option("-o", "--output", help="The file to write: NAME.png or NAME.gif.")
_STEP = typer.Option(min=0, max=10_000_000, help="Steps to take before the picture, or before the film begins.")
_STEPS = typer.Option(min=1, max=100_000, help="Length of a film in steps.")
_FPS = typer.Option(min=1.0, max=50.0, help="Pictures a second in a film.")
_SIZE = typer.Option(
    metavar="WxH", show_default=False, help=f"Pixels; default {STILL_SIZE} for PNG, {FILM_SIZE} for GIF."
)
_JSON = typer.Option("--json", help="Print what was written as JSON.")


def render(
    scene: Annotated[Path, _SCENE],
    output: Annotated[Path, _OUTPUT],
    step: Annotated[int, _STEP] = 0,
    steps: Annotated[int, _STEPS] = 300,
    fps: Annotated[float, _FPS] = 25.0,
    size: Annotated[str | None, _SIZE] = None,
    json: Annotated[bool, _JSON] = False,
) -> None:
    """Draw a scene into a PNG picture or a GIF film. Needs no display and no OpenGL."""
    from sandbox.cli.picture_options import parse_size, writable_picture

    moving = writable_picture(output, SUFFIXES) == ".gif"
    pixels = parse_size(size or (FILM_SIZE if moving else STILL_SIZE))
    world = _world(find_scene(scene))
    frames = _shoot(world, output, step, steps if moving else 0, fps, pixels)
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
    from sandbox.render.image import save_gif, studio_of

    with PictureProgress() as progress:
        studio = studio_of(world, size)
        for _ in progress.count("simulating", range(step)):
            world.step()
        if steps == 0:
            studio.save_png(capture(world.state), output)
            return 1
        seconds = gif_seconds(fps)
        frames = list(film(world, progress.count("simulating", range(steps)), seconds))
        save_gif(progress.count("drawing", studio.film(frames), len(frames)), output, seconds)
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
        print(f"{output}: {what}, {size[0]}x{size[1]}, {kilobytes:.0f} kB, at step {world.step_count}")
