"""Shots of a world: what is seen at one moment, through which camera, with which overlays."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

from sandbox.engine.world import World
from sandbox.render.body_colors import BodyColors, body_colors_of
from sandbox.render.camera import Camera, Size, Vec, look_at, scene_camera
from sandbox.render.coloring.registry import THEME, shown_coloring
from sandbox.render.draw_list import DrawList, build_draw_list
from sandbox.render.follow import followed
from sandbox.render.frame import Frame, blend, capture, interesting_bounds
from sandbox.render.marks import Marks
from sandbox.render.overlays import trails
from sandbox.render.overlays.legend import CORNERS, Corner, quiet_corner
from sandbox.render.overlays.look import Look, Overlay
from sandbox.render.overlays.registry import draw_overlays
from sandbox.render.scoreboard import draw_scoreboard
from sandbox.render.theme import DARK, Theme
from sandbox.render.trails import Trails

TRAILS = trails.OVERLAY.name


class Stepping(Protocol):
    """What takes the steps of a world: its commands too, if it has some."""

    @property
    def world(self) -> World:
        """The world as it is now."""

    def advance(self) -> None:
        """Take a step."""


@dataclass(frozen=True)
class Style:
    """How a world is to be seen; where `center` (m), `height` (m), `follow` and `color_by` are silent, as its scene
    says. `depth`: what moves casts a soft shadow.
    """

    size: Size
    theme: Theme = DARK
    center: Vec | None = None
    height: float | None = None
    follow: str | None = None
    overlays: Sequence[Overlay] = ()
    color_by: str | None = None
    depth: bool = True


@dataclass(frozen=True)
class Shot:
    """A frame, the camera that sees it, and what overlays draw over it."""

    frame: Frame
    camera: Camera
    marks: Sequence[Marks] = ()


class Shooting:
    """Takes shots of one world; made at its start, as the camera looks at what is there then."""

    def __init__(self, world: World, style: Style) -> None:
        self.style = style
        self.colors: BodyColors = body_colors_of(world.state, style.theme)
        view = getattr(world.scene, "view", None)
        camera = scene_camera(view, interesting_bounds(capture(world.state)), style.size)
        height = style.height or style.size[1] / camera.scale
        self._home = self._camera = look_at(style.center or camera.center, height, style.size)
        color_by = style.color_by or str(getattr(view, "color_by", THEME))
        self._overlays = [*shown_coloring(color_by), *style.overlays]
        self._follow = style.follow or (None if style.center else getattr(view, "follow", None))
        self._arrived = False
        self._trails = Trails() if any(overlay.name == TRAILS for overlay in style.overlays) else None
        self._corners: tuple[Corner, Corner] | None = None
        """Where the counters and the legend are: they stay there through a film."""

    def note(self, world: World) -> None:
        """A step was taken: what trails need is kept, if they are to be seen."""
        if self._trails is not None:
            self._trails.note(world.state)

    def shot(self, world: World, frame: Frame, seconds: float = 0.0) -> Shot:
        """What is seen of a frame of the world, `seconds` after the shot before."""
        if self._follow is not None:
            waited = seconds if self._arrived else None
            self._camera, self._arrived = followed(self._camera, frame, self._follow, self._home, waited), True
        look = Look(world, frame, self._camera, self.style.theme, self._trails)
        return Shot(frame, self._camera, self._marks(look))

    def _marks(self, look: Look) -> tuple[Marks, ...]:
        plays = bool(look.world.counters) or look.world.outcome is not None
        if not (plays or self._overlays):
            return ()
        if self._corners is None:
            score = quiet_corner(look, ("upper left", "upper right"))
            others = [corner for corner in CORNERS if corner != score or not plays]
            self._corners = score, quiet_corner(look, others)
        scoreboard, taken = draw_scoreboard(look, self._corners[0])
        return (*draw_overlays(self._overlays, look, self._corners[1], taken), scoreboard)

    def draw_list(self, shot: Shot) -> DrawList:
        """What painters draw of a shot."""
        self.colors = self.colors.for_frame(shot.frame)
        return build_draw_list(shot.frame, shot.camera, self.colors, marks=shot.marks, depth=self.style.depth)


def still(stepping: Stepping, shooting: Shooting) -> Shot:
    """The world as it stands."""
    return shooting.shot(stepping.world, capture(stepping.world.state))


def shots(stepping: Stepping, steps: Iterable[object], seconds: float, shooting: Shooting) -> Iterator[Shot]:
    """Take a step for each item of `steps`, and a shot every `seconds` of the world's time.

    The present state is the first; later ones are blended between two steps.
    """
    current = capture(stepping.world.state)
    shooting.note(stepping.world)
    yield shooting.shot(stepping.world, current)
    begin, shown = current.time, 1
    for _ in steps:
        stepping.advance()
        shooting.note(stepping.world)
        previous, current = current, capture(stepping.world.state, current.mesh)
        while (moment := begin + shown * seconds) <= current.time + 1e-9:
            alpha = (moment - previous.time) / (current.time - previous.time)
            yield shooting.shot(stepping.world, blend(previous, current, alpha), seconds)
            shown += 1
