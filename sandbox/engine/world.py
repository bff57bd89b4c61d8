"""The world: a scene set in motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

from sandbox._collecting import collection_postponed
from sandbox.arguments import MOST_WORKERS, check_kind, checked_count, shown
from sandbox.attributes import FixedAttributes, attributes_besides
from sandbox.engine.commands.base import Command, Touched, Vec
from sandbox.engine.commands.body_command import GOES_ON
from sandbox.engine.commands.deferred import Deferred
from sandbox.engine.commands.delete import Delete, take_out
from sandbox.engine.commands.set_gravity import SetGravity
from sandbox.engine.commands.spawn import Spawn
from sandbox.engine.events.event_log import EventLog, KeptEvents, Untold
from sandbox.engine.fields.records import last_switch
from sandbox.engine.readings import Readings
from sandbox.engine.stepper import Stepper
from sandbox.engine.views.bodies import Bodies
from sandbox.engine.views.body import BodyView
from sandbox.engine.views.joint import JointView
from sandbox.engine.views.views import Views
from sandbox.errors import ArgumentError, CapacityError, CommandError, SnapshotError
from sandbox.notebook import Shown
from sandbox.scene.flat import FlatScene
from sandbox.scene.spawned import Spawned
from sandbox.tables import Floats, plain
from sandbox.world.build import build_state
from sandbox.world.directory import Directory
from sandbox.world.records import CounterPlace
from sandbox.world.roster import Roster
from sandbox.world.rows import add_rows
from sandbox.world.snapshot import restore

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sandbox.engine.queries.queries import Queries
    from sandbox.engine.rules.game import Game
    from sandbox.engine.rules.paths import Paths
    from sandbox.scene import Scene
    from sandbox.scene.spawned import Spawning

LastStep: TypeAlias = tuple[KeptEvents, Floats]
"""What a copy has to know of the last step: events, and the impulses (N s) of its contacts."""


class World(Readings, Shown, FixedAttributes):
    """A simulation of one scene.

    The same scene and the same commands give the same bits on every machine. `step` advances, `apply` is the only
    way to change anything from outside, everything else reads; what can be set or called besides applies a command.
    Units are SI, angles are in radians, y points up. `workers` threads share the work of a step, where there are many
    bodies; they make no difference to the bits. Raises `ArgumentError` unless that is a whole number from 1.

    `copy.copy`, `copy.deepcopy` and `pickle` make a world that goes on by itself from where this one is, with the
    same bits; in another process too, with the same version of this package.
    """

    __slots__ = (
        "__weakref__",
        "_changes",
        "_deferred",
        "_directory",
        "_events",
        "_game",
        "_last_switch",
        "_moves",
        "_paths",
        "_queries",
        "_spawning",
        "_stepper",
        "_views",
        "bodies",
        "scene",
        "state",
    )  # fmt: skip

    @collection_postponed()
    def __init__(self, scene: Scene | FlatScene, workers: int = 1) -> None:
        flat = scene.flatten() if hasattr(scene, "flatten") else scene
        if not isinstance(flat, FlatScene):
            raise ArgumentError(f"World: takes a Scene, not {shown(scene)}; load_scene reads one from a file")
        self.scene = scene
        self.state = build_state(flat)
        self._changes = self._moves = 0
        self._spawning: Spawning | None = None
        self._queries: Queries | None = None
        self._events = EventLog(self.state)
        self._stepper = Stepper(self.state, checked_count("World", workers, "workers", 1, MOST_WORKERS))
        self._game: Game | None = None
        self._paths: Paths | None = None
        self._know_rows()
        self._know_play()
        self.bodies = Bodies(self)
        self._views = Views(self)

    @property
    def workers(self) -> int:
        """How many threads step it, at most: few bodies are stepped by one."""
        return self._stepper.workers

    def step(self, n: int = 1) -> None:
        """Advance by `n` steps of `1 / step_rate` seconds each.

        Raises `ArgumentError` unless `n` is a whole number, and `CapacityError` before a step in which so many shapes
        overlap that its tables would not fit into memory; the world is then as after the step before, but for its
        events.
        """
        n = checked_count("World.step", n)
        self._stepper.compile()
        object.__setattr__(self, "_changes", self._changes + 1)  # ours looks up what may be set: 1 us
        object.__setattr__(self, "_moves", self._moves + 1)
        if self._game is None and self._paths is None:
            self._advance(n)
            return
        for _ in range(n):
            self._play_step()

    def _advance(self, n: int) -> None:
        singly = self._events.sensed is not None
        while n > 0:
            try:
                taken, asleep = self._stepper.advance(n, self._last_switch, singly)
            except CapacityError:
                self._events.clear(rows_moved=False)
                raise
            self._events.note_steps(taken)
            if asleep:
                self._events.note_quiet_steps()
            n -= taken + asleep

    def _play_step(self) -> None:
        """A step with what controls and paths do before it, and rules after it."""
        if self._game is not None:
            self._game.before_step()
        if self._paths is not None:
            self._paths.lead()
        self._advance(1)
        if self._paths is not None:
            self._paths.arrive()
        if self._game is not None:
            told = self._game.after_step(self._events.sensed)
            if told:
                self._events.note_happenings(self.scratch, told)

    def apply(self, command: Command) -> None:
        """Apply a command.

        Raises `CommandError`, `UnknownBodyError`, `UnknownJointError` or `UnknownRegionError` and changes nothing if it
        can't be done.
        """
        if not isinstance(command, Command):
            raise CommandError(f"{shown(command)} is no command; commands are such as sandbox.SetPose")
        object.__setattr__(self, "_changes", self._changes + 1)  # as in a step
        command = command.checked()
        if command.defer(self):
            return
        self._deferred.apply()
        if command.outdates_events:
            self._events.work_out(self._stepper.scratch)
        self._note(command.apply(self))

    @property
    def gravity(self) -> Vec:
        """m/s^2. Setting it applies `SetGravity`."""
        setting = self.state.settings[0]
        return float(setting.gravity_x), float(setting.gravity_y)

    @gravity.setter
    def gravity(self, value: Vec) -> None:
        self.apply(SetGravity(value))

    def spawn(self, bodies: Any = (), joints: Any = (), regions: Any = ()) -> None:
        """Bring bodies, joints and regions into the world, in the words of a scene file: `Spawn`."""
        self.apply(Spawn(bodies, joints, regions))

    def delete(self, bodies: str | Sequence[str]) -> None:
        """Take bodies out of the world, given by one id or several, with the joints that hold them: `Delete`."""
        self.apply(Delete(bodies))

    @property
    def spawning(self) -> Spawning:
        """Reads what is spawned."""
        if self._spawning is None:
            from sandbox.scene.spawned import Spawning  # worlds in which nothing is spawned pay nothing

            self._spawning = Spawning(self.scene if not isinstance(self.scene, FlatScene) else None)
        return self._spawning

    @property
    def deferred(self) -> Deferred:
        """What waits to be done with others."""
        return self._deferred

    def body(self, name: str) -> BodyView:
        """The body of that id. Raises `UnknownBodyError` with the nearest name."""
        return self._views.body(name)

    def joint(self, name: str) -> JointView:
        """The joint of that id. Raises `UnknownJointError` with the nearest name."""
        return self._views.joint(name)

    @property
    def joints(self) -> tuple[JointView, ...]:
        """All joints, also those without an id, in the order of the scene, then those that were spawned."""
        return self._views.joints

    @property
    def query(self) -> Queries:
        """Rays, casts, overlaps and distances: read-only questions about where things are."""
        if self._queries is None:
            from sandbox.engine.queries.queries import Queries  # worlds that are asked nothing pay nothing

            self._queries = Queries(self)
        return self._queries

    def restore(self, data: bytes, untold: Untold | None = None) -> None:
        """Go back to a snapshot of this scene. Raises `SnapshotError` and changes nothing if it can't.

        With what was `untold` then, the events of the next step are told as they were, also of what was deleted or put
        elsewhere before the snapshot.
        """
        if not isinstance(data, (bytes, bytearray, memoryview)):
            raise SnapshotError(f"a snapshot is bytes, as World.snapshot gives them, not {shown(data)}")
        if untold is not None:
            check_kind("World.restore", "as untold what World.untold gave", untold, Untold)
        self._deferred.apply()
        self._changes += 1
        self._moves += 1
        layout, wiring = self.layout, self._stepper.wiring()
        restore(self.state, bytes(data), self._read_roster)
        if self.layout != layout:
            self._know_rows()
        self._last_switch = last_switch(self.state)
        self._know_play()
        self._views.forget()
        self._stepper.follow_restore(wiring if self.layout == layout else None)
        plain(self.scratch.contacts.reports)["total_impulse"] = 0.0
        self._events.clear(rows_moved=self.layout != layout)
        if untold is not None:
            self._events.take_up(untold)

    @property
    def untold(self) -> Untold:
        """What the events of the next step have to know and no snapshot holds: for `restore`."""
        self._deferred.apply()
        return self._events.untold

    @property
    def last_step(self) -> LastStep:
        """What was told of the last step and no snapshot holds, with what is `untold`: for `recall`."""
        return self._events.kept(self.scratch), self.contact_impulses

    def recall(self, last_step: LastStep) -> None:
        """Tell of the last step what was told when `last_step` was had, after the snapshot of then was restored."""
        events, impulses = last_step
        self._events.recall(events)
        self.scratch.contacts.reports.total_impulse[: len(impulses)] = impulses

    def __reduce_ex__(self, protocol: Any) -> tuple[Any, ...]:
        """How to make a world like it: from the scene and a snapshot, never from memory that both would share."""
        made_of = type(self), self.scene, self.workers, self.snapshot(), self.last_step
        return _made_again, made_of, attributes_besides(World, object.__getstate__(self))

    def _read_roster(self, text: bytes) -> Roster:
        from sandbox.world.roster_reading import read_roster

        return read_roster(text, self.state.roster.scene, self.spawning.read)

    def _know_rows(self) -> None:
        """Note where everybody is now, and when fields begin and end."""
        self._directory = Directory(self.state)
        self._deferred = Deferred(self.state, self._directory, self._apply_deferred)
        self._last_switch = last_switch(self.state)

    def _know_play(self) -> None:
        """Make what plays around a step, in worlds where something does: others neither import nor ask it."""
        state = self.state
        if self._game is None and len(state.outcome):
            from sandbox.engine.rules.game import Game

            self._game = Game(self)
        if self._paths is None and len(state.paths):
            from sandbox.engine.rules.paths import Paths

            self._paths = Paths(state, lambda rows: self._note(Touched(bodies=tuple(rows))))

    @collection_postponed()
    def _apply_deferred(self) -> None:
        """Do what was deferred."""
        going, coming = self._deferred.take()
        if going:
            self._events.note_going(self._stepper.scratch, going)
            self._note(take_out(self, bodies=[row for rows in going for row in rows]))
        if coming:
            self._note(Touched(added=add_rows(self.state, self._directory, Spawned.joined(coming))))

    def _note(self, touched: Touched) -> None:
        """Bring up to date what is worked out from the records."""
        if touched is not GOES_ON:
            object.__setattr__(self, "_moves", self._moves + 1)
        if touched.added is not None:
            self._stepper.add_rows(touched.added)
            self._events.note_added(touched.added)
            if touched.added.paths:
                self._know_play()
            if touched.added.thrusters or touched.added.regions:
                self._last_switch = last_switch(self.state)
        if touched.rows is not None:
            self._stepper.move_rows(touched.rows)
            self._events.note_moved(touched.rows)
            self._views.forget()
            self._last_switch = last_switch(self.state)
        if touched.displaced is not None:
            self._events.note_displaced(*touched.displaced)
        if touched.joints:
            self._stepper.assemble_joints()
        if touched.regions:
            self._stepper.follow_regions()
        if touched.schedules or touched.regions:
            self._last_switch = last_switch(self.state)
        if touched.everybody:
            self._stepper.forget()
        elif touched.active_set:
            self._stepper.touch(touched.bodies)
        counters = self._stepper.counters
        counters[CounterPlace.STILL] = counters[CounterPlace.WATCH] = 0

    def __repr__(self) -> str:
        return f"<World of {len(self.state.bodies)} bodies at step {self.step_count}>"


def _made_again(kind: type[World], scene: Any, workers: int, data: bytes, last_step: LastStep) -> World:
    """The world that `World.__reduce_ex__` tells of. A subclass gets its own attributes afterwards."""
    world = kind.__new__(kind)
    World.__init__(world, scene, workers)
    world.restore(data)
    world.recall(last_step)
    return world
