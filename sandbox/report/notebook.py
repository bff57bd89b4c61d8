"""Worlds, scenes and recordings in a notebook: a small player in a frame of its own."""

from __future__ import annotations

import html
from dataclasses import replace

from sandbox.engine.world import World
from sandbox.errors import SandboxError
from sandbox.replay.golden.run import Run, run_of
from sandbox.replay.recording.recording import Recording
from sandbox.report.filming import film_ahead, film_run
from sandbox.report.player_page import player_frame
from sandbox.scene import Scene

AHEAD = 300
"""Steps that are shown of what a world will do."""
WORK = 150_000
"""Steps times bodies that are simulated for a picture in a notebook, so that a cell does not take long."""
_LEAST = 60
_MOST_POSES = 60_000


def html_of(what: World | Scene | Recording) -> str:
    """A player of a recording, of a scene, or of what comes next in a world, which stays as it is."""
    try:
        return _of_world(what) if isinstance(what, World) else _of_run(what)
    except SandboxError as error:
        return f"<pre>{html.escape(str(error))}</pre>"


def _of_world(world: World) -> str:
    film = film_ahead(world, min(AHEAD, _affordable(len(world.names))), _MOST_POSES)
    title = getattr(world.scene, "title", "") or "World"
    return player_frame(f"{title}: what comes after step {film.start}", film)


def _of_run(what: Scene | Recording) -> str:
    run: Run = run_of(what)
    short = replace(run, steps=min(run.steps, _affordable(len(run.scene.bodies))))
    title = getattr(run.scene, "title", "") or type(what).__name__
    return player_frame(title, film_run(short, most=_MOST_POSES))


def _affordable(bodies: int) -> int:
    return max(_LEAST, WORK // max(bodies, 1))
