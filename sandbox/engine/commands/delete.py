"""Commands by which bodies, joints and regions leave a world."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sandbox.arguments import shown
from sandbox.engine.active.wake import wake_bodies
from sandbox.engine.commands.base import Command, CommandTarget, Touched
from sandbox.engine.commands.joint_command import held_bodies
from sandbox.engine.commands.sleepers_in import sleepers_in
from sandbox.errors import CommandError
from sandbox.tables import plain
from sandbox.world.region_rows import remove_regions
from sandbox.world.rows import Flags, remove_rows
from sandbox.world.state import State

Ids = str | Sequence[str]


@dataclass(frozen=True)
class Delete(Command):
    """Take bodies out of the world, given by one id or several, with all joints that hold them and gears on those.

    What rested on them or hung from them wakes.
    """

    bodies: Ids

    def __post_init__(self) -> None:
        object.__setattr__(self, "bodies", _tidy(self.bodies))

    def checked(self) -> Self:
        """The same; raises `CommandError` unless it names bodies."""
        _check_ids(self, self.bodies)
        return self

    def defer(self, target: CommandTarget) -> bool:
        """Let the bodies wait until they are asked for."""
        target.deferred.remove(_listed(self.bodies))
        return True

    def apply(self, target: CommandTarget) -> Touched:
        """Take the rows out of all tables."""
        return take_out(target, bodies=[target.directory.body(name) for name in _listed(self.bodies)])


@dataclass(frozen=True)
class DeleteJoint(Command):
    """Take joints out of the world, given by one id or several, with all gears on them."""

    joints: Ids

    outdates_events = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "joints", _tidy(self.joints))

    def checked(self) -> Self:
        """The same; raises `CommandError` unless it names joints."""
        _check_ids(self, self.joints)
        return self

    def apply(self, target: CommandTarget) -> Touched:
        """Take the rows out of all tables."""
        return take_out(target, joints=[target.directory.joint(name) for name in _listed(self.joints)])


@dataclass(frozen=True)
class DeleteRegion(Command):
    """Take regions out of the world, given by one id or several. What sleeps in them wakes."""

    regions: Ids

    def __post_init__(self) -> None:
        object.__setattr__(self, "regions", _tidy(self.regions))

    def checked(self) -> Self:
        """The same; raises `CommandError` unless it names regions."""
        _check_ids(self, self.regions)
        return self

    def apply(self, target: CommandTarget) -> Touched:
        """Take the rows out of the tables. Raises `UnknownRegionError`, with the nearest name."""
        state = target.state
        gone = np.zeros(len(state.regions), np.bool_)
        gone[[target.directory.region(name) for name in _listed(self.regions)]] = True
        woken: tuple[int, ...] = ()
        for row in np.flatnonzero(gone):
            woken += wake_bodies(state, sleepers_in(state, state.regions[row]))
        remove_regions(state, target.directory, gone)
        return Touched(regions=True, bodies=woken)


def take_out(target: CommandTarget, bodies: Sequence[int] = (), joints: Sequence[int] = ()) -> Touched:
    """Take out bodies and joints of some rows, with the joints that cannot be there without them, and wake what these
    held."""
    state = target.state
    going, parting = np.zeros(len(state.bodies), np.bool_), np.zeros(len(state.joints), np.bool_)
    going[list(bodies)] = parting[list(joints)] = True
    if len(parting):
        parting |= _hanging_on(state, going, parting)
    held = held_bodies(state, np.flatnonzero(parting))
    woken = np.array(wake_bodies(state, np.concatenate([np.flatnonzero(going), held])), np.int64)
    rows = remove_rows(state, target.directory, going, parting)
    first = rows.bodies.first  # all behind are looked at
    rejoined = [row for row in rows.rejoined if row < first]
    return Touched(rows=rows, bodies=(*woken[woken < first].tolist(), *rejoined))


def _tidy(ids: Ids) -> Ids:
    """A list as a tuple, so that a command is equal to the same one read from a file."""
    return tuple(ids) if isinstance(ids, list) else ids


def _listed(ids: Ids) -> Sequence[str]:
    return [ids] if isinstance(ids, str) else ids


def _check_ids(command: Command, ids: Ids) -> None:
    names = _listed(ids)
    if not isinstance(names, (list, tuple)) or not all(isinstance(name, str) for name in names):
        raise CommandError(f"{type(command).__name__}: what to delete is one id or a list of ids, not {shown(ids)}")
    if not names:
        raise CommandError(f"{type(command).__name__}: there is nothing to delete; give an id")


def _hanging_on(state: State, bodies: Flags, joints: Flags) -> Flags:
    """The joints that cannot be there without the marked bodies and joints."""
    table = plain(state.joints)
    gone = np.append(bodies, False)  # -1, the world, is the last row
    going = joints | gone[table["body_a"]] | gone[table["body_b"]]
    gone = np.append(going, False)
    result: Flags = going | gone[table["joint_1"]] | gone[table["joint_2"]]
    return result
