"""The thrusters of the selected body: what they push with, and whether they do."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.set_thruster import SetThruster
from sandbox.tables import plain
from sandbox.window.editor import Editor, Entry, Vec
from sandbox.window.widgets import Scale
from sandbox.window.workspace import Workspace


def thrusters_of(workspace: Workspace, body: int) -> Any:
    """The rows of a body's thrusters."""
    return np.flatnonzero(plain(workspace.session.world.state.thrusters)["body"] == body)


def draw_thrusters(workspace: Workspace, editor: Editor, name: str, rows: Any) -> None:
    """Force and switch of each of the thrusters `rows` of the body `name`."""
    world = workspace.session.world
    table = plain(world.state.thrusters)
    for number, row in enumerate(rows):
        one = table[row]

        def push(force: Vec, number: int = number) -> Iterable[Command]:
            return [SetThruster(name, force=force, thruster=number)]

        def switch(on: bool, number: int = number) -> Iterable[Command]:
            return [SetThruster(name, enabled=on, thruster=number)]

        acts = bool(one["start_step"] <= world.step_count < one["end_step"])
        title = f"thruster {number + 1}" if len(rows) > 1 else "on"
        tip = f"Pushes at {one['local_x']:.4g}, {one['local_y']:.4g} m from the centre of mass, in the body's frame."
        editor.switch(workspace, Entry(f"inspector.thruster.{number}.on", title, tip=tip), acts, switch)
        entry = Entry(f"inspector.thruster.{number}.force", "force", Scale("N", 0.1, digits=5), "In the body's frame.")
        editor.pair(workspace, entry, [(float(one["force_x"]), float(one["force_y"]))], push)
