"""Keys, buttons and axes by the names that scenes call them, and how far each is held."""

from __future__ import annotations

import pygame

DEAD_ZONE = 0.15
"""Share of an axis about its middle that counts as not touched."""
NOTCHES = 32
"""Values of an axis from 0 to 1: fewer make recordings shorter, more make them finer."""
AXIS_END = 32767.0
_PAD_BUTTONS = {
    pygame.CONTROLLER_BUTTON_A: "a", pygame.CONTROLLER_BUTTON_B: "b", pygame.CONTROLLER_BUTTON_X: "x",
    pygame.CONTROLLER_BUTTON_Y: "y", pygame.CONTROLLER_BUTTON_LEFTSHOULDER: "left bumper",
    pygame.CONTROLLER_BUTTON_RIGHTSHOULDER: "right bumper", pygame.CONTROLLER_BUTTON_BACK: "back",
    pygame.CONTROLLER_BUTTON_START: "start", pygame.CONTROLLER_BUTTON_DPAD_UP: "up",
    pygame.CONTROLLER_BUTTON_DPAD_DOWN: "down", pygame.CONTROLLER_BUTTON_DPAD_LEFT: "left",
    pygame.CONTROLLER_BUTTON_DPAD_RIGHT: "right",
}  # fmt: skip
_PAD_AXES = {
    pygame.CONTROLLER_AXIS_LEFTX: ("left stick x", 1.0), pygame.CONTROLLER_AXIS_LEFTY: ("left stick y", -1.0),
    pygame.CONTROLLER_AXIS_RIGHTX: ("right stick x", 1.0), pygame.CONTROLLER_AXIS_RIGHTY: ("right stick y", -1.0),
    pygame.CONTROLLER_AXIS_TRIGGERLEFT: ("left trigger", 1.0),
    pygame.CONTROLLER_AXIS_TRIGGERRIGHT: ("right trigger", 1.0),
}  # fmt: skip
"""Names, and the sign that makes right and up positive."""
_MOUSE = {1: "left", 2: "middle", 3: "right"}

Input = tuple[str, str]
"""A device ("key", "pad" or "mouse") and a name."""


def read(event: pygame.event.Event) -> tuple[Input, float] | None:
    """Which input an event is about, and how far it is held now (-1 to 1); None if it is about none."""
    match event.type:
        case pygame.KEYDOWN | pygame.KEYUP:
            name = {"return": "enter"}.get(pygame.key.name(event.key), pygame.key.name(event.key))
            return ("key", name), float(event.type == pygame.KEYDOWN)
        case pygame.MOUSEBUTTONDOWN | pygame.MOUSEBUTTONUP if event.button in _MOUSE:
            return ("mouse", _MOUSE[event.button]), float(event.type == pygame.MOUSEBUTTONDOWN)
        case pygame.CONTROLLERBUTTONDOWN | pygame.CONTROLLERBUTTONUP if event.button in _PAD_BUTTONS:
            return ("pad", _PAD_BUTTONS[event.button]), float(event.type == pygame.CONTROLLERBUTTONDOWN)
        case pygame.CONTROLLERAXISMOTION if event.axis in _PAD_AXES:
            name, sign = _PAD_AXES[event.axis]
            return ("pad", name), sign * axis_value(event.value / AXIS_END)
    return None


def axis_value(raw: float) -> float:
    """An axis with a dead zone in its middle, in notches, from -1 to 1."""
    size = min(max((abs(raw) - DEAD_ZONE) / (1.0 - DEAD_ZONE), 0.0), 1.0)
    return round(size * NOTCHES) / NOTCHES * (1.0 if raw > 0.0 else -1.0) if size else 0.0
