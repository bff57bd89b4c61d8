"""The dialog for pictures and films of the session, and the bar of one that is being written."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.errors import MissingDependencyError, SandboxError
from sandbox.render.camera import Size
from sandbox.render.number_text import counted
from sandbox.render.theme import DARK, LIGHT
from sandbox.window.export import FILMS, LARGEST, SMALLEST, STILLS, Wanted, as_seen, even, export_path, write_export
from sandbox.window.gui_style import palette_of
from sandbox.window.job import Cancelled, Job
from sandbox.window.widgets import Scale, button, drag, integer, mark, progress_bar, wrapped
from sandbox.window.workspace import Workspace, failed

TITLE, WIDTH, MARGIN = "Export###export", 430.0, 14.0
LABELS, FIELD = 6.5, 6.0
"""Widths of the names at the left and of a field, in heights of the font."""
FLAGS = imgui.WindowFlags_.no_docking | imgui.WindowFlags_.no_saved_settings
SIZES: tuple[tuple[str, Size], ...] = (("640x400", (640, 400)), ("720p", (1280, 720)), ("1080p", (1920, 1080)))


class ExportBox:
    """`draw` shows the dialog while it is open, and how far the export is. One is written at a time."""

    def __init__(self) -> None:
        self._wanted: Wanted | None = None
        self._job: Job[str] | None = None
        self._path = Path()
        self._missing: dict[str, str] = {}

    @property
    def busy(self) -> bool:
        """Whether one is being written."""
        return self._job is not None

    @property
    def cancelled(self) -> bool:
        """Whether the one that is being written is to stop."""
        return self._job is not None and self._job.progress.cancelled

    def draw(self, workspace: Workspace) -> None:
        """One picture of it; starts what is asked for and tells what came of it."""
        self._take(workspace)
        if workspace.export_asked:
            workspace.export_asked = False
            if self._job is not None:
                workspace.say("an export is being written: wait for it, or cancel it")
            else:
                suffix = self._wanted.suffix if self._wanted is not None else ".gif"
                self._wanted = as_seen(workspace, suffix)
                imgui.open_popup(TITLE)
        if self._job is not None:
            self._draw_progress(workspace, self._job)
        room = imgui.get_io().display_size
        wide = min(WIDTH * workspace.text_scale, room.x - 8.0)
        imgui.set_next_window_pos(imgui.ImVec2(room.x / 2, room.y / 2), imgui.Cond_.appearing, imgui.ImVec2(0.5, 0.5))
        imgui.set_next_window_size_constraints(imgui.ImVec2(wide, 0.0), imgui.ImVec2(wide, room.y - 8.0))
        if imgui.begin_popup_modal(TITLE, True, FLAGS | imgui.WindowFlags_.always_auto_resize)[0]:
            if self._wanted is not None:
                self._wanted = self._draw_dialog(workspace, self._wanted)
            imgui.end_popup()

    def _draw_dialog(self, workspace: Workspace, wanted: Wanted) -> Wanted:
        wanted = _draw_kind(wanted)
        wanted = _draw_steps(workspace, wanted)
        wanted = _draw_size(workspace, wanted)
        wanted = _draw_look(wanted)
        follow = f"goes along with {wanted.follow}" if wanted.follow is not None else "as it is now"
        overlays = ", ".join(wanted.overlays) or "none"
        wrapped(f"{_length(workspace, wanted)}Camera: {follow}. Overlays: {overlays}.")
        path = export_path(workspace, wanted)
        missing = self._lacking(wanted.suffix)
        if missing:
            imgui.push_text_wrap_pos(0.0)
            imgui.text_colored(imgui.ImVec4(*palette_of(workspace.theme).accent, 1.0), missing)
            imgui.pop_text_wrap_pos()
        imgui.separator()
        can = not missing and not (wanted.film and wanted.last <= wanted.first)
        if button("export.start", f"{icons.ICON_FA_FILE_EXPORT}  Export", f"Write {path}", enabled=can):
            self._start(workspace, wanted, path)
            imgui.close_current_popup()
        imgui.same_line()
        if button("export.close", "Close", "Nothing is written."):
            imgui.close_current_popup()
        imgui.same_line()
        imgui.text_disabled(path.name)
        mark("export.name", str(path))
        return wanted

    def _start(self, workspace: Workspace, wanted: Wanted, path: Path) -> None:
        run, self._path = workspace.session.timeline.run, path
        self._job = Job(lambda progress: write_export(run, wanted, path, progress))

    def _take(self, workspace: Workspace) -> None:
        """Tell what came of the export, once it is over."""
        if self._job is None or not self._job.done:
            return
        job, self._job = self._job, None
        try:
            workspace.say(f"exported {job.result()}")
        except Cancelled:
            workspace.say("the export was cancelled: nothing is written")
        except (SandboxError, OSError) as error:
            workspace.say(failed("not exported", error))

    def _draw_progress(self, workspace: Workspace, job: Job[str]) -> None:
        left, top, width, height = workspace.viewport.rect
        at = imgui.ImVec2(left + MARGIN, top + height - MARGIN)
        imgui.set_next_window_pos(at, imgui.Cond_.always, imgui.ImVec2(0.0, 1.0))
        flags = FLAGS | imgui.WindowFlags_.no_decoration | imgui.WindowFlags_.always_auto_resize
        imgui.begin("##exporting", None, flags | imgui.WindowFlags_.no_focus_on_appearing)
        progress = job.progress
        imgui.text_unformatted(self._path.name)
        imgui.same_line()
        imgui.text_disabled(f"{progress.what or 'preparing'} {progress.done:,} of {progress.total:,}")
        room = max(min(320.0 * workspace.text_scale, width - 4 * MARGIN), 80.0)
        progress_bar("export.progress", progress.share, width=room)
        if button("export.cancel", "Cancel", "Stop: nothing is written.", enabled=not progress.cancelled):
            job.cancel()
        imgui.end()

    def _lacking(self, suffix: str) -> str:
        """What has to be installed for films of a kind; empty if nothing."""
        if suffix in (".mp4", ".webm") and suffix not in self._missing:
            from sandbox.render.video import check_video

            try:
                check_video(suffix)
                self._missing[suffix] = ""
            except MissingDependencyError as error:
                self._missing[suffix] = str(error)
        return self._missing.get(suffix, "")


def _name(text: str) -> None:
    """What the fields beside it are."""
    imgui.align_text_to_frame_padding()
    imgui.text_disabled(text)
    imgui.same_line(imgui.get_font_size() * LABELS)
    imgui.set_next_item_width(imgui.get_font_size() * FIELD)


def _draw_kind(wanted: Wanted) -> Wanted:
    _name("Write")
    for suffix in (*STILLS, *FILMS):
        label = {".webm": "WebM"}.get(suffix, suffix[1:].upper())
        what = "a film" if suffix in FILMS else "a picture of one step"
        if button(f"export.kind.{suffix[1:]}", label, f"Write {what}.", on=suffix == wanted.suffix):
            wanted = wanted.with_suffix(suffix)
        imgui.same_line()
    imgui.new_line()
    return wanted


def _draw_steps(workspace: Workspace, wanted: Wanted) -> Wanted:
    length = workspace.session.timeline.length
    if not wanted.film:
        _name("Step")
        step = integer("export.step", "", wanted.still, "The step that is shown.", limits=(0, max(length, 1)))[1]
        return replace(wanted, still=min(max(step, 0), length))
    _name("Steps")
    first = integer("export.first", "", wanted.first, "The step that it begins with.", limits=(0, max(length, 1)))[1]
    imgui.same_line()
    imgui.text_disabled("to")
    imgui.same_line()
    imgui.set_next_item_width(imgui.get_font_size() * FIELD)
    last = integer("export.last", "", wanted.last, "The step that it ends with.", limits=(0, max(length, 1)))[1]
    imgui.same_line()
    if button("export.all", "All", "All that is known."):
        first, last = 0, length
    first, last = min(max(first, 0), length), min(max(last, 0), length)
    return replace(wanted, first=first, last=last)


def _draw_size(workspace: Workspace, wanted: Wanted) -> Wanted:
    width, height = wanted.size
    limits = (SMALLEST, LARGEST)
    _name("Pixels")
    width = integer("export.width", "", width, "Width", limits=limits)[1]
    imgui.same_line()
    imgui.text_disabled("x ")
    imgui.same_line()
    imgui.set_next_item_width(imgui.get_font_size() * FIELD)
    height = integer("export.height", "", height, "Height", limits=limits)[1]
    size = even((width, height))
    _name("")
    seen = workspace.viewport.camera.size
    for label, preset in (("As seen", even(seen)), *SIZES):
        if button(f"export.size.{label.lower().replace(' ', '-')}", label, f"{preset[0]} x {preset[1]} pixels"):
            size = preset
        imgui.same_line()
    imgui.new_line()
    return replace(wanted, size=size)


def _draw_look(wanted: Wanted) -> Wanted:
    """Colours, and of a film the pictures a second."""
    _name("Look")
    if wanted.film:
        limits = Scale("a second", 0.2, 1.0, wanted.fastest, 3)
        fps = drag("export.fps", "", wanted.fps, "Pictures a second", limits)[1]
        wanted = replace(wanted, fps=min(max(fps, 1.0), wanted.fastest))
        imgui.same_line()
    for label, theme in (("Dark", DARK), ("Light", LIGHT)):
        if button(f"export.theme.{label.lower()}", label, on=wanted.theme is theme):
            wanted = replace(wanted, theme=theme)
        imgui.same_line()
    imgui.new_line()
    return wanted


def _length(workspace: Workspace, wanted: Wanted) -> str:
    """How long a film gets, in words."""
    if not wanted.film:
        return ""
    if wanted.last <= wanted.first:
        return "A film needs steps: end after the start. "
    steps = wanted.last - wanted.first
    seconds = steps * float(workspace.session.world.state.settings[0].step_seconds)
    return f"{counted(steps, 'step')}, {seconds:.2f} s. "
