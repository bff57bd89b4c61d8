"""Quirks of windowing systems that would otherwise end the program without a word that helps."""

from __future__ import annotations

import ctypes
import os
import sys

from sandbox.window.requirements import no_screen

_HANDLER = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)
_keep_errors_quiet = _HANDLER(lambda display, event: 0)


def choose_video_driver(visible: bool) -> None:
    """Without a screen on Linux: refuse if somebody is to look at the window, else draw off screen.

    SDL would open an invisible window of its own accord. Who sets `SDL_VIDEODRIVER` decides for themselves.
    """
    screen = any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"))
    if screen or not sys.platform.startswith("linux"):
        return
    if visible:
        raise no_screen()
    os.environ["SDL_VIDEODRIVER"] = "offscreen"


def survive_x_errors() -> None:
    """Without an OpenGL driver an X request fails, and Xlib's own way would be to end the process."""
    if not sys.platform.startswith("linux") or not os.environ.get("DISPLAY"):
        return
    try:
        xlib = ctypes.CDLL("libX11.so.6")
    except OSError:
        return  # SDL has its own way without
    xlib.XSetErrorHandler.restype = ctypes.c_void_p
    xlib.XSetErrorHandler(_keep_errors_quiet)


def choose_gl_platform(driver: str) -> None:
    """PyOpenGL has to use the interface (GLX or EGL) that SDL uses; alone it guesses from the session."""
    if sys.platform.startswith("linux"):
        os.environ.setdefault("PYOPENGL_PLATFORM", "egl" if _uses_egl(driver) else "glx")


def _uses_egl(driver: str) -> bool:
    """Of SDL's drivers on Linux only `x11` speaks GLX, unless it is told to speak EGL."""
    forced = os.environ.get("SDL_VIDEO_X11_FORCE_EGL") == "1"
    return sys.platform.startswith("linux") and (driver != "x11" or forced)
