"""Scripted hands: real events of keys and mouse from a file, so that the window can be tried without a person.

A line is one act; `#` begins a comment. A place is `X,Y` in pixels of the window, `@X,Y` in metres of the scene, or the
name of a widget (`world.gravity.moon`). After each act the window draws a picture.

    key Ctrl+Z              press and release keys
    type 9.81               write text
    move PLACE              the pointer goes there
    click PLACE             left button; `click right PLACE` the other one
    double PLACE            twice
    drag PLACE to PLACE [in N]    with the left button, over N pictures (12)
    hold KEY for N          keep a key down for N pictures
    hold Shift              until `let Shift`; Ctrl likewise
    press left              keep a button down until `let left`; `move` drags meanwhile
    drop FILE               a file falls onto the window
    wheel N [PLACE]         turn the wheel by N notches
    wait N                  let N pictures pass
    shot FILE.png           save a picture of the window
    film FILE.gif           every fourth picture from here on, until `cut`, as a film of 15 a second
    quit                    close the window
"""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pygame

from sandbox.errors import SandboxError
from sandbox.window.keys import chord, split
from sandbox.window.reel import Reel
from sandbox.window.widgets import hidden, places

Locate = Callable[[tuple[float, float]], tuple[float, float]]
"""The pixel of the window over a point of the scene in metres."""
_MODS = {"Ctrl": pygame.KMOD_LCTRL, "Shift": pygame.KMOD_LSHIFT}
_MOD_KEYS = {"Ctrl": pygame.K_LCTRL, "Shift": pygame.K_LSHIFT}
ACTS = ("key", "type", "move", "click", "double", "hold", "press", "let", "drop", "wheel", "wait", "shot", "film")
"""Those that need a word."""
_BUTTONS = {"left": 1, "middle": 2, "right": 3}
_HANDS = {
    pygame.KEYDOWN, pygame.KEYUP, pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEWHEEL,
}  # fmt: skip
_NUMBERS = {"wait": 0, "wheel": 0, "hold": 2, "drag": 4}
"""Which word after an act is a whole number."""
DRAG_PICTURES = 12
TRIES = 20
"""How often the hand goes after a widget that moves."""


def is_stray(event: pygame.event.Event) -> bool:
    """Whether it comes from a real mouse or keyboard: where a script has the window, these would spoil what it does."""
    return event.type in _HANDS and not getattr(event, "scripted", False)


class Script:
    """The acts of a file, one generator step a picture. `shots` are pictures that are asked for."""

    def __init__(self, path: Path) -> None:
        """Read and check a file. Raises `SandboxError` with the line of the first mistake, `OSError`."""
        self.path = path
        self.shots: list[Path] = []
        self.reel: Reel | None = None
        """The film that is being shot."""
        self._mods = 0
        self._at = (0.0, 0.0)
        self._acts = [
            (number, words)
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
            if (words := self._words(number, line))
        ]
        for number, words in self._acts:
            self._check(number, words)

    def hands(self, locate: Locate) -> Iterator[None]:
        """Do all acts; yields where a picture is to be drawn. Raises `SandboxError` for a widget that is not there."""
        yield from [None] * 2  # the first picture tells where widgets are
        for number, words in self._acts:
            name, *rest = words
            yield from getattr(self, f"_{name}")(number, rest, locate)
            yield

    def _words(self, number: int, line: str) -> list[str]:
        try:
            return shlex.split(line, comments=True)
        except ValueError as error:
            raise self._error(number, f"{error}; check the quotes") from None

    def _check(self, number: int, words: list[str]) -> None:
        name, *rest = words
        least = {"drag": 3, "quit": 0, "cut": 0, **dict.fromkeys(ACTS, 1)}
        if name not in least:
            raise self._error(number, f"there is no act {name!r}; there are {', '.join(least)}")
        if len(rest) < least[name]:
            raise self._error(number, f"{name!r} needs {least[name]} words after it")
        if name == "let" and rest[0] not in {**_MODS, **_BUTTONS}:
            raise self._error(number, f"only {', '.join({**_MODS, **_BUTTONS})} are let, not {rest[0]!r}")
        if name == "key" or (name == "hold" and rest[0] not in _MODS):
            try:
                chord(rest[0])
            except ValueError as error:
                raise self._error(number, str(error)) from None
        where = _NUMBERS.get(name, len(rest))
        if where < len(rest) and not rest[where].removeprefix("-").isdecimal():
            raise self._error(number, f"{name!r} takes a whole number there, not {rest[where]!r}")

    def _error(self, number: int, text: str) -> SandboxError:
        return SandboxError(f"{self.path}:{number}: {text}")

    def _place(self, number: int, text: str, locate: Locate) -> tuple[int, int]:
        if text in hidden:
            raise self._error(number, f"{text!r} is scrolled out of sight: turn the wheel over what it is in before")
        if text in places:
            left, top, right, bottom = places[text]
            return round((left + right) / 2), round((top + bottom) / 2)
        try:
            x, y = map(float, text.removeprefix("@").split(","))
        except ValueError:
            near = ", ".join(sorted(name for name in places if name.split(".")[0] == text.split(".")[0])) or "none"
            raise self._error(number, f"there is no place {text!r} in the window now; of its kind: {near}") from None
        x, y = locate((x, y)) if text.startswith("@") else (x, y)
        return round(x), round(y)

    def _post(self, kind: int, **given: Any) -> None:
        pygame.event.post(pygame.event.Event(kind, scripted=True, **given))

    def _press_key(self, key: int, text: str, down: bool) -> None:
        kind = pygame.KEYDOWN if down else pygame.KEYUP
        self._post(kind, key=key, unicode=text if down else "", mod=self._mods, scancode=0)

    def _key(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        held = split(words[0])[0]
        before = self._mods
        for name in held:
            self._mods |= _MODS.get(name, 0)
            self._press_key(_MOD_KEYS[name], "", True)
        one = chord(words[0])
        typed = one.character or (chr(one.key) if 32 <= one.key < 127 and not self._mods & pygame.KMOD_CTRL else "")
        self._press_key(one.key, typed, True)
        yield
        self._press_key(one.key, typed, False)
        for name in held:
            self._press_key(_MOD_KEYS[name], "", False)
        self._mods = before

    def _type(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        for character in " ".join(words):
            self._press_key(ord(character), character, True)
            self._press_key(ord(character), character, False)
            yield

    def _go(self, to: tuple[int, int], buttons: tuple[int, int, int] = (0, 0, 0)) -> None:
        by = round(to[0] - self._at[0]), round(to[1] - self._at[1])
        self._at = to
        self._post(pygame.MOUSEMOTION, pos=to, rel=by, buttons=buttons)

    def _reach(self, number: int, place: str, locate: Locate) -> Iterator[None]:
        """Go to a place, and after it if it moves meanwhile, as widgets do when something comes above them."""
        for _ in range(TRIES):
            to = self._place(number, place, locate)
            self._go(to)
            yield from [None] * 2
            if self._place(number, place, locate) == to:
                return

    def _button(self, number: int, down: bool) -> None:
        kind = pygame.MOUSEBUTTONDOWN if down else pygame.MOUSEBUTTONUP
        self._post(kind, pos=(round(self._at[0]), round(self._at[1])), button=number)

    def _move(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        self._go(self._place(number, words[0], locate))
        yield

    def _click(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        which = _BUTTONS[words[0]] if words[0] in _BUTTONS and len(words) > 1 else 1
        yield from self._reach(number, words[-1], locate)
        self._button(which, True)
        yield from [None] * 2
        self._button(which, False)
        yield

    def _double(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        for _ in range(2):
            yield from self._click(number, words, locate)

    def _drag(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        pictures = int(words[4]) if len(words) > 4 and words[3] == "in" else DRAG_PICTURES
        yield from self._reach(number, words[0], locate)
        start = self._at
        end = self._place(number, words[2], locate)
        self._button(1, True)
        yield from [None] * 2
        for step in range(1, pictures + 1):
            share = step / pictures
            x, y = start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])
            self._go((round(x), round(y)), (1, 0, 0))
            yield
        self._button(1, False)
        yield

    def _hold(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        if words[0] in _MODS:
            self._mods |= _MODS[words[0]]
            self._press_key(_MOD_KEYS[words[0]], "", True)
            pygame.key.set_mods(self._mods)
            yield
            return
        one = chord(words[0])
        self._press_key(one.key, one.character, True)
        yield from [None] * (int(words[2]) if len(words) > 2 else 1)
        self._press_key(one.key, one.character, False)

    def _press(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        yield from [None] * 2
        self._button(_BUTTONS.get(words[0], 1), True)
        yield

    def _let(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        if words[0] in _BUTTONS:
            self._button(_BUTTONS[words[0]], False)
            yield
            return
        self._mods &= ~_MODS[words[0]]
        self._press_key(_MOD_KEYS[words[0]], "", False)
        pygame.key.set_mods(self._mods)
        yield

    def _wheel(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        if len(words) > 1:
            self._go(self._place(number, words[1], locate))
            yield
        turns = int(words[0])
        self._post(pygame.MOUSEWHEEL, x=0, y=turns, precise_x=0.0, precise_y=float(turns), flipped=False)
        yield

    def _wait(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        yield from [None] * int(words[0])

    def _drop(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        self._post(pygame.DROPFILE, file=words[0])
        yield

    def _shot(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        self.shots.append(Path(words[0]))
        yield

    def _film(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        self.reel = Reel(Path(words[0]))
        yield

    def _cut(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        if self.reel is not None:
            self.reel.save()
        self.reel = None
        yield

    def _quit(self, number: int, words: list[str], locate: Locate) -> Iterator[None]:
        self._post(pygame.QUIT)
        yield
