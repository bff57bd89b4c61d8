"""A window to test in: on the screen if there is one, else out of sight, else the test is skipped."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from sandbox.errors import MissingDependencyError
from sandbox.window.requirements import check_packages

SIZE = (480, 300)


@pytest.fixture(scope="session")
def display() -> Iterator[object]:
    """A window with OpenGL of `SIZE` pixels, open until the last test."""
    try:
        check_packages()
        from sandbox.window.display import Display
        from tests.window.resizing import LARGEST, window_of

        opened = Display(LARGEST, "test", visible=False)
        opened.watched = False  # of most pictures nobody reads a pixel
    except MissingDependencyError as error:
        pytest.skip(f"no window can be opened here: {error}")
    with opened, window_of(SIZE):
        yield opened


@pytest.fixture
def canvas(display: Any) -> Iterator[object]:
    """What a screen is drawn on: that window, dark, with panels of its own."""
    from sandbox.render.theme import DARK
    from sandbox.window.gl_painter import GlPainter
    from sandbox.window.gui import Gui
    from sandbox.window.screen import Canvas

    gui = Gui(display.driver)
    yield Canvas(display, GlPainter(display.context), gui, DARK)
    gui.close()


@pytest.fixture(autouse=True)
def _state(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Sessions and recent files of tests are not those of whoever runs them."""
    monkeypatch.setenv("SANDBOX_STATE_DIR", str(tmp_path_factory.mktemp("state")))
