"""The window itself: size, OpenGL context, events, and reading back what is on screen."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import moderngl
import pygame

from sandbox._printable import printable
from sandbox.errors import SandboxError
from sandbox.render.camera import Size
from sandbox.window.density import first_size, suited_scale
from sandbox.window.platform import ask_for_real_pixels, choose_video_driver, survive_x_errors, system_scale
from sandbox.window.requirements import no_window

SMALLEST: Size = (320, 200)
LARGEST = 8192


class Display:
    """A pygame window with an OpenGL 3.3 core context, and a context manager that closes it.

    Raises `MissingDependencyError` if there is no screen or no OpenGL.
    """

    def __init__(self, size: Size | None, title: str, visible: bool = True) -> None:
        """Without a `size`, it is as large as suits the screen. `visible` is False where nobody looks: the window may
        be off screen, and never waits."""
        choose_video_driver(visible)
        survive_x_errors()
        ask_for_real_pixels()
        try:
            pygame.display.init()
            _ask_for_core_profile()
            self.screen: Size = pygame.display.get_desktop_sizes()[0]
            """Pixels across and down of the whole screen."""
            self.suited_scale = suited_scale(self.screen, system_scale(self.driver))
            """How many times their usual size suits text and window."""
            _open(size or first_size(self.screen, self.suited_scale), visible)
            pygame.display.set_caption(title)
            self.context = _context()
            self.watched = visible or self.driver != "offscreen"
            """Whether somebody may look at the window."""
            self.filled = True
            """Whether the pixels of the picture under way are filled in."""
            self._shown: Size = (0, 0)
        except Exception as error:  # pygame, moderngl and the driver each have their own
            pygame.display.quit()
            raise no_window(error) from error

    @property
    def size(self) -> Size:
        """Pixels across and down."""
        width, height = pygame.display.get_window_size()
        return max(width, 1), max(height, 1)

    @property
    def refresh_rate(self) -> int:
        """Pictures a second worth drawing."""
        return min(max(pygame.display.get_current_refresh_rate(), 60), 240)

    @property
    def driver(self) -> str:
        """SDL's name for the windowing system: `x11`, `wayland`, `windows`, `cocoa`, `offscreen`."""
        return str(pygame.display.get_driver())

    def title(self, text: str) -> None:
        """Set the text of the title bar."""
        pygame.display.set_caption(printable(text))

    def begin(self, fill: bool = True) -> None:
        """Start a picture: all of the window is drawn on. Without `fill` no pixel is filled in, which takes most of the
        time where there is no graphics card."""
        self.context.screen.use()
        self.context.viewport = (0, 0, *self.size)
        self.filled = fill
        (self.context.disable if fill else self.context.enable)(moderngl.RASTERIZER_DISCARD)

    def show(self) -> None:
        """Put the finished picture on screen, if there is one. What is drawn on takes the window's size by that."""
        if self.filled or self._shown != self.size:
            pygame.display.flip()
            self._shown = self.size
        self.context.disable(moderngl.RASTERIZER_DISCARD)

    def save(self, path: Path) -> None:
        """Write what was drawn last, before `show`, as a PNG file."""
        from sandbox.render.image import save_png

        save_png(self.picture(), path)

    def picture(self) -> Any:
        """What was drawn last, before `show`, as a Pillow image."""
        from PIL import Image

        viewport = (0, 0, *self.size)
        pixels = self.context.screen.read(viewport=viewport, components=3, alignment=1)
        _ = self.context.error  # reading the window leaves a stale error flag, which ImGui's painter would raise
        return Image.frombytes("RGB", self.size, pixels).transpose(Image.Transpose.FLIP_TOP_BOTTOM)

    def close(self) -> None:
        """Close the window."""
        pygame.display.quit()

    def __enter__(self) -> Display:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def check_size(size: Size) -> None:
    """Raise `SandboxError` for a window that nobody could use."""
    if size[0] < SMALLEST[0] or size[1] < SMALLEST[1] or max(size) > LARGEST:
        low, high = f"{SMALLEST[0]}x{SMALLEST[1]}", f"{LARGEST}x{LARGEST}"
        raise SandboxError(f"a window of {size[0]}x{size[1]} pixels is not possible; it can be {low} to {high}")


def _ask_for_core_profile() -> None:
    attributes = {
        pygame.GL_CONTEXT_MAJOR_VERSION: 3,
        pygame.GL_CONTEXT_MINOR_VERSION: 3,
        pygame.GL_CONTEXT_PROFILE_MASK: pygame.GL_CONTEXT_PROFILE_CORE,
        pygame.GL_MULTISAMPLEBUFFERS: 0,  # edges are smooth without
    }
    if sys.platform == "darwin":
        attributes[pygame.GL_CONTEXT_FLAGS] = pygame.GL_CONTEXT_FORWARD_COMPATIBLE_FLAG
    for name, value in attributes.items():
        pygame.display.gl_set_attribute(name, value)


def _context() -> Any:
    """moderngl's view of the window's OpenGL context, by GLX, EGL or whatever made it."""
    moderngl.init_context()
    context = moderngl.get_context()
    if context.version_code < 330:
        raise RuntimeError(f"the driver offers only OpenGL {context.version_code / 100:.1f}")
    return context


def _open(size: Size, vsync: bool) -> None:
    flags = pygame.OPENGL | pygame.DOUBLEBUF | pygame.RESIZABLE
    if vsync:
        try:
            pygame.display.set_mode(size, flags, vsync=1)
            return
        except pygame.error:
            pass  # not every driver can wait for the screen
    pygame.display.set_mode(size, flags)
