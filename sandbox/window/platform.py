"""Quirks of windowing systems that would otherwise end the program without a word that helps."""

from __future__ import annotations

import ctypes
import os
import sys

from sandbox.window.requirements import no_screen

USUAL_DPI = 96.0
"""What a system says of a screen on which nothing is to be larger than usual."""
_SCALES = ("QT_SCALE_FACTOR", "GDK_SCALE")
"""Variables by which desktops tell programs how large all is to be."""
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


def ask_for_real_pixels() -> None:
    """Windows would show the window in fewer pixels and stretch them; SDL has it otherwise for the asking."""
    if sys.platform == "win32":
        os.environ.setdefault("SDL_WINDOWS_DPI_AWARENESS", "permonitorv2")


def system_scale(driver: str) -> float | None:
    """How many times their usual size the user has asked the system to show things; None where it does not say.

    On macOS and Wayland the system stretches the window itself, so there is nothing to do.
    """
    if driver == "windows":
        return float(ctypes.windll.user32.GetDpiForSystem()) / USUAL_DPI  # type: ignore[attr-defined]
    if driver != "x11":
        return None
    told = (_x_resource("Xft", "dpi"), 1.0 / USUAL_DPI), *((os.environ.get(name), 1.0) for name in _SCALES)
    return next((found for text, unit in told if (found := unit * _number(text)) > 0.0), None)


def _number(text: str | None) -> float:
    try:
        return float(text or 0.0)
    except ValueError:
        return 0.0


def _x_resource(program: str, name: str) -> str | None:
    """What the desktop has told the X server that programs are to know."""
    try:
        xlib = ctypes.CDLL("libX11.so.6")
    except OSError:
        return None
    xlib.XOpenDisplay.restype = ctypes.c_void_p
    xlib.XGetDefault.restype = ctypes.c_char_p
    xlib.XGetDefault.argtypes = (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p)
    xlib.XCloseDisplay.argtypes = (ctypes.c_void_p,)
    display = xlib.XOpenDisplay(None)
    if not display:
        return None
    found = xlib.XGetDefault(display, program.encode(), name.encode())
    xlib.XCloseDisplay(display)
    return None if found is None else str(found.decode(errors="replace"))


def choose_gl_platform(driver: str) -> None:
    """PyOpenGL has to use the interface (GLX or EGL) that SDL uses; alone it guesses from the session."""
    if sys.platform.startswith("linux"):
        os.environ.setdefault("PYOPENGL_PLATFORM", "egl" if _uses_egl(driver) else "glx")


def _uses_egl(driver: str) -> bool:
    """Of SDL's drivers on Linux only `x11` speaks GLX, unless it is told to speak EGL."""
    forced = os.environ.get("SDL_VIDEO_X11_FORCE_EGL") == "1"
    return sys.platform.startswith("linux") and (driver != "x11" or forced)
