"""What every command is: plain data that knows what it does to a world, and what it touches there."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, Self

from sandbox.engine.commands.checks import checked
from sandbox.world.directory import Directory
from sandbox.world.rows import Added, Moved
from sandbox.world.state import State

if TYPE_CHECKING:
    from sandbox.engine.commands.deferred import Deferred
    from sandbox.engine.queries.queries import Queries
    from sandbox.scene.spawned import Spawning

Vec = tuple[float, float]


class CommandTarget(Protocol):
    """What a command is applied to: as much of a world as commands know."""

    @property
    def state(self) -> State:
        """Its records."""

    @property
    def directory(self) -> Directory:
        """From ids to rows."""

    @property
    def spawning(self) -> Spawning:
        """Reads what is spawned."""

    @property
    def deferred(self) -> Deferred:
        """What waits to be done with others."""

    @property
    def query(self) -> Queries:
        """Where things are."""


@dataclass(frozen=True)
class Touched:
    """What a command has touched of that which a world works out from its records and keeps.

    `active_set`: dynamic bodies may have woken or be elsewhere, or others have come or gone; False if an awake one only
    goes on in another way. `bodies`: the rows of those that have woken, and of static and kinematic ones that were
    changed. `everybody`: any may have been. `joints`: what hangs together by joints. `schedules`: when regions and
    thrusters switch. `regions`: some have gone, or have more or fewer sides. `added`: which rows have come. `rows`:
    where rows have gone. `displaced`: the row of a body that was put elsewhere, and where its centre of mass was (m).
    """

    active_set: bool = True
    bodies: tuple[int, ...] = ()
    everybody: bool = False
    joints: bool = False
    schedules: bool = False
    regions: bool = False
    added: Added | None = None
    rows: Moved | None = None
    displaced: tuple[int, Vec] | None = None


@dataclass(frozen=True)
class Command(ABC):
    """A command: a frozen dataclass, to be given to `World.apply`. Its name and fields are those of recordings."""

    UNLIMITED: ClassVar[frozenset[str]] = frozenset()
    """Fields in which infinity means that there is no limit: null in a recording, as in a scene file."""

    @property
    def outdates_events(self) -> bool:
        """Whether the events of the last step can no longer be worked out afterwards."""
        return False

    def checked(self) -> Self:
        """The same command with Python's own numbers inside.

        Raises `CommandError` unless all fields have their types and are finite, or `UNLIMITED`, and within their
        limits.
        """
        return checked(self, self.UNLIMITED)

    def defer(self, target: CommandTarget) -> bool:
        """Leave it to the deferred commands; False if it is to be done at once. The command is a `checked` one.

        Raises `UnknownBodyError`, and changes nothing, if it cannot be done.
        """
        return False

    @abstractmethod
    def apply(self, target: CommandTarget) -> Touched:
        """Do it. The command is a `checked` one.

        Raises `CommandError`, `UnknownBodyError`, `UnknownJointError` or `UnknownRegionError`, and changes nothing, if
        it cannot be done.
        """

    def to_words(self) -> dict[str, Any]:
        """The fields as a recording has them; what is None, and is so by default, is left out."""
        given = {item.name: (getattr(self, item.name), item.default) for item in fields(self)}
        words = {name: value for name, (value, default) in given.items() if value is not None or default is not None}
        return {name: None if self.is_unlimited(name, value) else value for name, value in words.items()}

    @classmethod
    def from_words(cls, words: Mapping[str, Any]) -> Self:
        """The command that the fields of a recording stand for."""
        return cls(**{n: math.inf if value is None and n in cls.UNLIMITED else value for n, value in words.items()})

    @classmethod
    def is_unlimited(cls, name: str, value: Any) -> bool:
        """Whether a value of that field says that there is no limit."""
        return name in cls.UNLIMITED and value == math.inf
