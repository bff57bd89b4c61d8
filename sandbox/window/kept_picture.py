"""The last picture of the scene, so that one in which nothing changes need not be drawn again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import moderngl

from sandbox.render.camera import Size
from sandbox.render.draw_list import DrawList
from sandbox.window.quads import shader

Rect = tuple[int, int, int, int]


class KeptPicture:
    """A picture that comes a second time is kept from then on, as long as it stays the same: what changes all the time
    costs nothing more.
    """

    def __init__(self, context: Any, size: Size, before: KeptPicture | None = None) -> None:
        """For a window of `size` pixels; the memory of the one `before` is given back."""
        if before is not None:
            before.release()
        self.size = size
        self._context = context
        self._texture = context.texture(size, 3)
        self._target = context.framebuffer([self._texture])
        self._program = context.program(shader("kept.vert.glsl"), shader("kept.frag.glsl"))
        self._all = context.vertex_array(self._program, [])
        self._of: tuple[DrawList, Rect] | None = None
        self._full = False

    def show(self, picture: DrawList, rect: Rect, begin: Callable[[], None], draw: Callable[[], None]) -> None:
        """Put a picture on the window: `begin` makes the window what is drawn on, `draw` draws the picture."""
        if self._of is None or self._of[0] is not picture or self._of[1] != rect:
            self._of, self._full = (picture, rect), False
            draw()
            return
        if not self._full:
            self._target.use()
            draw()
            self._full = True
            begin()
        self._context.disable(moderngl.BLEND)
        self._texture.use(0)
        self._all.render(moderngl.TRIANGLES, vertices=3)

    def release(self) -> None:
        """Give the memory back."""
        for part in (self._all, self._program, self._target, self._texture):
            part.release()
