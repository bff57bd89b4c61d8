"""A film: every pose of a run, and a few figures of each step, for a page that plays it without the engine."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sandbox.render.theme import DARK, Theme
from sandbox.replay.recording.checkpoint import Checkpoint
from sandbox.report.body_data import FilmBody
from sandbox.tables import Floats


@dataclass(frozen=True)
class Film:
    """What a page needs to play a run. Sample k is `start + k * every`, but the last one is `end`.

    `poses` (bodies, samples, 3) are x, y (m) of the centre and the angle (rad), NaN while a body is not there;
    `awake` and `frozen` (bodies, samples); `joints` are the joints, `held` (joints, samples) says when they hold;
    `fields` pairs a sample with the regions and flames from then on, `score` with the counters of a game and how it
    ended, in words; `view` is the middle (m) and height (m) of the
    first view; `cut` says why the run ended early, if it did; `theme` is that of its colours.
    """

    start: int
    end: int
    every: int
    step_rate: float
    bodies: tuple[FilmBody, ...]
    poses: Floats
    awake: NDArray[np.bool_]
    frozen: NDArray[np.bool_]
    figures: tuple[Checkpoint, ...]
    joints: tuple[dict[str, Any], ...]
    held: NDArray[np.bool_]
    fields: tuple[tuple[int, list[Any]], ...]
    view: tuple[float, float, float]
    commands: tuple[tuple[int, str], ...] = ()
    cut: str = ""
    theme: Theme = DARK
    score: tuple[tuple[int, str], ...] = ()
