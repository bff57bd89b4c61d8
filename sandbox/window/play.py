"""The screen on which a scene runs: hands events to tools and actions, lets time pass, draws scene and panels."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pygame

from sandbox.render.camera import Camera, Size
from sandbox.render.coloring.registry import THEME
from sandbox.window import hud
from sandbox.window.actions.registry import BY_NAME
from sandbox.window.at_rest import asleep
from sandbox.window.compare import end_comparison, follow_comparison
from sandbox.window.controls.player import Player
from sandbox.window.export_box import ExportBox
from sandbox.window.grid_labels import draw_grid_labels
from sandbox.window.gui_style import apply_style, palette_of
from sandbox.window.help import draw_help
from sandbox.window.journal import Journal
from sandbox.window.keyboard import Keyboard
from sandbox.window.layout import NARROW, Layout, first_panels
from sandbox.window.mouse import Mouse
from sandbox.window.overlay import Overlay
from sandbox.window.palette import Palette
from sandbox.window.panels.registry import new_panels
from sandbox.window.problem_box import NOT_OPENED, NOT_READ, draw_problem
from sandbox.window.reload import Reloader
from sandbox.window.scale_bar import draw_scale_bar
from sandbox.window.scene_picture import ScenePicture
from sandbox.window.scoreboard import draw_ending
from sandbox.window.screen import Canvas, Screen
from sandbox.window.session import Session
from sandbox.window.strips import Strips, Told
from sandbox.window.tools.act import MagnetTool
from sandbox.window.tools.play import PlayTool
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.viewport import Viewport
from sandbox.window.widgets import begin_picture
from sandbox.window.workspace import Wish, Workspace

FADE_SECONDS = 0.8
TAKEN_OVER = (
    "theme", "panels", "overlays", "color_by", "depth", "interface", "text_scale", "less_motion", "keep_time",
    "selection", "clipboard", "age",
)  # fmt: skip
"""What of a workspace stays when its file is read again."""
MOST_SKIPPED = 3600
"""Steps that a file which is read again is taken forward at most, where time is to be kept."""


class PlayScreen:
    """Runs a session; `lead` says what comes after it for a wish that leads away. With `lockstep`, a step a picture."""

    counts = True

    def __init__(
        self,
        session: Session,
        size: Size,
        lead: Callable[[Wish, PlayScreen], Screen | None],
        lockstep: bool = False,
        interface: bool = True,
    ) -> None:
        self.lockstep = lockstep
        self.panels = new_panels()
        viewport = Viewport.of(session, size)
        self.workspace = Workspace(session, viewport, Path.cwd(), interface=interface)
        self.workspace.color_by = getattr(session.scene.view, "color_by", THEME)
        self.tool_box = ToolBox(self.workspace)
        self.workspace.panels = first_panels(self.panels, size)
        self.player = Player(self.workspace)
        if self.player.controls:
            self.tool_box.choose("play")
        self.mouse = Mouse(self.workspace, self.tool_box)
        self._keyboard = Keyboard(self.workspace, self.tool_box, self.panels)
        self._picture = ScenePicture(self.workspace, self.mouse.strokes)
        self._palette = Palette(self.workspace, self.tool_box, self.panels)
        self._layout = Layout(self.panels, self.tool_box)
        self._strips = Strips()
        self._reloader = Reloader(session) if session.scene.text is not None else None
        self.export_box = ExportBox()
        self._lead = lead
        self._since_picture = 0.0
        self.refused = ""
        """Why what was to be opened in the place of this scene could not be."""
        self.journal: Journal | None = None
        """Where the session is written down while it is played."""
        session.watchers.append(self._tell_panels)

    @property
    def session(self) -> Session:
        """What is played."""
        return self.workspace.session

    @property
    def camera(self) -> Camera:
        """What is looked through."""
        return self.workspace.viewport.camera

    @property
    def note(self) -> str:
        """What the user was told last."""
        return self.workspace.note

    def close(self) -> None:
        """The session ends as it should."""
        end_comparison(self.workspace)
        if self.journal is not None:
            self.journal.close()

    def take_over(self, before: PlayScreen) -> None:
        """Look as the screen before it did, which showed the same file."""
        mine, its = self.workspace, before.workspace
        for name in TAKEN_OVER:
            setattr(mine, name, getattr(its, name))
        mine.viewport.rect, mine.viewport.camera = its.viewport.rect, its.viewport.camera
        mine.viewport.touched = its.viewport.touched
        clock, old = mine.session.clock, its.session.clock
        clock.speed, clock.paused = old.speed, old.paused
        self.export_box = before.export_box
        if its.keep_time:
            mine.session.skip(min(its.session.timeline.step_count, MOST_SKIPPED))
        mine.say("read again")

    def handle(self, event: pygame.event.Event, taken: tuple[bool, bool] = (False, False)) -> None:
        """Act on an event; `taken` says whether panels want the mouse, and the keyboard."""
        workspace = self.workspace
        if self._plays(event, taken):
            return
        self._keyboard.handle(event, taken[1])
        if event.type == pygame.DROPFILE:
            workspace.wish = Wish("open", Path(event.file))
        self.mouse.handle(event, taken[0])
        if event.type == pygame.MOUSEMOTION and workspace.pointer is not None:
            self.player.point(workspace.pointer)

    def _plays(self, event: pygame.event.Event, taken: tuple[bool, bool]) -> bool:
        """Whether an event is the scene's own: while the tool for playing is in hand and time runs."""
        if not isinstance(self.tool_box.tool, PlayTool) or self.session.clock.paused:
            self.player.let_go()
            return False
        begins = event.type in (pygame.KEYDOWN, pygame.MOUSEBUTTONDOWN)
        if begins and getattr(event, "mod", 0) & (pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META):
            return False
        if event.type == pygame.MOUSEBUTTONDOWN and not self.workspace.viewport.holds(event.pos):
            return False
        mouse = event.type in (pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP)
        return not (begins and taken[0 if mouse else 1]) and self.player.wants(event)

    def update(self, elapsed: float) -> Screen | None:
        """Let time pass."""
        workspace, session = self.workspace, self.session
        if workspace.wish is not None:
            wish, workspace.wish = workspace.wish, None
            return self._lead(wish, self)
        workspace.age += elapsed
        self._since_picture += elapsed
        if (fresh := self._reread(elapsed)) is not None:
            return self._lead(Wish("play", session=fresh), self)
        for name in sorted(workspace.held):
            if BY_NAME[name].enabled(workspace):
                BY_NAME[name].run(workspace)
        if isinstance(self.tool_box.tool, MagnetTool):
            self.tool_box.tool.tick(workspace)
        if not session.clock.paused:
            self.player.play()
        if not self.lockstep:
            session.update(elapsed)
        elif not session.clock.paused:
            session.step_once()
        if session.trouble:
            workspace.say(f"{session.trouble}; the recording's other commands are left out")
            session.trouble = ""
        follow_comparison(workspace)
        if self.journal is not None:
            self.journal.sync(session)
        return self

    def draw(self, canvas: Canvas) -> None:
        """The scene in its rectangle, the panels around it, and what there is to tell."""
        workspace = self.workspace
        apply_style(workspace.theme, workspace.text_scale)
        begin_picture()
        overlay = Overlay(canvas.gui, scale=workspace.text_scale)
        told, rect = self._told(canvas.display.size), self._layout.draw(workspace, canvas.display.size)
        workspace.viewport.place(self._strips.place(overlay, workspace, rect, told), self.session)
        frame = self.session.frame()
        if any(panel.exact and panel.name in workspace.panels for panel in self.panels.values()):
            frame = self.session.current
        workspace.frame = frame
        workspace.viewport.go_along(frame, None if workspace.less_motion else self._since_picture)
        self._since_picture = 0.0
        picture = self._picture.of(frame)
        canvas.paint(picture, workspace.viewport.rect)
        plain = Overlay(canvas.gui)  # what a picture and panels write has its place there
        with plain.within(workspace.viewport.rect):
            plain.labels(picture.labels, workspace.viewport.rect, picture.theme.background)
        self._draw_over(plain)
        self._draw_hud(overlay, told)

    def _told(self, size: Size) -> Told:
        """What is to be said around the scene; the keys of a game where the line of the tool has no room for them."""
        workspace, clock = self.workspace, self.session.clock
        state = hud.time_state(clock.paused, clock.speed)
        plays = isinstance(self.tool_box.tool, PlayTool) and bool(self.player.controls)
        room = workspace.interface and size[0] >= NARROW
        keys = self.tool_box.tool.hint(workspace).keys if plays and not room else ()
        return Told(None if workspace.interface else (self._figures(), state), keys, self._picture.legend)

    def _reread(self, elapsed: float) -> Session | None:
        """The session of the file as it is now, if it has changed on disk."""
        if self._reloader is None:
            self.workspace.reread = False
            return None
        if self.workspace.reread:
            self.workspace.reread = False
            self._reloader.read()
        return self._reloader.poll(elapsed)

    def _draw_over(self, overlay: Overlay) -> None:
        """What open panels draw over the scene; nothing of it leaves the viewport."""
        workspace = self.workspace
        shown = workspace.panels if workspace.interface else set()
        for name in sorted(shown & self.panels.keys()):
            with overlay.within(workspace.viewport.rect):
                self.panels[name].draw_over(workspace, overlay)

    def _draw_problems(self, overlay: Overlay) -> None:
        """What is wrong with a file that was to be opened, or else with that of the scene."""
        reloader, mono = self._reloader, overlay.gui.mono
        if self.refused:
            self.refused = "" if draw_problem(self.workspace, NOT_OPENED, self.refused, mono) else self.refused
        elif reloader and reloader.problem and draw_problem(self.workspace, NOT_READ, reloader.problem, mono):
            reloader.problem = ""

    def _tell_panels(self) -> None:
        """A step was taken: those panels that are shown may keep something of it."""
        for name, panel in self.panels.items():
            if name in self.workspace.panels:
                panel.note_step(self.workspace)

    def _draw_hud(self, overlay: Overlay, told: Told) -> None:
        workspace = self.workspace
        rect, colors = workspace.viewport.rect, palette_of(workspace.theme)
        self._strips.draw(overlay, workspace, told)
        if workspace.interface:
            draw_grid_labels(overlay, workspace, draw_scale_bar(overlay, workspace, self.mouse.at))
        draw_ending(overlay, workspace)
        noted = self._fade(workspace.note_until - workspace.age)
        if noted > 0.0:
            hud.draw_note(overlay, rect, colors, workspace.note, noted)
        self._draw_problems(overlay)
        self.export_box.draw(workspace)
        self._palette.draw()
        if workspace.help_shown:
            draw_help(workspace, self.tool_box.tools, self.panels)

    def _fade(self, left: float) -> float:
        """Opacity of what disappears in `left` seconds."""
        return float(left > 0.0) if self.workspace.less_motion else min(max(left / FADE_SECONDS, 0.0), 1.0)

    def _figures(self) -> hud.Figures:
        world = self.session.world
        return hud.Figures(
            fps=self.workspace.fps,
            step_cost=self.session.step_cost,
            bodies=len(world.names),
            contacts=len(world.contacts),
            step=world.step_count,
            time=world.time,
            frozen=int(world.state.counters[0].frozen_count),
            asleep=asleep(world),
        )
