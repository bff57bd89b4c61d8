"""One scene of a gallery: its picture, its film in few bytes, and what is said of it."""

from __future__ import annotations

import shlex
from dataclasses import dataclass, replace
from io import BytesIO
from pathlib import Path

from sandbox.errors import SandboxError
from sandbox.render.camera import Size
from sandbox.render.thumbnail import thumbnail
from sandbox.replay.golden.run import Run, run_of
from sandbox.replay.recording.limits import SUFFIX
from sandbox.replay.recording.recording import Recording
from sandbox.report.film_data import film_data, packed
from sandbox.report.filming import film_run
from sandbox.resources import find_scene, scene_name
from sandbox.scene import load_scene
from sandbox.scene.catalog import Entry

PICTURE: Size = (480, 270)
MOST_STEPS, MOST_POSES = 900, 60_000
"""Of a film: what comes later is left out, and between poses that were not kept the page draws straight ways."""


@dataclass(frozen=True)
class GalleryCard:
    """A scene as a page shows it; `picture` is an image file, `film` what `packed` makes of it."""

    name: str
    entry: Entry
    bodies: int
    joints: int
    seconds: float
    picture: bytes
    film: str

    @property
    def said(self) -> str:
        """What `sandbox run` takes: the name of a scene that comes with the package, or else the path, for a shell."""
        path = self.entry.path
        return self.name if find_scene(Path(self.name)) == path else shlex.quote(path.as_posix())


def gallery_card(entry: Entry) -> GalleryCard:
    """The card of a scene. It is played as its recording does, where one stands beside it.

    Raises `SandboxError` and `OSError` if it cannot be used.
    """
    scene = load_scene(entry.path)
    run = run_beside(entry.path)
    film = film_run(replace(run, steps=min(run.steps, MOST_STEPS)), most=MOST_POSES)
    flat = scene.flatten()
    counts = len(flat.bodies), len(flat.joints)
    seconds = run.steps / scene.settings.step_rate
    image = BytesIO()
    thumbnail(scene, PICTURE).convert("RGB").save(image, "WEBP", quality=82, method=6)
    return GalleryCard(scene_name(entry.path), entry, *counts, seconds, image.getvalue(), packed(film_data(film)))


def run_beside(path: Path) -> Run:
    """What the recording beside a scene does; without a sound one, the scene by itself."""
    recording = path.with_name(scene_name(path) + SUFFIX)
    if recording.is_file():
        try:
            return run_of(Recording.load(recording))
        except (SandboxError, OSError):
            pass
    return run_of(load_scene(path))
