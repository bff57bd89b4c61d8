"""The screen on which a scene runs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pygame

from sandbox.errors import SandboxError
from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import Camera, Size, fit, scene_camera
from sandbox.render.draw_list import build_draw_list
from sandbox.window import hud
from sandbox.window.keys import action_of
from sandbox.window.mouse import Mouse
from sandbox.window.overlay import Overlay
from sandbox.window.screen import Canvas, Screen
from sandbox.window.session import Session

TITLE_SECONDS, HELP_SECONDS, NOTE_SECONDS, FADE_SECONDS = 5.0, 9.0, 5.0, 0.8


class PlayScreen:
    """Runs a session; Esc leaves for what `back` gives. With `lockstep`, one physics step a picture."""

    counts = True

    def __init__(self, session: Session, size: Size, back: Callable[[], Screen | None], lockstep: bool = False) -> None:
        self.session = session
        self.lockstep = lockstep
        self.mouse = Mouse(session, self._fitted(size))
        self.fps = 0.0
        self._body_colors = body_colors_of(session.world.state)
        self._back = back
        self._leaving = False
        self._age = 0.0
        self._help_until = HELP_SECONDS
        self.note = ""
        """What there is to tell the user now."""
        self._note_until = 0.0
        self._actions: dict[str, Callable[[], object]] = {
            "pause": self._pause,
            "step": self._step,
            "slower": lambda: session.clock.change_speed(-1),
            "faster": lambda: session.clock.change_speed(1),
            "restart": session.restart,
            "save": self._save,
            "fit": self._fit,
            "help": self._toggle_help,
            "leave": self._leave,
        }

    def handle(self, event: pygame.event.Event) -> None:
        """Keys and mouse."""
        action = action_of(event)
        if action is not None:
            self._actions[action]()
        self.mouse.handle(event)

    def update(self, elapsed: float) -> Screen | None:
        """Let time pass."""
        if self._leaving:
            return self._back()
        self._age += elapsed
        if not self.lockstep:
            self.session.update(elapsed)
        elif not self.session.clock.paused:
            self.session.step_once()
        if self.session.trouble:
            self._say(f"{self.session.trouble}; the recording's other commands are left out")
            self.session.trouble = ""
        return self

    def draw(self, canvas: Canvas) -> None:
        """The bodies, then the HUD."""
        self._follow_window(canvas.display.size)
        frame = self.session.frame()
        self._body_colors = self._body_colors.for_frame(frame)
        strokes = self.mouse.strokes(frame, canvas.theme)
        canvas.painter.paint(build_draw_list(frame, self.mouse.camera, self._body_colors, strokes))
        self._draw_hud(Overlay(canvas.gui), canvas.display.size)

    def _draw_hud(self, overlay: Overlay, size: Size) -> None:
        clock, scene = self.session.clock, self.session.scene
        hud.draw_figures(overlay, self._figures())
        hud.draw_time_state(overlay, size, clock.paused, clock.speed)
        title = _fade(TITLE_SECONDS - self._age)
        if title > 0.0:
            hud.draw_title(overlay, size, scene.title, scene.about, title)
        noted = _fade(self._note_until - self._age)
        if noted > 0.0:
            hud.draw_note(overlay, size, self.note, noted)
        shown = _fade(self._help_until - self._age)
        if shown > 0.0:
            hud.draw_help(overlay, size, shown)

    def _figures(self) -> hud.Figures:
        world = self.session.world
        return hud.Figures(
            fps=self.fps,
            step_cost=self.session.step_cost,
            bodies=len(world.names),
            contacts=len(world.contacts),
            step=world.step_count,
            time=world.time,
            frozen=int(world.state.counters[0].frozen_count),
        )

    def _follow_window(self, size: Size) -> None:
        if size != self.mouse.camera.size:
            self.mouse.camera = self.mouse.camera.resized(size) if self.mouse.touched else self._fitted(size)

    def _fitted(self, size: Size) -> Camera:
        return scene_camera(self.session.scene.view, self.session.home, size)

    def _pause(self) -> None:
        self.session.clock.paused = not self.session.clock.paused

    def _step(self) -> None:
        self.session.clock.paused = True
        self.session.step_once()

    def _save(self) -> None:
        """Write the session into the folder that the program was started in."""
        try:
            path = self.session.save_recording(Path.cwd())
            self._say(f"saved {path.name}: {self.session.world.step_count:,} steps; run it again with sandbox replay")
        except (SandboxError, OSError) as error:
            self._say(f"not saved: {error}")

    def _say(self, text: str) -> None:
        self.note, self._note_until = text, self._age + NOTE_SECONDS

    def _fit(self) -> None:
        self.mouse.camera = fit(self.session.bounds(), self.mouse.camera.size)

    def _toggle_help(self) -> None:
        self._help_until = 0.0 if self._help_until > self._age else float("inf")

    def _leave(self) -> None:
        self._leaving = True


def _fade(left: float) -> float:
    """Opacity of what disappears in `left` seconds."""
    return min(max(left / FADE_SECONDS, 0.0), 1.0)
