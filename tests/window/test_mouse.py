from __future__ import annotations

from pathlib import Path

import pygame
import pytest

from sandbox.render.camera import Camera
from sandbox.window.actions.registry import ACTIONS, action_of
from sandbox.window.mouse import Mouse
from sandbox.window.panels.registry import new_panels
from sandbox.window.session import Session
from sandbox.window.tools.registry import new_tools
from sandbox.window.tools.tool_box import ToolBox
from sandbox.window.viewport import Viewport
from sandbox.window.workspace import Workspace
from tests.window.test_session import SCENE

CAMERA = Camera((2.0, 2.0), 50.0, (800, 600))


@pytest.fixture
def mouse() -> Mouse:
    viewport = Viewport((0, 0, 800, 600), CAMERA, touched=True)
    workspace = Workspace(Session(SCENE), viewport, Path())
    return Mouse(workspace, ToolBox(workspace))


def pixel(x: float, y: float) -> tuple[int, int]:
    column, row = CAMERA.to_screen((x, y))
    return round(column), round(row)


def press(mouse: Mouse, button: int, at: tuple[int, int]) -> None:
    mouse.handle(pygame.event.Event(pygame.MOUSEBUTTONDOWN, button=button, pos=at))


def release(mouse: Mouse, button: int, at: tuple[int, int]) -> None:
    mouse.handle(pygame.event.Event(pygame.MOUSEBUTTONUP, button=button, pos=at))


def drag_to(mouse: Mouse, at: tuple[int, int], rel: tuple[int, int]) -> None:
    mouse.handle(pygame.event.Event(pygame.MOUSEMOTION, pos=at, rel=rel, buttons=(1, 0, 0)))


def test_the_left_button_drags_a_body(mouse: Mouse) -> None:
    press(mouse, 1, pixel(4.0, 3.0))
    drag_to(mouse, pixel(5.0, 4.0), (50, -50))
    assert mouse.workspace.session.grip.body == 2
    assert mouse.workspace.session.grip.target == pytest.approx((5.0, 4.0))
    assert mouse.workspace.viewport.camera == CAMERA
    strokes = mouse.strokes()
    assert strokes[0].start == pytest.approx(pixel(4.0, 3.0))
    assert strokes[0].end == pytest.approx(pixel(5.0, 4.0))
    release(mouse, 1, pixel(5.0, 4.0))
    assert mouse.workspace.session.grip.body is None
    assert not mouse.strokes()


@pytest.mark.parametrize(("button", "start"), [(1, (2.0, 4.5)), (2, (4.0, 3.0)), (3, (4.0, 3.0))])
def test_other_buttons_and_empty_space_pan(mouse: Mouse, button: int, start: tuple[float, float]) -> None:
    press(mouse, button, pixel(*start))
    drag_to(mouse, (0, 0), (30, -20))
    assert mouse.workspace.viewport.camera == CAMERA.panned(30, -20)
    assert mouse.workspace.viewport.touched
    release(mouse, button, (0, 0))
    drag_to(mouse, (10, 10), (10, 10))
    assert mouse.workspace.viewport.camera == CAMERA.panned(30, -20)
    assert mouse.workspace.session.grip.body is None


def test_zoom_keeps_what_is_under_the_cursor(mouse: Mouse) -> None:
    before = mouse.workspace.viewport.camera.point((100.0, 50.0))
    mouse.workspace.viewport.zoom(2.0, (100.0, 50.0))
    assert mouse.workspace.viewport.camera.scale == 100.0
    assert mouse.workspace.viewport.camera.point((100.0, 50.0)) == pytest.approx(before)


@pytest.mark.parametrize(
    ("key", "character", "mod", "action"),
    [
        (pygame.K_SPACE, " ", 0, "pause"),
        (pygame.K_PERIOD, ".", 0, "step"),
        (pygame.K_SEMICOLON, ".", 0, "step"),  # another keyboard layout
        (pygame.K_KP_PERIOD, ".", 0, "step"),
        (pygame.K_r, "r", 0, "restart"),
        (pygame.K_s, "s", 0, "save"),
        (pygame.K_z, "\x1a", pygame.KMOD_LCTRL, "undo"),
        (pygame.K_z, "\x1a", pygame.KMOD_LCTRL | pygame.KMOD_LSHIFT, "redo"),
        (pygame.K_ESCAPE, "\x1b", 0, "leave"),
        (pygame.K_MINUS, "-", 0, "slower"),
        (pygame.K_PLUS, "+", 0, "faster"),
        (pygame.K_EQUALS, "+", pygame.KMOD_LSHIFT, "faster"),
        (pygame.K_z, "z", 0, None),
        (pygame.K_r, "r", pygame.KMOD_LALT, None),
    ],
)
def test_keys_mean_actions(key: int, character: str, mod: int, action: str | None) -> None:
    meant = action_of(pygame.event.Event(pygame.KEYDOWN, key=key, unicode=character, mod=mod))
    assert (meant.name if meant else None) == action


def test_no_key_means_two_things() -> None:
    keys = [key for action in ACTIONS for key in action.keys]
    keys += [one.key for one in (*new_tools().values(), *new_panels().values()) if one.key]
    assert sorted(keys) == sorted(set(keys))
    names = [one.name for one in (*ACTIONS, *new_tools().values(), *new_panels().values())]
    assert len(names) == len(set(names))
