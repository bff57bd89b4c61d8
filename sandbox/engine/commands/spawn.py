"""The command by which bodies, joints and regions come into a world."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Self, TypeAlias

import numpy as np

from sandbox._collecting import collection_postponed
from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.commands.base import Command, CommandTarget, Touched
from sandbox.engine.commands.joint_command import held_bodies
from sandbox.engine.commands.sleepers_in import sleepers_in
from sandbox.errors import CapacityError, CommandError, SceneError
from sandbox.world.rows import add_rows

Words: TypeAlias = dict[str, Any]
_LISTS = ("bodies", "joints", "regions")


@dataclass(frozen=True)
class Spawn(Command):
    """Bring bodies, joints and regions into the world, in the words of a scene file: entries of its lists.

    Entries are dicts or the models of scenes (`sandbox.Body`, `sandbox.Revolute`, `sandbox.Water`); `bodies` is a list
    of them or a single one, and so are `joints` and `regions`. They may use the scene's prefabs, materials and
    categories; joints may name bodies that are there already, and their anchors are places in the world of now. Ids
    must be new; those of what was deleted are. Times of thrusters and regions count from now. As in a file, angles are
    in degrees.
    """

    bodies: Words | Sequence[Words] = ()
    joints: Words | Sequence[Words] = ()
    regions: Words | Sequence[Words] = ()

    def __post_init__(self) -> None:
        for name in _LISTS:
            object.__setattr__(self, name, _plain(getattr(self, name)))

    def checked(self) -> Self:
        """The same; raises `CommandError` unless it holds entries."""
        parts = [getattr(self, name) for name in _LISTS]
        if not all(isinstance(part, (dict, list, tuple, str)) for part in parts):
            raise CommandError("Spawn: bodies, joints and regions are entries of a scene file, or lists of such")
        if not any(parts):
            raise CommandError("Spawn: there is nothing to spawn; give bodies, joints or regions")
        return self

    def to_words(self) -> Words:
        """The fields as a recording has them, without empty lists."""
        return {name: value for name, value in super().to_words().items() if value != ()}

    @collection_postponed()
    def defer(self, target: CommandTarget) -> bool:
        """Let bodies wait that are like others before, by themselves, and free to move."""
        if self.joints or self.regions:
            return False
        found = target.spawning.read_known(_listed(self.bodies), (), target.deferred.known())
        return found is not None and target.deferred.add(found)

    @collection_postponed()
    def apply(self, target: CommandTarget) -> Touched:
        """Read the entries, add their rows after all others, and wake what the new joints hold or regions push."""
        state = target.state
        bodies, joints, regions = (_listed(getattr(self, name)) for name in _LISTS)
        known = target.directory.known(len(state.shapes))
        try:
            found = target.spawning.read(bodies, joints, known, "Spawn", regions)
        except SceneError as error:
            raise CommandError(str(error)) from None
        try:
            added = add_rows(state, target.directory, found)
        except CapacityError as error:
            raise CommandError(f"Spawn: {error}") from None
        woken: tuple[int, ...] = ()
        for row in range(len(state.regions) - added.regions, len(state.regions)):
            woken += wake_bodies(state, sleepers_in(state, state.regions[row]))
        if found.joints:
            held = held_bodies(state, np.arange(added.joints, len(state.joints)))
            held = held[held < added.bodies]  # the others are awake
            if len(held):
                woken += wake_bodies(state, held)
        return Touched(added=added, bodies=woken + added.rejoined)


def _listed(part: Any) -> Any:
    return [part] if isinstance(part, dict) else part


def _plain(part: Any) -> Any:
    """Models as the dicts that they stand for, and lists as tuples: a command is equal to the same one from a file."""
    if isinstance(part, (list, tuple)):
        return tuple(map(_plain, part))
    return part.to_data() if hasattr(part, "to_data") else part
