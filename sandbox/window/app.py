"""The program in its window: shows one screen after another, and ends as asked."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pygame
from imgui_bundle import imgui

from sandbox.errors import SandboxError
from sandbox.render.camera import Vec
from sandbox.render.theme import LIGHT
from sandbox.window.actions.registry import BY_NAME
from sandbox.window.compare import OWNER, begin_comparison, open_panel
from sandbox.window.display import Display
from sandbox.window.gallery import Gallery
from sandbox.window.journal import Journal, ended_sessions
from sandbox.window.leftover import Leftover, leftovers, read_session
from sandbox.window.loader import Loader
from sandbox.window.loading import LoadingScreen
from sandbox.window.offer_box import draw_offer
from sandbox.window.options import Options
from sandbox.window.play import PlayScreen
from sandbox.window.recent import note_recent
from sandbox.window.scene_index import scene_entries
from sandbox.window.screen import Canvas, Screen
from sandbox.window.script import Script, is_stray
from sandbox.window.session import Session
from sandbox.window.state_folder import state_folder
from sandbox.window.waiting import WindowClosed, kept_alive
from sandbox.window.workspace import Wish, Workspace

LOADING_FPS = 20
"""Enough to look alive; each picture more would slow the loading thread down."""
LOCKSTEP_SECONDS = 1 / 60
"""What a frame counts for where frames are counted, so that fading text is the same every time."""


class App:
    """The loop: events, time, picture."""

    def __init__(self, canvas: Canvas, options: Options) -> None:
        self.canvas = canvas
        self.options = options
        self._clock = pygame.time.Clock()
        self._gallery: Gallery | None = None
        self._script = Script(options.script) if options.script is not None else None
        self._hands: Iterator[None] | None = None
        self._shown: Screen | None = None
        self._folder = state_folder() if options.frames is None else None
        self._offered = leftovers(self._folder)[:1] if self._folder is not None else []
        self._accepted = False
        self._remembered = canvas.remembered
        self._front = ""
        """The panel that was in front in the scene before."""

    @property
    def _counting(self) -> bool:
        """Whether pictures are counted: then each takes one step, however long it takes."""
        return self.options.frames is not None or self._script is not None

    def run(self) -> None:
        """Until the user leaves, or the frames are used up."""
        with suppress(WindowClosed), kept_alive(self.canvas):
            self._run()

    def _run(self) -> None:
        screen: Screen | None = self._load(self.options.scene) if self.options.scene else self._open_gallery()
        drawn, last = 0, screen
        while screen is not None and (self.options.frames is None or drawn < self.options.frames):
            elapsed = self._tick(screen)
            if not self._act(screen) or not self._handle_events(screen):
                self._finish(screen)
                break
            screen = self._recovered(screen) or self._update(screen, elapsed)
            if screen is None:
                self._finish(last)
            else:
                self._draw(screen)
                self._save_shots(screen)
                self.canvas.display.show()
                drawn, last = drawn + screen.counts, screen
        if self.options.screenshot is not None and last is not None:
            self._draw(last)  # once more: what is behind a shown picture is undefined
            self._filled().save(self.options.screenshot)

    def _act(self, screen: Screen) -> bool:
        """Let the script do what comes next; False once it is over."""
        if self._script is None or not screen.counts:
            return True
        if self._hands is None:
            self._hands = self._script.hands(self._locate)
        self._shown = screen
        return next(self._hands, self) is None

    def _locate(self, point: Vec) -> Vec:
        """The pixel over a point of the scene that is shown."""
        if not isinstance(self._shown, PlayScreen):
            raise SandboxError(f"no scene is shown in which {point[0]:g},{point[1]:g} m could be")
        return self._shown.workspace.viewport.pixel(point)

    def _save_shots(self, screen: Screen) -> None:
        """The pictures that script and user ask for, before this one is shown: then it is undefined what is there."""
        while self._script is not None and self._script.shots:
            self._filled().save(self._script.shots.pop(0))
        if self._script is not None and self._script.reel is not None:
            reel = self._script.reel
            reel.see(self._filled() if reel.due else self.canvas.display)
        if not isinstance(screen, PlayScreen) or not screen.workspace.shots:
            return
        with screen.workspace.attempt("no picture saved", OSError):
            path = screen.workspace.shots.pop(0)
            self._filled().save(path)
            screen.workspace.say(f"saved {path.name}")

    def _update(self, screen: Screen, elapsed: float) -> Screen | None:
        """Let time pass; a screen that comes on gets its share at once: one update a picture."""
        following = screen.update(elapsed)
        return following if following is screen or following is None else following.update(elapsed)

    def _handle_events(self, screen: Screen) -> bool:
        """False when the window is to be closed."""
        for event in pygame.event.get():
            if event.type == pygame.QUIT:
                return False
            if self._script is not None and is_stray(event):
                continue
            taken = self.canvas.gui.process(event)
            screen.handle(event, taken)
        return True

    def _tick(self, screen: Screen) -> float:
        """Wait for the next picture; gives the seconds since the last one."""
        counting = self._counting
        if not screen.counts:
            limit = LOADING_FPS
        else:
            limit = 0 if counting else self.canvas.display.refresh_rate
        elapsed = self._clock.tick(limit) / 1000.0
        return LOCKSTEP_SECONDS if counting and screen.counts else elapsed

    def _draw(self, screen: Screen) -> None:
        if isinstance(screen, PlayScreen):
            screen.workspace.fps = self._clock.get_fps()
        self.canvas.display.begin(fill=self.canvas.display.watched)
        self.canvas.gui.begin(self.canvas.display.size)
        screen.draw(self.canvas)
        if self._offered and screen.counts:
            self._offer(self._offered[0])
        self.canvas.gui.end()

    def _filled(self) -> Display:
        """The window with the pixels of the picture that has been drawn, which is to be read."""
        if not self.canvas.display.filled:
            self.canvas.display.begin()
            self.canvas.paint_again()
            self.canvas.gui.draw_again()
        return self.canvas.display

    def _offer(self, leftover: Leftover) -> None:
        """Ask whether to go on with a session that ended without a goodbye."""
        answer = draw_offer(leftover, self.canvas.display.size)
        if answer is False:
            leftover.discard()
            self._offered.pop()
        self._accepted = answer is True

    def _recovered(self, before: Screen) -> Screen | None:
        """The screen of the session that was offered, if the user wants it."""
        if not self._accepted:
            return None
        self._accepted = False
        return self._go_on(self._offered.pop(), before)

    def _last_session(self, session: Session) -> Path | None:
        """What was done in a scene the last time."""
        found = ended_sessions(self._folder, session.scene) if self._folder is not None else []
        return found[0] if found else None

    def _go_on(self, leftover: Leftover, before: Screen) -> Screen:
        """With a session that is on disk."""
        loader = Loader(Path(leftover.scene.source), leftover.steps, self.options.workers, leftover)
        return self._loading(loader, before, leftover)

    def _loading(self, loader: Loader, before: Screen | None = None, leftover: Leftover | None = None) -> Screen:
        """The screen until `loader` is done; where it fails, the scene that was there `before` goes on."""

        def play(session: Session) -> Screen:
            if isinstance(before, PlayScreen):
                self._leave(before)
            if self._folder is not None and loader.path.is_file():
                note_recent(self._folder, loader.path)
            return self._play(session, leftover)

        return LoadingScreen(loader, play, lambda error: self._failed(error, before), before)

    def _leave(self, screen: PlayScreen) -> None:
        screen.close()
        self._memorise(screen.workspace)

    def _finish(self, screen: Screen | None) -> None:
        """The program ends as it should."""
        screen = screen.before if isinstance(screen, LoadingScreen) else screen
        if isinstance(screen, PlayScreen):
            self._leave(screen)
        if self._folder is not None and self._script is None:
            self._remembered.size = self.canvas.display.size
            self._remembered.docks = imgui.save_ini_settings_to_memory()
            self._remembered.keep(self._folder)

    def _recall(self, workspace: Workspace) -> None:
        """Make a workspace as the user left the last one."""
        kept = self._remembered
        workspace.theme = self.canvas.theme
        workspace.text_scale, workspace.less_motion = self.canvas.text_scale, kept.less_motion
        if kept.panels is not None:
            workspace.panels = set(kept.panels)
        workspace.front = self._front

    def _memorise(self, workspace: Workspace) -> None:
        """Note how the user likes it."""
        kept = self._remembered
        kept.light, kept.panels = workspace.theme is LIGHT, sorted(workspace.panels - {OWNER})
        chosen = abs(workspace.text_scale - self.canvas.text_scale) > 1e-9
        kept.text_scale = workspace.text_scale if chosen else kept.text_scale
        kept.less_motion = workspace.less_motion
        self.canvas.theme = workspace.theme
        self._front = next((name for name in kept.panels if name not in workspace.behind), "")

    def _load(self, path: Path, before: Screen | None = None) -> Screen:
        start = self.options.start_step if path == self.options.scene else 0
        other = self.options.other if path == self.options.scene else None
        values = self.options.values if path == self.options.scene else {}
        loader = Loader(path, start, self.options.workers, other=other, values=values)
        return self._loading(loader, before)

    def _play(self, session: Session, leftover: Leftover | None = None) -> PlayScreen:
        self.canvas.display.title(f"{session.title} - sandbox" if session.title else "sandbox")
        lockstep = self._counting
        shown = self.options.frames is None or self.options.script is not None
        screen = PlayScreen(session, self.canvas.display.size, self._lead, lockstep, shown)
        self._recall(screen.workspace)
        screen.workspace.say_trouble()
        if session.recording is not None and shown:
            begin_comparison(screen.workspace, session.other, lockstep)
            open_panel(screen.workspace)
        if self._folder is not None:
            screen.journal = Journal(self._folder)
            screen.journal.sync(session)
        if leftover is not None:
            leftover.discard()
            session.clock.paused = True
            screen.workspace.say("here you were; Space goes on")
        screen.workspace.last_session = self._last_session(session)
        if screen.workspace.last_session is not None and not (lockstep or screen.note):
            screen.workspace.say(f"{BY_NAME['resume'].keys[0]} goes on with what you did here the last time")
        return screen

    def _lead(self, wish: Wish, screen: PlayScreen) -> Screen | None:
        """Where a wish of the user's leads to. What is opened takes the place of the scene once it is there."""
        if wish.kind == "open" and wish.path is not None:
            return self._load(wish.path, screen)
        if wish.kind == "resume" and wish.path is not None:
            leftover = read_session(wish.path)
            if leftover is not None:
                return self._go_on(leftover, screen)
            screen.workspace.say("what was done the last time cannot be read any more")
            return screen
        self._leave(screen)
        match wish.kind:
            case "play" if wish.session is not None:
                following = self._play(wish.session)
                following.take_over(screen)
                return following
            case "gallery":
                return self._open_gallery()
            case "leave" if self._gallery is not None:
                return self._open_gallery()
        return None

    def _failed(self, error: Exception, before: Screen | None) -> Screen | None:
        """A scene that cannot be loaded is told over the one before it, or in the list; without either it is fatal."""
        if isinstance(before, PlayScreen):
            before.refused = str(error)
            return before
        if self._gallery is None:
            raise error
        self._gallery.say(str(error))
        return self._gallery

    def _open_gallery(self) -> Gallery:
        entries = scene_entries(self._folder, Path.cwd())
        if self._gallery is None:
            self._gallery = Gallery(entries, self._load)
        else:
            self._gallery.know(entries)
        self.canvas.display.title("sandbox")
        return self._gallery
