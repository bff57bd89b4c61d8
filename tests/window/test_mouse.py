from __future__ import annotations

import pygame
import pytest

import sandbox
from sandbox.render.camera import Camera
from sandbox.render.theme import DARK
from sandbox.window.keys import BINDINGS, action_of, help_items
from sandbox.window.mouse import Mouse
from sandbox.window.session import Session
from tests.window.test_session import SCENE

CAMERA = Camera((2.0, 2.0), 50.0, (800, 600))


@pytest.fixture
def mouse() -> Mouse:
    return Mouse(Session(SCENE, sandbox.World(SCENE)), CAMERA)


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
    assert mouse.session.grabbed == 2
    assert mouse.session.target == pytest.approx((5.0, 4.0))
    assert mouse.camera == CAMERA
    strokes = mouse.strokes(mouse.session.frame(), DARK)
    assert strokes[0].start == pytest.approx(pixel(4.0, 3.0))
    assert strokes[0].end == pytest.approx(pixel(5.0, 4.0))
    release(mouse, 1, pixel(5.0, 4.0))
    assert mouse.session.grabbed is None
    assert mouse.strokes(mouse.session.frame(), DARK) == []


@pytest.mark.parametrize(("button", "start"), [(1, (2.0, 4.5)), (2, (4.0, 3.0)), (3, (4.0, 3.0))])
def test_other_buttons_and_empty_space_pan(mouse: Mouse, button: int, start: tuple[float, float]) -> None:
    press(mouse, button, pixel(*start))
    drag_to(mouse, (0, 0), (30, -20))
    assert mouse.camera == CAMERA.panned(30, -20)
    assert mouse.touched
    release(mouse, button, (0, 0))
    drag_to(mouse, (10, 10), (10, 10))
    assert mouse.camera == CAMERA.panned(30, -20)
    assert mouse.session.grabbed is None


def test_zoom_keeps_what_is_under_the_cursor(mouse: Mouse) -> None:
    before = mouse.camera.point((100.0, 50.0))
    mouse.zoom(2.0, (100.0, 50.0))
    assert mouse.camera.scale == 100.0
    assert mouse.camera.point((100.0, 50.0)) == pytest.approx(before)


@pytest.mark.parametrize(
    ("key", "character", "action"),
    [
        (pygame.K_SPACE, " ", "pause"),
        (pygame.K_PERIOD, ".", "step"),
        (pygame.K_SEMICOLON, ".", "step"),  # another keyboard layout
        (pygame.K_r, "r", "restart"),
        (pygame.K_ESCAPE, "\x1b", "leave"),
        (pygame.K_MINUS, "-", "slower"),
        (pygame.K_z, "z", None),
    ],
)
def test_keys_mean_actions(key: int, character: str, action: str | None) -> None:
    assert action_of(pygame.event.Event(pygame.KEYDOWN, key=key, unicode=character)) == action


def test_every_listed_binding_is_in_the_help() -> None:
    listed = {binding.help for binding in BINDINGS if binding.label}
    assert listed <= {text for _, text in help_items()}
