"""The command by which bodies and joints come into a world."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Self, TypeAlias

import numpy as np

from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.commands.base import Command, CommandTarget, Touched
from sandbox.engine.commands.joint_command import held_bodies
from sandbox.errors import CommandError, SceneError
from sandbox.world.rows import add_rows

Words: TypeAlias = dict[str, Any]


@dataclass(frozen=True)
class Spawn(Command):
    """Bring bodies and joints into the world, in the words of a scene file: entries of `bodies` and of `joints`.

    Entries are dicts or the models of scenes (`sandbox.Body`, `sandbox.Revolute`); `bodies` is a list of them or a
    single one, and so is `joints`. They may use the scene's prefabs, materials and categories; joints may name bodies
    that are there already, and their anchors are places in the world of now. Ids must be new; those of deleted bodies
    and joints are. Times of thrusters count from now. As in a file, angles are in degrees.
    """

    bodies: Words | Sequence[Words] = ()
    joints: Words | Sequence[Words] = ()

    def __post_init__(self) -> None:
        for name in ("bodies", "joints"):
            object.__setattr__(self, name, _plain(getattr(self, name)))

    def checked(self) -> Self:
        """The same; raises `CommandError` unless it holds entries."""
        if not all(isinstance(part, (dict, list, tuple, str)) for part in (self.bodies, self.joints)):
            raise CommandError("Spawn: bodies and joints are entries of a scene file, or lists of such")
        if not self.bodies and not self.joints:
            raise CommandError("Spawn: there is nothing to spawn; give bodies or joints")
        return self

    def apply(self, target: CommandTarget) -> Touched:
        """Read the entries, add their rows after all others, and wake what the new joints hold."""
        state = target.state
        bodies, joints = ([part] if isinstance(part, dict) else part for part in (self.bodies, self.joints))
        try:
            found = target.spawning.read(bodies, joints, target.directory.known(), "Spawn")
        except SceneError as error:
            raise CommandError(str(error)) from None
        words = found.body_words, found.joint_words
        added = add_rows(state, target.directory, found.bodies, found.joints, words)
        if found.joints:
            held = held_bodies(state, np.arange(added.joints, len(state.joints)))
            held = held[held < added.bodies]  # the others are awake
            if len(held):
                wake_bodies(state, held)
        return Touched(added=added)


def _plain(part: Any) -> Any:
    """Models as the dicts that they stand for, and lists as tuples: a command is equal to the same one from a file."""
    if isinstance(part, (list, tuple)):
        return tuple(map(_plain, part))
    return part.to_data() if hasattr(part, "to_data") else part
