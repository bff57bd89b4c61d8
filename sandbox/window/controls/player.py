"""The player's hands: what is held on keyboard, gamepad and mouse becomes commands for the controls of a scene."""

from __future__ import annotations

from typing import Any

import pygame

from sandbox.engine.commands.control import Control
from sandbox.engine.views.game import ControlState
from sandbox.render.camera import Vec
from sandbox.window.controls.inputs import Input, read
from sandbox.window.workspace import Workspace

LABEL = "Play"
"""What the acts of a player are called when they are undone."""
WATCHED = (
    pygame.KEYDOWN, pygame.KEYUP, pygame.CONTROLLERBUTTONDOWN, pygame.CONTROLLERBUTTONUP, pygame.CONTROLLERAXISMOTION,
)  # fmt: skip


class Player:
    """Notes what is held, and before each step tells the world of every control whose value is another one now."""

    def __init__(self, workspace: Workspace) -> None:
        self.workspace = workspace
        self._held: dict[Input, float] = {}
        self._fresh = False
        self._pointer: Vec | None = None
        self._pads: list[Any] = []
        if any(control.pad for control in self.controls):
            self._open_pads()

    @property
    def controls(self) -> tuple[ControlState, ...]:
        """Those of the scene."""
        return self.workspace.session.world.controls

    def wants(self, event: pygame.event.Event) -> bool:
        """Note an event; whether a control of the scene is moved by it."""
        found = read(event)
        if found is None or event.type not in (*WATCHED, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP):
            return False
        of, value = found
        if not any(of in inputs(control) for control in self.controls):
            return False
        if self._held.get(of, 0.0) != value:
            self._held[of], self._fresh = value, True
        return True

    def point(self, at: Vec) -> None:
        """The mouse is over another point of the plane (m)."""
        if any("move" in control.mouse for control in self.controls):
            self._pointer, self._fresh = at, True
        else:
            self._pointer = at

    def let_go(self) -> None:
        """Nothing is held any more."""
        self._fresh = self._fresh or any(self._held.values())
        self._held.clear()

    def play(self) -> None:
        """Before a step: tell the world what has changed since the last one."""
        if not self._fresh:
            return
        self._fresh = False
        for control in self.controls:
            value = self._value(control)
            told = "move" in control.mouse and self._pointer is not None and self._pointer != control.pointer
            if value != control.value or told:
                self._send(Control(control.id, value, self._pointer if control.mouse else None))

    def _send(self, command: Control) -> None:
        timeline = self.workspace.session.timeline
        if timeline.undo_label != LABEL or not timeline.at_end:
            timeline.begin_act(LABEL)
        with self.workspace.attempt("not played"):
            timeline.apply(command)

    def _value(self, control: ControlState) -> float:
        """From -1 to 1: what is held most, keys before all else."""
        plus = max((self._held.get(("key", name), 0.0) for name in control.keys), default=0.0)
        minus = max((self._held.get(("key", name), 0.0) for name in control.minus), default=0.0)
        if plus != minus:
            return plus - minus
        others = [self._held.get(of, 0.0) for of in inputs(control) if of[0] != "key"]
        return max(others, key=abs, default=0.0)

    def _open_pads(self) -> None:
        """Gamepads send nothing before they are opened."""
        from pygame._sdl2 import controller

        try:
            controller.init()
            self._pads = [
                controller.Controller(n) for n in range(controller.get_count()) if controller.is_controller(n)
            ]
        except pygame.error:
            self._pads = []  # a system without gamepads


def inputs(control: ControlState) -> tuple[Input, ...]:
    """What moves a control."""
    return (
        *(("key", name) for name in (*control.keys, *control.minus)),
        *(("pad", name) for name in control.pad),
        *(("mouse", name) for name in control.mouse if name != "move"),
    )
