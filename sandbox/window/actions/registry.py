"""All actions: keys, menus and the help are made of this table."""

from __future__ import annotations

import pygame

from sandbox.window.actions import arrange, colors, edit, file, time, view
from sandbox.window.actions.action import Action
from sandbox.window.keys import Chord, chord

MENUS = ("File", "Edit", "Arrange", "Time", "View", "Colour by", "Help")
_FILES = (file, edit, arrange, time, view, colors)
ACTIONS: tuple[Action, ...] = tuple(action for each in _FILES for action in each.ACTIONS)
BY_NAME = {action.name: action for action in ACTIONS}
_CHORDS: tuple[tuple[Chord, Action], ...] = tuple((chord(key), action) for action in ACTIONS for key in action.keys)


def action_of(event: pygame.event.Event) -> Action | None:
    """The action of a key press; None for all other events and keys."""
    if event.type != pygame.KEYDOWN:
        return None
    return next((action for keys, action in _CHORDS if keys.matches(event)), None)


def released(event: pygame.event.Event) -> set[str]:
    """The names of the held actions that a key going up may end."""
    if event.type != pygame.KEYUP:
        return set()
    return {action.name for keys, action in _CHORDS if action.held and keys.key == event.key}
