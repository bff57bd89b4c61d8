"""Pictures and films of the session: drawn in a thread from a world of its own, while the window goes on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from sandbox.errors import SandboxError
from sandbox.render.camera import Size, Vec
from sandbox.render.coloring.registry import THEME
from sandbox.render.film_file import FASTEST_GIF, GIF_FPS, VIDEO_FPS, save_film
from sandbox.render.overlays.registry import OVERLAYS
from sandbox.render.shots import Shooting, Style, still
from sandbox.render.theme import Theme
from sandbox.replay.golden.run import Run, RunStepper
from sandbox.window.job import Progress
from sandbox.window.session import free_path
from sandbox.window.workspace import Workspace

STILLS, FILMS = (".png", ".svg"), (".gif", ".mp4", ".webm")
SMALLEST, LARGEST = 16, 8192
"""Pixels of a side."""


@dataclass(frozen=True)
class Wanted:
    """What is to be written, `suffix` says as what: a film goes from step `first` to `last`, a picture shows `still`.

    `center` (m), `height` (m) and `follow` are the camera's, `overlays` names of overlays, `color_by`
    what colours mean, `depth` whether what moves casts a shadow.
    """

    suffix: str
    first: int
    last: int
    still: int
    size: Size
    fps: float
    theme: Theme
    center: Vec
    height: float
    follow: str | None = None
    overlays: Sequence[str] = ()
    color_by: str = THEME
    depth: bool = True

    @property
    def film(self) -> bool:
        """Whether it moves."""
        return self.suffix in FILMS

    def with_suffix(self, suffix: str) -> Wanted:
        """The same as another kind of file, at the pictures a second that are usual there."""
        return replace(self, suffix=suffix, fps=GIF_FPS if suffix == ".gif" else VIDEO_FPS)

    @property
    def fastest(self) -> float:
        """Pictures a second at most."""
        return FASTEST_GIF if self.suffix == ".gif" else 120.0


def as_seen(workspace: Workspace, suffix: str = ".gif") -> Wanted:
    """What the window shows now; the range that is chosen on the scrubber, or all that is known."""
    viewport, timeline = workspace.viewport, workspace.session.timeline
    camera = viewport.home if viewport.follow is not None and viewport.home is not None else viewport.camera
    first, last = workspace.time_marks.chosen or (0, timeline.length)
    wanted = Wanted(
        suffix=suffix,
        first=first,
        last=min(last, timeline.length),
        still=timeline.step_count,
        size=even(camera.size),
        fps=VIDEO_FPS,
        theme=workspace.theme,
        center=viewport.camera.center,
        height=camera.size[1] / camera.scale,
        follow=viewport.follow,
        overlays=tuple(workspace.overlays),
        color_by=workspace.color_by,
        depth=workspace.depth,
    )
    return wanted.with_suffix(suffix)


def even(size: Size) -> Size:
    """The nearest size that can be written, with even sides, as videos want them."""
    width, height = (min(max(side - side % 2, SMALLEST), LARGEST) for side in size)
    return width, height


def write_export(run: Run, wanted: Wanted, path: Path, progress: Progress) -> str:
    """Write what is wanted of a run; says in words what it is.

    Raises `MissingDependencyError`, `SandboxError`, `OSError` and `Cancelled`; then nothing is written.
    """
    if wanted.suffix in (".mp4", ".webm"):
        from sandbox.render.video import check_video

        check_video(wanted.suffix)
    stepper = RunStepper(run.scene, run.commands)
    overlays = [OVERLAYS[name] for name in wanted.overlays]
    style = Style(
        wanted.size, wanted.theme, wanted.center, wanted.height, wanted.follow, overlays, wanted.color_by, wanted.depth
    )
    shooting = Shooting(stepper.world, style)
    begin = wanted.first if wanted.film else wanted.still
    for _ in progress.count("simulating", range(begin)):
        stepper.advance()
        shooting.note(stepper.world)
    if wanted.film:
        if wanted.last <= wanted.first:
            raise SandboxError("a film needs steps: choose a range of the timeline")
        count = save_film(stepper, shooting, wanted.last - wanted.first, path, wanted.fps, progress)
        return f"{path.name}: {count:,} pictures, {path.stat().st_size / 1000:,.0f} kB"
    if wanted.still == run.steps:
        stepper.apply_due()  # what was done there is seen there
    _write_still(stepper, shooting, path)
    return f"{path.name}: step {wanted.still:,}, {path.stat().st_size / 1000:,.0f} kB"


def export_path(workspace: Workspace, wanted: Wanted) -> Path:
    """Where it goes: a file that is not there yet."""
    return free_path(workspace.folder, workspace.session.stem, wanted.suffix)


def _write_still(stepper: RunStepper, shooting: Shooting, path: Path) -> None:
    picture = shooting.draw_list(still(stepper, shooting))
    if path.suffix == ".svg":
        from sandbox._atomic_write import write_text
        from sandbox.render.svg_painter import svg_picture

        write_text(path, svg_picture(picture, getattr(stepper.world.scene, "title", "")))
        return
    from sandbox.render.image import save_png
    from sandbox.render.surface_painter import SurfacePainter

    save_png(SurfacePainter().paint(picture), path)
