"""Numbers and switches of what is selected: a change is a command, and all changes of one drag are one act."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.engine.commands.base import Command
from sandbox.window.adjustment import Adjustment
from sandbox.window.widgets import PLAIN, Scale, button, checkbox, drag, drag2, label
from sandbox.window.workspace import Workspace

Vec = tuple[float, float]


@dataclass(frozen=True)
class Entry:
    """A number of what is selected: the widget's name, what it is called, how it is shown, its tooltip."""

    name: str
    title: str
    scale: Scale = PLAIN
    tip: str = ""


class Editor:
    """Draws entries of the inspector. `of` says whose they are, for the names of acts."""

    def __init__(self) -> None:
        self.of = ""
        self._adjustment = Adjustment("Edit")

    def number(
        self, workspace: Workspace, entry: Entry, values: Any, commands: Callable[[float], Iterable[Command]]
    ) -> None:
        """One number. `values` are those of all that is selected; `commands` give all of them another one."""
        label(entry.title, entry.tip)
        scale = _scale(entry, is_mixed(values))
        changed, value = drag(entry.name, "", scale.shown(values[0]), entry.tip, scale)
        given = tuple(commands(value)) if changed else ()
        self._adjustment.follow(workspace, changed, *given, label=self._label(entry))

    def pair(
        self, workspace: Workspace, entry: Entry, values: Any, commands: Callable[[Vec], Iterable[Command]]
    ) -> None:
        """Two numbers, x and y; the one that is not touched keeps all its digits."""
        label(entry.title, entry.tip)
        now, mixed = (float(values[0][0]), float(values[0][1])), is_mixed(values)
        scale = _scale(entry, mixed)
        shown = scale.shown(now[0]), scale.shown(now[1])
        changed, (x, y) = drag2(entry.name, "", shown, entry.tip, scale)
        given = tuple(commands((kept(now[0], shown[0], x), kept(now[1], shown[1], y)))) if changed else ()
        self._adjustment.follow(workspace, changed, *given, label=self._label(entry))

    def switch(
        self, workspace: Workspace, entry: Entry, value: bool, commands: Callable[[bool], Iterable[Command]]
    ) -> None:
        """On or off, in the right column."""
        label(entry.title, entry.tip)
        wanted = checkbox(entry.name, "", value, entry.tip)
        if wanted != value:
            workspace.do(self._label(entry), *commands(wanted))

    def optional(
        self,
        workspace: Workspace,
        entry: Entry,
        value: float | None,
        start: float,
        commands: Callable[[float | None], Iterable[Command]],
    ) -> None:
        """A number that may be missing: a box to tick, which begins with `start`, and the number beside it."""
        label(entry.title, entry.tip)
        wanted = checkbox(f"{entry.name}.on", "", value is not None, entry.tip)
        if wanted != (value is not None):
            workspace.do(self._label(entry), *commands(start if wanted else None))
        elif value is not None:
            imgui.same_line()
            self._drag(workspace, entry, value, -1.0, commands)

    def ceiling(
        self,
        workspace: Workspace,
        entry: Entry,
        value: float,
        start: float,
        commands: Callable[[float], Iterable[Command]],
    ) -> None:
        """A number that may be infinite: a button that gives it `start`, or the number and one that takes it away."""
        label(entry.title, entry.tip)
        if math.isinf(value):
            tip = f"{entry.tip}\nBegins with {start:g} {entry.scale.unit}."
            if button(f"{entry.name}.set", "no limit: set one", tip, width=-1.0):
                workspace.do(self._label(entry), *commands(start))
            return
        side = imgui.get_frame_height()
        wide = imgui.get_content_region_avail().x - side - imgui.get_style().item_inner_spacing.x
        self._drag(workspace, entry, value, wide, commands)
        imgui.same_line(0.0, imgui.get_style().item_inner_spacing.x)
        if button(f"{entry.name}.none", icons.ICON_FA_XMARK, "No limit.", width=side):
            workspace.do(self._label(entry), *commands(math.inf))

    def _drag(
        self,
        workspace: Workspace,
        entry: Entry,
        value: float,
        width: float,
        commands: Callable[[float], Iterable[Command]],
    ) -> None:
        """The number itself, `width` pixels wide, or with -1 as wide as there is room."""
        imgui.set_next_item_width(width)
        changed, got = drag(entry.name, "", value, entry.tip, entry.scale)
        given = tuple(commands(got)) if changed else ()
        self._adjustment.follow(workspace, changed, *given, label=self._label(entry))

    def _label(self, entry: Entry) -> str:
        title = entry.title[:1].upper() + entry.title[1:]
        return f"{title} of {self.of}"


def _scale(entry: Entry, mixed: bool) -> Scale:
    return replace(entry.scale, mixed=mixed)


def is_mixed(values: Any) -> bool:
    """Whether not all values are the same."""
    rows = np.asarray(values, float)
    return bool((rows != rows[0]).any())


def kept(before: float, shown: float, after: float) -> float:
    """The number after an edit: the one before with all its digits, if a widget shows what it showed before."""
    return before if shown == after else after
