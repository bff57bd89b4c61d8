"""Actions become commands. What cannot be done, since somebody is gone or a command is refused, is left out."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, Protocol

from sandbox.engine.commands.base import Command, Vec
from sandbox.engine.commands.delete import Delete
from sandbox.engine.commands.explode import Explode
from sandbox.engine.commands.joint_parts import BreakJoint
from sandbox.engine.commands.motion import SetPose, SetVelocity
from sandbox.engine.commands.pushes import ApplyForce, ApplyImpulse
from sandbox.engine.commands.set_gravity import SetGravity
from sandbox.engine.commands.spawn import Spawn
from sandbox.engine.events.happening import Happening
from sandbox.engine.rules.base import RuledWorld
from sandbox.engine.rules.gathering import Gathering
from sandbox.engine.rules.meant import Meant
from sandbox.engine.rules.occasions import Occasion
from sandbox.engine.rules.settings import setting_commands
from sandbox.engine.rules.spawner import Spawner
from sandbox.errors import REFUSALS
from sandbox.scene import flat_rules as flat
from sandbox.scene.flat_rules import MOTION, POINTER, SELF, FlatAction, Names
from sandbox.tables import plain

MOST_IN_A_STEP = 10_000
"""Actions, and commands that they become, in one step."""
_GATHERED = (flat.FlatSpawn, flat.FlatDelete)


class Book(Protocol):
    """Who keeps counters and the outcome."""

    def count(self, name: str, value: float, adds: bool, by: str) -> None:
        """Change a counter."""

    def end(self, won: bool, text: str, by: str) -> None:
        """The game is over."""


class Actor:
    """Does the actions of one world; `happenings` are what is to be told of them."""

    def __init__(self, world: RuledWorld, book: Book) -> None:
        self._world, self._book = world, book
        self.happenings: list[Happening] = []
        self._left = MOST_IN_A_STEP
        self._meant = Meant(world)
        self._spawner = Spawner(world)
        self._gathering = Gathering(self._refused)
        self._kinds: dict[type[FlatAction], Callable[[Any, Occasion], None]] = {
            flat.FlatDelete: self._delete, flat.FlatSpawn: self._spawn, flat.FlatPush: self._push,
            flat.FlatPut: self._put, flat.FlatSetting: self._set, flat.FlatBreak: self._break,
            flat.FlatExplode: self._explode, flat.FlatGravity: self._gravity, flat.FlatCount: self._count,
            flat.FlatEnd: self._end,
        }  # fmt: skip

    def begin(self) -> None:
        """A step begins: as much may be done in it as in any other."""
        self._left = MOST_IN_A_STEP

    def do(self, actions: tuple[FlatAction, ...], occasion: Occasion) -> None:
        """Do some actions one after another, as long as not too much was done in this step.

        The last ones may wait until it is `finish`ed.
        """
        for action in actions:
            if self._may_do(occasion):
                if type(action) not in _GATHERED:
                    self.finish()
                self._kinds[type(action)](action, occasion)

    def finish(self) -> None:
        """Do what waits: before anybody looks at what actions have come to."""
        self._gathering.finish()

    def _may_do(self, occasion: Occasion) -> bool:
        self._left -= 1
        if self._left == 0:
            self.finish()
            text = f"rules and controls want more than {MOST_IN_A_STEP:,} things done in one step; the rest is left out"
            self.tell("refused", occasion.source, text=text)
        return self._left > 0

    def tell(self, event: str, by: str, **facts: Any) -> None:
        """Note something for the events of the step."""
        self.happenings.append(Happening(event, tuple(facts.items()), by))

    def _apply(self, command: Command, occasion: Occasion) -> bool:
        if not self._may_do(occasion):
            return False
        refused = self._refused(command)
        if refused is not None:
            self.tell("refused", occasion.source, text=refused)
        return refused is None

    def _refused(self, command: Command) -> str | None:
        """Apply a command; why it is refused, if it is."""
        try:
            self._world.apply(command)
        except REFUSALS as error:
            return str(error)
        return None

    def _delete(self, action: FlatAction, occasion: Occasion) -> None:
        if not self._gathering.waits(Delete):
            self.finish()  # what comes can go at once
        going = self._gathering.names
        names = [name for name in self._meant.bodies(action.of, occasion) if name not in going]
        if names and self._may_do(occasion):
            self._gathering.add(Delete(tuple(names)), names, lambda refused: self._gone(names, refused, occasion))

    def _gone(self, names: Sequence[str], refused: str | None, occasion: Occasion) -> None:
        if refused is not None:
            self.tell("refused", occasion.source, text=refused)
            return
        for name in names:
            self.tell("delete", occasion.source, body=name)

    def _spawn(self, action: flat.FlatSpawn, occasion: Occasion) -> None:
        assert action.body is not None
        if not self._gathering.waits(Spawn) or action.body.id in self._gathering.names:
            self.finish()  # how many there are is known again
        at = None
        if action.at is not None:
            at = self._first((action.at,), occasion)
            if at is None:
                return
        found = self._spawner.command(action, at)
        if found is not None and self._may_do(occasion):
            number, command = found
            name = action.body.id
            self._gathering.add(command, (name,), lambda refused: self._come(action, number, refused, occasion))

    def _first(self, names: Names, occasion: Occasion) -> str | None:
        """The first of some bodies; one that is to come now if there is no other."""
        found = self._meant.bodies(names, occasion)
        if not found:
            self.finish()
            found = self._meant.bodies(names, occasion)
        return found[0] if found else None

    def _come(self, action: flat.FlatSpawn, number: int, refused: str | None, occasion: Occasion) -> None:
        if refused is not None:
            self.tell("refused", occasion.source, text=refused)
        else:
            self.tell("spawn", occasion.source, body=self._spawner.note(action, number))

    def _push(self, action: flat.FlatPush, occasion: Occasion) -> None:
        bodies, directory = self._world.state.bodies, self._world.directory
        asks = action.along is not None or action.kind not in ("force", "impulse")  # how the body lies and moves
        for name in self._meant.bodies(action.of, occasion):
            body = plain(bodies)[directory.body(name)] if asks else None
            frame = self._frame(action, body, occasion)
            if frame is None:
                continue
            cosine, sine = frame
            x, y = ((value or 0.0) * occasion.scale for value in action.vector)
            vector = cosine * x - sine * y, sine * x + cosine * y
            turning = None if action.turning is None else action.turning * occasion.scale
            self._apply(_push_command(name, action, vector, turning, body), occasion)

    def _frame(self, action: flat.FlatPush, body: Any, occasion: Occasion) -> Vec | None:
        """Cosine and sine of the way x points, times how strong the push is; None if there is no such way."""
        if action.along is None:
            return 1.0, 0.0
        if action.along == SELF:
            return float(body["rotation_cos"]), float(body["rotation_sin"])
        way = self._way(action.along, body, occasion)
        if way is None:
            return None
        x, y = way
        length = math.sqrt(x * x + y * y)
        if not length > 0.0:
            return None
        strength = length / action.reach if length < action.reach and action.along != MOTION else 1.0
        return strength * (x / length), strength * (y / length)

    def _way(self, along: str, body: Any, occasion: Occasion) -> Vec | None:
        """From the centre of a body to the pointer, or to the centre of another body; or its velocity."""
        if along == MOTION:
            return float(body["velocity_x"]), float(body["velocity_y"])
        place = occasion.pointer
        if along != POINTER:
            rows = plain(self._world.state.bodies)
            found = [rows[self._world.directory.body(name)] for name in self._meant.bodies((along,), occasion)]
            place = (float(found[0]["center_x"]), float(found[0]["center_y"])) if found else None
        return None if place is None else (place[0] - float(body["center_x"]), place[1] - float(body["center_y"]))

    def _put(self, action: flat.FlatPut, occasion: Occasion) -> None:
        for name in self._meant.bodies(action.of, occasion):
            place = self._meant.place(action.at, occasion)
            if place is not None:
                angle = plain(self._world.state.bodies)["angle"][self._world.directory.body(name)]
                self._apply(SetPose(name, place, float(angle) if action.angle is None else action.angle), occasion)

    def _set(self, action: flat.FlatSetting, occasion: Occasion) -> None:
        values = {}
        for name, value in action.values:
            values[name] = self._meant.place(value, occasion) if name == "target" else value
            if values[name] is None:
                return
        if action.what == "joint":
            names = self._meant.joints(action.of)
        elif action.what == "region":
            names = self._meant.regions(action.of)
        else:
            names = self._meant.bodies(action.of, occasion)
        for command in setting_commands(action.what, names, values, occasion.scale):
            self._apply(command, occasion)

    def _break(self, action: FlatAction, occasion: Occasion) -> None:
        for name in self._meant.joints(action.of):
            self._apply(BreakJoint(name), occasion)

    def _explode(self, action: flat.FlatExplode, occasion: Occasion) -> None:
        place = self._meant.place(action.at, occasion)
        if place is not None:
            self._apply(Explode(place, action.radius, action.impulse), occasion)

    def _gravity(self, action: flat.FlatGravity, occasion: Occasion) -> None:
        self._apply(SetGravity(action.gravity), occasion)

    def _count(self, action: flat.FlatCount, occasion: Occasion) -> None:
        self._book.count(action.counter, action.value, action.adds, occasion.source)

    def _end(self, action: flat.FlatEnd, occasion: Occasion) -> None:
        self._book.end(action.won, action.text, occasion.source)


def _push_command(name: str, action: flat.FlatPush, vector: Vec, turning: float | None, body: Any) -> Command:
    if action.kind == "impulse":
        return ApplyImpulse(name, vector, turning or 0.0)
    if action.kind == "force":
        return ApplyForce(name, vector, turning or 0.0)
    now = float(body["velocity_x"]), float(body["velocity_y"])
    x, y = (before if given is None else value for before, given, value in zip(now, action.vector, vector, strict=True))
    return SetVelocity(name, (x, y), float(body["angular_velocity"]) if turning is None else turning)
