"""What the rules and controls of a scene come down to: what is waited for, and what is done then."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from sandbox.scene.flat_body import INFINITE, FlatBody, Vec

Names = tuple[str, ...]
"""Ids, patterns for ids, and what an event gives: "@first", "@second"."""
FIRST, SECOND, SELF, MOTION, POINTER = "@first", "@second", "@self", "@motion", "@pointer"
"""Bodies of the event that a rule sees; axes and way of the body that is pushed; where a control's pointer is."""


@dataclass(frozen=True)
class FlatAction:
    """What all actions have: the ids they are for."""

    of: Names = ()


@dataclass(frozen=True)
class FlatDelete(FlatAction):
    """Bodies go."""


@dataclass(frozen=True)
class FlatSpawn(FlatAction):
    """A body like `body` comes, unless `limit` of them are there or one came less than `every` seconds ago.

    Its place counts from that of the body `at`, in its frame, if there is one. `words` are its entry, as a file has it.
    """

    body: FlatBody | None = None
    at: str | None = None
    limit: int = 100
    every: float = 0.0
    words: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class FlatPush(FlatAction):
    """Bodies are pushed: an impulse (N s, N m s), a force for one step (N, N m), or a velocity (m/s, rad/s).

    `vector` counts along the axes of the world, of the body ("@self"), or with x the way it moves ("@motion") or
    towards a place. Up to `reach` metres away from that the push is the weaker the nearer it is. None leaves that part
    of a velocity as it is.
    """

    kind: Literal["impulse", "force", "velocity"] = "impulse"
    vector: tuple[float | None, float | None] = (0.0, 0.0)
    turning: float | None = None
    along: str | None = None
    reach: float = 0.0


@dataclass(frozen=True)
class FlatPut(FlatAction):
    """Bodies are put at a place (m), or where a body or the pointer is; `angle` in rad, None leaves it."""

    at: Vec | str = (0.0, 0.0)
    angle: float | None = None


@dataclass(frozen=True)
class FlatSetting(FlatAction):
    """Fields of bodies' surfaces or thrusters, of joints, regions or paths get values, named as commands name them."""

    what: Literal["surface", "thruster", "joint", "region", "path"] = "surface"
    values: tuple[tuple[str, Any], ...] = ()


@dataclass(frozen=True)
class FlatBreak(FlatAction):
    """Joints break."""


@dataclass(frozen=True)
class FlatExplode(FlatAction):
    """What is within `radius` (m) of a place is pushed away."""

    at: Vec | str = (0.0, 0.0)
    radius: float = 1.0
    impulse: float = 0.0


@dataclass(frozen=True)
class FlatGravity(FlatAction):
    """The scene gets another gravity, m/s^2."""

    gravity: Vec = (0.0, 0.0)


@dataclass(frozen=True)
class FlatCount(FlatAction):
    """A counter gets a value, or so much more."""

    counter: str = ""
    value: float = 0.0
    adds: bool = True


@dataclass(frozen=True)
class FlatEnd(FlatAction):
    """The game is won or lost."""

    won: bool = True
    text: str = ""


@dataclass(frozen=True)
class FlatTrigger:
    """What a rule waits for.

    `first` and `second` are ids or patterns of bodies (of joints for "joint_break"). `speed` (m/s) and `impulse` (N s)
    are least ones of a hit; `time` and `start` in s; `value` is the one that the counter `name` reaches, or `name` is
    that of the control that is pressed.
    """

    kind: Literal["hit", "begin", "end", "enter", "leave", "joint_break", "time", "every", "count", "press"]
    first: Names = ()
    second: Names = ()
    speed: float = 0.0
    impulse: float = 0.0
    time: float = 0.0
    start: float = 0.0
    name: str = ""
    value: float = 0.0


@dataclass(frozen=True)
class FlatCondition:
    """The value of a counter lies in a closed range, if one is named, and bodies touch, if two ids are given."""

    counter: str = ""
    low: float = -INFINITE
    high: float = INFINITE
    touches: tuple[str, str] | None = None


@dataclass(frozen=True)
class FlatRule:
    """What is done when something happens: at most `limit` times, and not again within `cooldown` seconds."""

    when: FlatTrigger
    do: tuple[FlatAction, ...]
    id: str = ""
    condition: FlatCondition | None = None
    limit: int | None = None
    cooldown: float = 0.0


@dataclass(frozen=True)
class FlatControl:
    """What a player holds: keys, buttons or the mouse, and what is done when it is pressed, held and let go.

    What is held acts before every step, by the value of the control.
    """

    id: str
    title: str = ""
    keys: Names = ()
    minus: Names = ()
    pad: Names = ()
    mouse: Names = ()
    press: tuple[FlatAction, ...] = ()
    hold: tuple[FlatAction, ...] = ()
    release: tuple[FlatAction, ...] = ()


@dataclass(frozen=True)
class FlatCounter:
    """A number with a name, and what it starts with."""

    id: str
    value: float = 0.0
