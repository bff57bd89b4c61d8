"""The window of the tests in other sizes."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pygame

LARGEST = (1280, 1000)
"""No test may ask for more: off screen, what is drawn on keeps the size with which it was opened."""


@contextmanager
def window_of(size: tuple[int, int]) -> Iterator[None]:
    """The open window has `size` pixels meanwhile."""
    assert max(size[0] - LARGEST[0], size[1] - LARGEST[1]) <= 0, size
    window = _window()
    before, window.size = window.size, size
    pygame.event.get()
    try:
        yield
    finally:
        window.size = before
        pygame.event.get()


def _window() -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        from pygame._sdl2.video import Window

        return Window.from_display_module()
