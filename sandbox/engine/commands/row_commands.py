"""Commands by which bodies and joints come into a world and leave it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.commands.joint_commands import joint_bodies
from sandbox.errors import CommandError, SceneError
from sandbox.world.rows import Moved, add_rows, remove_rows
from sandbox.world.state import State

if TYPE_CHECKING:
    from sandbox.engine.world import World

Words: TypeAlias = dict[str, Any]
Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class Spawn:
    """Bring bodies and joints into the world, in the words of a scene file: entries of `bodies` and of `joints`.

    `bodies` is a list of entries or a single one, and so is `joints`. They may use the scene's prefabs, materials and
    categories; joints may name bodies that are there already, and their anchors are places in the world of now. Ids
    must be new; those of deleted bodies and joints are. Times of thrusters count from now.
    """

    bodies: Words | Sequence[Words] = ()
    joints: Words | Sequence[Words] = ()

    def __post_init__(self) -> None:
        _tidy(self, "bodies")
        _tidy(self, "joints")


@dataclass(frozen=True)
class Delete:
    """Take bodies out of the world, given by one id or several, with all joints that hold them and gears on those.

    What rested on them or hung from them wakes.
    """

    bodies: str | Sequence[str]

    def __post_init__(self) -> None:
        _tidy(self, "bodies")


@dataclass(frozen=True)
class DeleteJoint:
    """Take joints out of the world, given by one id or several, with all gears on them."""

    joints: str | Sequence[str]

    def __post_init__(self) -> None:
        _tidy(self, "joints")


def _tidy(command: Any, field: str) -> None:
    """Keep a list as a tuple, so that a command is equal to the same one read from a file."""
    if isinstance(getattr(command, field), list):
        object.__setattr__(command, field, tuple(getattr(command, field)))


RowCommand: TypeAlias = Spawn | Delete | DeleteJoint


def apply_row_command(world: World, command: RowCommand) -> Moved:
    """Apply a command and say where rows have gone.

    Raises `CommandError`, `UnknownBodyError` or `UnknownJointError`, and changes nothing, if it can't be done.
    """
    if isinstance(command, Spawn):
        return _spawn(world, command)
    state = world.state
    bodies, joints = np.zeros(len(state.bodies), np.bool_), np.zeros(len(state.joints), np.bool_)
    if isinstance(command, Delete):
        bodies[[world.directory.body(name) for name in _several(command, command.bodies)]] = True
    else:
        joints[[world.directory.joint(name) for name in _several(command, command.joints)]] = True
    joints |= _hanging_on(state, bodies, joints)
    _wake(state, np.flatnonzero(joints), np.flatnonzero(bodies).tolist())
    return remove_rows(state, bodies, joints)


def _spawn(world: World, command: Spawn) -> Moved:
    bodies, joints = ([part] if isinstance(part, dict) else part for part in (command.bodies, command.joints))
    if not all(isinstance(part, (list, tuple, str)) for part in (bodies, joints)):  # a text gets a nearer word below
        raise CommandError("Spawn: bodies and joints are entries of a scene file, or lists of such")
    if len(bodies) + len(joints) == 0:
        raise CommandError("Spawn: there is nothing to spawn; give bodies or joints")
    try:
        found = world.spawning.read(bodies, joints, world.directory.known(), "Spawn")
    except SceneError as error:
        raise CommandError(str(error)) from None
    first = len(world.state.joints)
    moved = add_rows(world.state, found.bodies, found.joints, (found.body_words, found.joint_words))
    _wake(world.state, range(first, len(world.state.joints)), [])
    return moved


def _several(command: RowCommand, ids: str | Sequence[str]) -> Sequence[str]:
    names = [ids] if isinstance(ids, str) else ids
    if not isinstance(names, (list, tuple)) or not all(isinstance(name, str) for name in names):
        raise CommandError(f"{type(command).__name__}: what to delete is one id or a list of ids, not {ids!r}")
    if not names:
        raise CommandError(f"{type(command).__name__}: there is nothing to delete; give an id")
    return names


def _hanging_on(state: State, bodies: Flags, joints: Flags) -> Flags:
    """The joints that cannot be there without the marked bodies and joints."""
    table = state.joints
    gone = np.append(bodies, False)  # -1, the world, is the last row
    going = joints | gone[table.body_a] | gone[table.body_b]
    gone = np.append(going, False)
    result: Flags = going | gone[table.joint_1] | gone[table.joint_2]
    return result


def _wake(state: State, joints: Any, bodies: list[int]) -> None:
    """Wake bodies, and all that the joints hold."""
    rows = [row for joint in joints for row in joint_bodies(state, state.joints[joint])]
    if rows or bodies:
        wake_bodies(state, [*bodies, *rows])
