"""Where moving bodies came from in the last seconds: kept while trails are shown, drawn as lines that fade."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection
from dataclasses import dataclass, field

import numpy as np

from sandbox.render.camera import Camera, Floats
from sandbox.render.frame import Frame
from sandbox.render.geometry import Ints
from sandbox.scene.flat import FlatBody
from sandbox.world.records import STATIC
from sandbox.world.roster import Register
from sandbox.world.state import State

SECONDS = 3.0
"""How far back trails reach."""
MOMENTS = 45
"""Positions of each body that are kept in that time."""
MOST_BODIES = 250
"""Trails that are drawn at most: those of the bodies that went farthest."""


@dataclass(frozen=True)
class _Moment:
    step: int
    roster: Register[FlatBody]
    center: Floats


@dataclass
class Trails:
    """Positions of the last seconds. `only`: ids of the bodies whose trails are wanted; none means all that move."""

    only: Collection[str] = ()
    _moments: deque[_Moment] = field(default_factory=deque)

    def note(self, state: State) -> None:
        """Remember where bodies are after a step. What was known of this step and later ones is forgotten."""
        step = int(state.counters[0].step_count)
        self.forget(step)
        every = max(round(SECONDS / MOMENTS / float(state.settings[0].step_seconds)), 1)
        if step % every:
            return
        center = np.column_stack([state.bodies.center_x, state.bodies.center_y])
        self._moments.append(_Moment(step, state.roster.bodies, center))
        while len(self._moments) > MOMENTS + 1:
            self._moments.popleft()

    def forget(self, step: int) -> None:
        """Forget what was at a step and later, which is not so any more."""
        while self._moments and self._moments[-1].step >= step:
            self._moments.pop()

    def lines(self, frame: Frame, camera: Camera) -> tuple[Floats, Floats, Ints]:
        """Starts and ends (k, s, 2) in pixels of the pieces of `k` trails, oldest first, and whose they are (k,)."""
        known = [moment for moment in self._moments if moment.step < frame.step]
        places = np.stack([*(_places(moment, frame) for moment in known), frame.center], axis=1)
        ways = np.hypot(*np.moveaxis(np.diff(places, axis=1), 2, 0))
        length = np.nansum(ways, axis=1) * camera.scale
        wanted = frame.type != STATIC
        if self.only:
            wanted &= np.isin(np.array(frame.roster.names), list(self.only))
        rows = np.flatnonzero(wanted & (length > 2.0))
        rows = rows[np.argsort(-length[rows], kind="stable")][:MOST_BODIES]
        pixels = camera.to_screen(places[rows])
        return pixels[:, :-1], pixels[:, 1:], rows


def _places(moment: _Moment, frame: Frame) -> Floats:
    """Where the bodies of a frame were (n, 2); NaN for those that were not there yet."""
    if moment.roster is frame.roster:
        return moment.center
    rows = {serial: row for row, serial in enumerate(moment.roster.serials)}
    index = np.array([rows.get(serial, -1) for serial in frame.roster.serials], np.int64)
    places = np.full((len(index), 2), np.nan)
    places[index >= 0] = moment.center[index[index >= 0]]
    return places
