"""What keys and mouse do, as data: the window acts on this table and its help line is written from it."""

from __future__ import annotations

from dataclasses import dataclass

import pygame


@dataclass(frozen=True)
class Binding:
    """Keys that do the same thing, the action's name, and how the help line puts it (empty: not listed)."""

    keys: tuple[int, ...]
    action: str
    label: str = ""
    help: str = ""


BINDINGS = (
    Binding((pygame.K_SPACE,), "pause", "Space", "pause"),
    Binding((pygame.K_PERIOD, pygame.K_KP_PERIOD), "step", ".", "one step"),
    Binding((pygame.K_MINUS, pygame.K_KP_MINUS), "slower", "− +", "slow motion"),
    Binding((pygame.K_PLUS, pygame.K_EQUALS, pygame.K_KP_PLUS), "faster"),
    Binding((pygame.K_r,), "restart", "R", "restart"),
    Binding((pygame.K_s,), "save", "S", "save a replay"),
    Binding((pygame.K_f,), "fit", "F", "fit view"),
    Binding((pygame.K_h, pygame.K_F1), "help", "H", "help"),
    Binding((pygame.K_ESCAPE,), "leave", "Esc", "leave"),
)

MOUSE_HELP = (("Drag", "move a body"), ("Right drag", "pan"), ("Wheel", "zoom"))

_BY_KEY = {key: binding.action for binding in BINDINGS for key in binding.keys}


def action_of(event: pygame.event.Event) -> str | None:
    """The action of a key press; None for all other events and keys."""
    if event.type != pygame.KEYDOWN:
        return None
    # By character first: the full stop, minus and plus lie on other keys in other layouts.
    by_character = {".": "step", "-": "slower", "+": "faster", "=": "faster"}.get(event.unicode)
    return by_character or _BY_KEY.get(event.key)


def help_items() -> list[tuple[str, str]]:
    """(key, what it does) for the help line."""
    keys = [(binding.label, binding.help) for binding in BINDINGS if binding.label]
    return [*keys[:5], *MOUSE_HELP, *keys[5:]]
