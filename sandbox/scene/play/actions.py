"""What rules and controls do to bodies and to the game. One key tells the kind; each becomes commands to the world."""

from __future__ import annotations

from abc import abstractmethod
from typing import Annotated

from pydantic import Field

from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.base import Model
from sandbox.scene.body import Body
from sandbox.scene.body_refs import Ids, Pattern
from sandbox.scene.constraints import Listed, Range
from sandbox.scene.flat_rules import (
    FlatAction,
    FlatBreak,
    FlatCount,
    FlatDelete,
    FlatEnd,
    FlatExplode,
    FlatGravity,
    FlatPush,
    FlatPut,
    FlatSpawn,
    Names,
)
from sandbox.scene.limits import MAX_ALIVE, MAX_TEXT
from sandbox.scene.play.places import Along, Place
from sandbox.scene.quantities import (
    Acceleration2,
    Degrees,
    Distance,
    Name,
    Number,
    Seconds,
    Size,
    Turning,
    Velocity,
)

Push = Annotated[float, Range(-1e15, 1e15)]
Push2 = Annotated[tuple[Push, Push], Listed("[x, y]", 2, 2)]
Velocity2OrKept = Annotated[tuple[Velocity | None, Velocity | None], Listed("[x, y]; null leaves one as it is", 2, 2)]
Text = Annotated[str, Field(max_length=MAX_TEXT)]


def names(ids: str | tuple[str, ...]) -> Names:
    """One id or several, as a tuple."""
    return (ids,) if isinstance(ids, str) else tuple(ids)


class Action(Model):
    """What all actions have."""

    @abstractmethod
    def flat(self) -> FlatAction:
        """The action in SI units and radians."""


class DeleteBodies(Action):
    """Takes bodies out of the world."""

    delete: Ids = Field(description='Which bodies go; "@first" and "@second" are those of the event.')

    def flat(self) -> FlatAction:
        return FlatDelete(names(self.delete))


class SpawnBody(Action):
    """Brings a body into the world."""

    spawn: Body = Field(description='The body, as in "bodies"; the ones that come are called ID-1, ID-2, ...')
    at: Pattern | None = Field(
        default=None,
        description="Id of a body, or an @ name: the position counts from there, and in that body's frame.",
    )
    limit: Annotated[int, Range(1, MAX_ALIVE)] = Field(
        default=100, description="So many of them may be there at once; no more come then."
    )
    every: Seconds = Field(default=0.0, description="Least time between two of them, s.")

    def flat(self) -> FlatAction:
        return FlatSpawn(at=self.at, limit=self.limit, every=self.every, words=self.spawn.to_data())


class Pushing(Action):
    """What all pushes have."""

    of: Ids = Field(description="Which bodies.")
    along: Along | None = Field(
        default=None,
        description='Which way x points: towards the centre of a body or "@pointer", as in the body itself with '
        '"@self", the way it moves with "@motion"; default: as in the world.',
    )
    reach: Distance = Field(
        default=0.0, description="With a place in along: nearer than this it pushes in proportion to the distance, m."
    )


class PushOnce(Pushing):
    """Changes velocities at once by an impulse."""

    impulse: Push2 = Field(description="[x, y] on the centre of mass, N s.")
    turning: Push | None = Field(default=None, description="Angular impulse, N m s.")

    def flat(self) -> FlatAction:
        return FlatPush(names(self.of), "impulse", self.impulse, self.turning, self.along, self.reach)


class PushStep(Pushing):
    """Pushes during the next step."""

    force: Push2 = Field(description="[x, y] on the centre of mass during the next step, N.")
    torque: Push | None = Field(default=None, description="During the next step, N m.")

    def flat(self) -> FlatAction:
        return FlatPush(names(self.of), "force", self.force, self.torque, self.along, self.reach)


class MoveAt(Pushing):
    """Gives bodies a velocity."""

    velocity: Velocity2OrKept = Field(description="[x, y], m/s; null leaves one of them as it is.")
    angular_velocity: Turning | None = Field(default=None, description="Degrees/s; default: as it is.")

    def flat(self) -> FlatAction:
        turning = None if self.angular_velocity is None else self.angular_velocity * RADIANS_PER_DEGREE
        return FlatPush(names(self.of), "velocity", self.velocity, turning, self.along, self.reach)


class PutBodies(Action):
    """Puts bodies somewhere at once; their velocity stays."""

    put: Ids = Field(description="Which bodies.")
    at: Place = Field(description="[x, y], m; or a body, or an @ name.")
    angle: Degrees | None = Field(default=None, description="Degrees; default: as it is.")

    def flat(self) -> FlatAction:
        return FlatPut(names(self.put), self.at, None if self.angle is None else self.angle * RADIANS_PER_DEGREE)


class BreakJoints(Action):
    """Breaks joints for good."""

    break_joint: Ids = Field(description="Which joints.")

    def flat(self) -> FlatAction:
        return FlatBreak(names(self.break_joint))


class Blast(Action):
    """Pushes everything near a place away from it."""

    explode: Push = Field(description="Impulse for each metre of width that faces the place, N s.")
    at: Place = Field(description="[x, y], m; or a body, or an @ name.")
    radius: Size = Field(description="How far it reaches, m.")

    def flat(self) -> FlatAction:
        return FlatExplode(at=self.at, radius=self.radius, impulse=self.explode)


class ChangeGravity(Action):
    """Gives the scene another gravity."""

    gravity: Acceleration2 = Field(description="[x, y], m/s^2.")

    def flat(self) -> FlatAction:
        return FlatGravity(gravity=self.gravity)


class Count(Action):
    """Changes a counter: `add` or `set`."""

    counter: Name = Field(description="Which counter.")
    add: Number | None = Field(default=None, description="So much more (or less, if negative).")
    set: Number | None = Field(default=None, description="The new value.")

    def flat(self) -> FlatAction:
        adds = self.set is None
        return FlatCount(counter=self.counter, value=(self.add or 0.0) if adds else (self.set or 0.0), adds=adds)


class Win(Action):
    """The game is won; the first outcome stays."""

    win: Text = Field(description="What to tell the player.")

    def flat(self) -> FlatAction:
        return FlatEnd(won=True, text=self.win)


class Lose(Action):
    """The game is lost; the first outcome stays."""

    lose: Text = Field(description="What to tell the player.")

    def flat(self) -> FlatAction:
        return FlatEnd(won=False, text=self.lose)
