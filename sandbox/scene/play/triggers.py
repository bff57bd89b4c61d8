"""What a rule can wait for."""

from __future__ import annotations

from abc import abstractmethod
from typing import Annotated

from pydantic import Field, Tag

from sandbox.scene.base import Model
from sandbox.scene.body_refs import Ids, Pair
from sandbox.scene.constraints import Range
from sandbox.scene.flat_rules import FlatTrigger
from sandbox.scene.play.actions import names
from sandbox.scene.quantities import Name, Number, Seconds, Speed
from sandbox.scene.union import TAG, by_key

Period = Annotated[float, Range(1e-3, 1e6, "s")]
Impulse = Annotated[float, Range(0, 1e15, "N s")]


class Trigger(Model):
    """What all triggers have."""

    @abstractmethod
    def flat(self) -> FlatTrigger:
        """The trigger in plain values."""


class OnHit(Trigger):
    """Two bodies strike each other."""

    hit: Pair = Field(description='["a", "b"]: ids or patterns; "@first" and "@second" are the bodies found for them.')
    speed: Speed = Field(default=1.0, description="They close in at this speed at least, m/s; 1 is the least.")
    impulse: Impulse = Field(default=0.0, description="The impulse of the step is at least this, N s.")

    def flat(self) -> FlatTrigger:
        first, second = self.hit
        return FlatTrigger("hit", (first,), (second,), speed=self.speed, impulse=self.impulse)


class OnBegin(Trigger):
    """Two bodies begin to touch."""

    begin: Pair = Field(description='["a", "b"]: ids or patterns.')

    def flat(self) -> FlatTrigger:
        return FlatTrigger("begin", (self.begin[0],), (self.begin[1],))


class OnEnd(Trigger):
    """Two bodies come apart."""

    end: Pair = Field(description='["a", "b"]: ids or patterns.')

    def flat(self) -> FlatTrigger:
        return FlatTrigger("end", (self.end[0],), (self.end[1],))


class OnEnter(Trigger):
    """A body comes into a sensor."""

    enter: Pair = Field(description="The body that carries the sensor, and the one that comes.")

    def flat(self) -> FlatTrigger:
        return FlatTrigger("enter", (self.enter[0],), (self.enter[1],))


class OnLeave(Trigger):
    """A body is no longer in a sensor."""

    leave: Pair = Field(description="The body that carries the sensor, and the one that leaves.")

    def flat(self) -> FlatTrigger:
        return FlatTrigger("leave", (self.leave[0],), (self.leave[1],))


class OnJointBreak(Trigger):
    """A joint breaks."""

    joint_break: Ids = Field(description="Which joints.")

    def flat(self) -> FlatTrigger:
        return FlatTrigger("joint_break", names(self.joint_break))


class OnTime(Trigger):
    """A time has come."""

    time: Seconds = Field(description="Seconds since the start.")

    def flat(self) -> FlatTrigger:
        return FlatTrigger("time", time=self.time)


class OnEvery(Trigger):
    """Again and again."""

    every: Period = Field(description="Seconds between two times, at least a step.")
    start: Seconds | None = Field(default=None, description="The first time, s; default: after `every`.")

    def flat(self) -> FlatTrigger:
        return FlatTrigger("every", time=self.every, start=self.every if self.start is None else self.start)


class OnCount(Trigger):
    """A counter reaches a value, from below or from above."""

    count: Name = Field(description="Which counter.")
    reaches: Number = Field(description="The value.")

    def flat(self) -> FlatTrigger:
        return FlatTrigger("count", name=self.count, value=self.reaches)


class OnPress(Trigger):
    """A control is pressed."""

    press: Name = Field(description="Which control.")

    def flat(self) -> FlatTrigger:
        return FlatTrigger("press", name=self.press)


TRIGGERS: dict[str, type[Trigger]] = {
    "hit": OnHit,
    "begin": OnBegin,
    "end": OnEnd,
    "enter": OnEnter,
    "leave": OnLeave,
    "joint_break": OnJointBreak,
    "time": OnTime,
    "every": OnEvery,
    "count": OnCount,
    "press": OnPress,
}
"""Every kind of trigger by its key."""

AnyTrigger = Annotated[
    Annotated[OnHit, Tag(TAG + "hit")]
    | Annotated[OnBegin, Tag(TAG + "begin")]
    | Annotated[OnEnd, Tag(TAG + "end")]
    | Annotated[OnEnter, Tag(TAG + "enter")]
    | Annotated[OnLeave, Tag(TAG + "leave")]
    | Annotated[OnJointBreak, Tag(TAG + "joint_break")]
    | Annotated[OnTime, Tag(TAG + "time")]
    | Annotated[OnEvery, Tag(TAG + "every")]
    | Annotated[OnCount, Tag(TAG + "count")]
    | Annotated[OnPress, Tag(TAG + "press")],
    by_key("trigger", TRIGGERS),
]
"""Any trigger; exactly one of the keys of `TRIGGERS` tells which."""
