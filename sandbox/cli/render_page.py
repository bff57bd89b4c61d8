"""The page of `sandbox render`, which plays a run offline."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sandbox._atomic_write import write_text
from sandbox._printable import told
from sandbox.cli.document import print_document
from sandbox.cli.options import values_set
from sandbox.cli.render_options import RenderOptions, steps_asked_for, theme_of
from sandbox.cli.running import run_in
from sandbox.errors import SandboxError

if TYPE_CHECKING:
    from sandbox.report.film import Film

_PICTURES_ONLY = ("size", "fps", "center", "height", "follow", "overlay", "color_by")


def write_page(options: RenderOptions) -> None:
    """Run it and write the page. Raises `SandboxError` and `OSError`."""
    from rich.console import Console

    from sandbox.cli.compiling import announce_compilation
    from sandbox.cli.progress import SceneProgress
    from sandbox.report.filming import film_run
    from sandbox.report.player_page import player_page

    _check(options)
    theme = theme_of(options.theme)
    skip, steps = steps_asked_for(options)
    run = run_in(options.scene, values_set(options.set), None if steps is None else skip + steps)
    if steps is None and skip >= run.steps:
        raise SandboxError(f"--step {skip}: the run has {run.steps} steps; --steps says how many to show from there")
    announce_compilation()
    with SceneProgress(Console(stderr=True), 1) as progress:
        progress.begin(options.scene.name, run.steps)
        film = film_run(run, skip=skip, on_steps=progress.done, theme=theme)
    if film.cut:
        raise SandboxError(f"{told(options.scene)}: the run {film.cut}")
    title, about = (getattr(run.scene, name, "") for name in ("title", "about"))
    write_text(options.output, player_page(title or options.scene.name, film, about=about))
    _tell(options, film)


def _check(options: RenderOptions) -> None:
    """Raise `SandboxError` for an option that a page has no use for."""
    for name in _PICTURES_ONLY:
        if getattr(options, name):
            why = "a page fits itself to its window" if name == "size" else "a page has controls of its own for that"
            raise SandboxError(f"--{name.replace('_', '-')} is for pictures: {why}")
    if not options.depth:
        raise SandboxError("--flat is for pictures: nothing casts a shadow in a page")


def _tell(options: RenderOptions, film: Film) -> None:
    size = options.output.stat().st_size
    if options.json:
        facts = {"path": options.output.as_posix(), "bytes": size, "first_step": film.start, "last_step": film.end}
        print_document({**facts, "every": film.every, "bodies": len(film.bodies)})
    else:
        kept = "" if film.every == 1 else f", one of {film.every} kept"
        print(f"{told(options.output)}: a page, {size / 1000:.0f} kB, steps {film.start} to {film.end}{kept}")
