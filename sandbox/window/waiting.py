"""Keeping the window alive while the thread that draws it waits for machine code.

An act may need a part of the engine for the first time: the first joint of a world, the first blast. On a machine that
has never compiled it, this takes seconds. Then time stands still, the last picture of the scene stays, and a box says
how far it is.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pygame
from imgui_bundle import imgui

from sandbox import _compiling
from sandbox.engine.compile_status import compile_status
from sandbox.window.gui import Gui
from sandbox.window.gui_style import apply_style, palette_of
from sandbox.window.job import Job
from sandbox.window.loading import draw_progress
from sandbox.window.overlay import Overlay
from sandbox.window.screen import Canvas

QUICK = 0.1
"""Seconds that need not be told of: what has been compiled on this machine is there sooner."""
PICTURE_SECONDS = 0.05
"""Enough to look alive; each picture more would slow the compiler down."""
ABOVE, BELOW, WIDE = 84.0, 96.0, 420.0
"""How far the box goes from the middle, and how wide it is, in pixels with text of the usual size."""
_NEW = {pygame.KEYDOWN, pygame.TEXTINPUT, pygame.MOUSEBUTTONDOWN, pygame.MOUSEWHEEL}
"""What begins something: nothing is begun while all waits. What ends something is kept for later."""


class WindowClosed(BaseException):
    """The user closed the window while it waited. What has been done is on disk."""


@contextmanager
def kept_alive(canvas: Canvas) -> Iterator[None]:
    """What would freeze the window meanwhile is waited for with pictures. Raises `WindowClosed` out of such a wait."""
    before, _compiling.patiently = _compiling.patiently, lambda work: wait_for(work, canvas)
    try:
        yield
    finally:
        _compiling.patiently = before


def wait_for(work: Callable[[], None], canvas: Canvas) -> None:
    """Do work in a thread, and show how far it is. Threads that draw nothing just do it."""
    if threading.current_thread() is not threading.main_thread():
        work()
        return
    job = Job(lambda progress: work())
    if not job.wait(QUICK):
        _show_until_done(job, canvas)
    job.result()


def _show_until_done(job: Job[None], canvas: Canvas) -> None:
    """Pictures by a context of their own: the panels may be in the middle of theirs."""
    ours, fill = imgui.get_current_context(), canvas.display.filled
    gui = Gui(canvas.display.driver)
    begun, kept = time.perf_counter(), []
    try:
        while not job.wait(PICTURE_SECONDS):
            kept += [event for event in pygame.event.get() if _is_for_later(event)]
            _draw(canvas, gui, time.perf_counter() - begun)
    finally:
        gui.close()
        imgui.set_current_context(ours)
        canvas.display.begin(fill)
        for event in kept:
            pygame.event.post(event)


def _is_for_later(event: pygame.event.Event) -> bool:
    if event.type == pygame.QUIT:
        raise WindowClosed
    return event.type not in _NEW or getattr(event, "scripted", False)


def _draw(canvas: Canvas, gui: Gui, age: float) -> None:
    size, scale, colors = canvas.display.size, canvas.text_scale, palette_of(canvas.theme)
    canvas.display.begin()
    canvas.paint_again()
    gui.begin(size)
    apply_style(canvas.theme)
    overlay = Overlay(gui, scale=scale)
    x, y, wide = size[0] / 2, size[1] / 2, min(scale * WIDE, size[0] - 16.0) / 2
    overlay.panel((0.0, 0.0, float(size[0]), float(size[1])), colors.inset, 0.5, 0.0)
    overlay.panel((x - wide, y - ABOVE, x + wide, y + BELOW * scale), colors.panel, 1.0, 8.0)
    lines = ("Compiling what this needs", compile_status() or "", "Once on this machine; then it is quick.")
    draw_progress(overlay, (x, y), lines, age, colors)
    gui.end()
    canvas.display.show()
