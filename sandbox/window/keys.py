"""Keys by name, as menus and the help write them: "Space", "Ctrl+Shift+S", "."."""

from __future__ import annotations

from dataclasses import dataclass

import pygame

from sandbox.scene.near_names import did_you_mean

_NAMED = {
    "Space": pygame.K_SPACE, "Esc": pygame.K_ESCAPE, "Tab": pygame.K_TAB, "Enter": pygame.K_RETURN,
    "Delete": pygame.K_DELETE, "Backspace": pygame.K_BACKSPACE, "Home": pygame.K_HOME, "End": pygame.K_END,
    "PageUp": pygame.K_PAGEUP, "PageDown": pygame.K_PAGEDOWN,
    "Left": pygame.K_LEFT, "Right": pygame.K_RIGHT, "Up": pygame.K_UP, "Down": pygame.K_DOWN,
    **{f"F{n}": getattr(pygame, f"K_F{n}") for n in range(1, 13)},
}  # fmt: skip
_BY_NAME = {name.casefold(): key for name, key in _NAMED.items()}
_KEYPAD = {"+": pygame.K_KP_PLUS, "-": pygame.K_KP_MINUS, ".": pygame.K_KP_PERIOD}


@dataclass(frozen=True)
class Chord:
    """One key with the modifiers that must be held. Where `character` is given, what the key types counts instead."""

    key: int
    character: str = ""
    ctrl: bool = False
    shift: bool = False

    def matches(self, event: pygame.event.Event) -> bool:
        """Whether a key press means it. Marks lie on other keys in other layouts, so these go by their character."""
        mods = getattr(event, "mod", 0)
        if bool(mods & (pygame.KMOD_CTRL | pygame.KMOD_META)) != self.ctrl or mods & pygame.KMOD_ALT:
            return False
        if self.character:
            return bool(event.unicode == self.character or event.key == _KEYPAD.get(self.character))
        return bool(event.key == self.key) and bool(mods & pygame.KMOD_SHIFT) == self.shift


def split(text: str) -> tuple[list[str], str]:
    """The modifiers and the last key of a chord's text, which may be "+" itself: "Ctrl++"."""
    *held, last = [text] if len(text) == 1 else text.replace("++", "+\0").split("+")
    return held, "+" if last == "\0" else last


def chord(text: str) -> Chord:
    """The chord that a text such as "Ctrl+Z" means. Raises `ValueError`."""
    held, last = split(text)
    if unknown := [name for name in held if name not in ("Ctrl", "Shift")]:
        raise ValueError(f"there is no key {unknown[0]!r} to hold; there are Ctrl and Shift")
    ctrl, shift = "Ctrl" in held, "Shift" in held
    if last.casefold() in _BY_NAME:
        return Chord(_BY_NAME[last.casefold()], "", ctrl, shift)
    if len(last) != 1:
        hint = did_you_mean(last, _NAMED)
        raise ValueError(f"there is no key {last!r}{f'; {hint}' * bool(hint)}")
    mark = not last.isalnum()
    return Chord(ord(last.lower()), last if mark else "", ctrl, shift)


def key_of(text: str) -> int:
    """SDL's number of the key that a chord's text names, whatever its modifiers."""
    return chord(text).key
