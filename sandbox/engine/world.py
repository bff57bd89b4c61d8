"""The world: a scene set in motion."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from sandbox.engine.commands.body_commands import PUSHES, Command, SetPose, SetSurface, apply_command
from sandbox.engine.commands.field_commands import FieldCommand, apply_field_command
from sandbox.engine.commands.joint_commands import JointCommand, apply_joint_command
from sandbox.engine.commands.row_commands import RowCommand, apply_row_command
from sandbox.engine.commands.world_commands import WorldCommand, apply_world_command
from sandbox.engine.events.between_steps import Interlude, Ties
from sandbox.engine.events.events import SENSOR_EVENT, Events, differences, happened, nothing
from sandbox.engine.fields.records import last_switch
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.stepper import Stepper
from sandbox.engine.views.bodies import Bodies, Body
from sandbox.engine.views.directory import Directory
from sandbox.engine.views.joint import Joint
from sandbox.errors import CommandError
from sandbox.notebook import Shown
from sandbox.tables import Floats
from sandbox.world.build import build_state
from sandbox.world.digest import digest
from sandbox.world.flush import join_tiles
from sandbox.world.records import DYNAMIC, STATIC
from sandbox.world.roster import Roster
from sandbox.world.rows import Moved
from sandbox.world.snapshot import restore, snapshot
from sandbox.world.state import State

if TYPE_CHECKING:
    from sandbox.engine.events.sensors import Sensing
    from sandbox.engine.queries.queries import Queries
    from sandbox.scene import Scene
    from sandbox.scene.flat import FlatScene
    from sandbox.scene.spawned import Spawning


class World(Shown):
    """A simulation of one scene.

    The same scene and the same commands give the same bits on every machine. `step` advances, `apply` is the only
    way to change anything from outside, everything else reads.
    """

    def __init__(self, scene: Scene | FlatScene) -> None:
        self.scene = scene
        self.state: State = build_state(scene.flatten() if hasattr(scene, "flatten") else scene)
        self.changes = 0
        """Counts steps, commands and restores: while it stays the same, nothing has moved."""
        self._events: Events | None = nothing(0, self.state.names)
        self._interlude = Interlude()
        self._sensing = self._make_sensing()
        self._stepper = Stepper(self.state)
        self._know_rows()
        self.bodies = Bodies(self)

    def step(self, n: int = 1) -> None:
        """Advance by `n` steps of `1 / step_rate` seconds each."""
        self._stepper.compile()
        self.changes += 1
        stepper, counters = self._stepper, self._stepper.counters
        for taken in range(n):
            if counters["still"][0] and counters["step_count"][0] > self._last_switch:
                counters["step_count"][0] += n - taken  # all asleep: nothing else would change
                self._events = nothing(self.step_count, self.names)
                return
            stepper.step()
            self._events = None
            self._interlude.close()
            if self._sensing is not None:
                self._sensing.look()

    def apply(self, command: Command | JointCommand | WorldCommand | RowCommand | FieldCommand) -> None:
        """Apply a command.

        Raises `CommandError`, `UnknownBodyError`, `UnknownJointError` or `UnknownRegionError` and changes nothing if it
        can't be done.
        """
        self.changes += 1
        stirs = False
        if isinstance(command, RowCommand):
            self._events = self.events  # it speaks of the rows that were
            ties = Ties.of(self.state, self._sensing)
            moved = apply_row_command(self, command)
            self._interlude.note_rows(ties, moved)
            self._follow(moved)
        elif isinstance(command, JointCommand):
            if apply_joint_command(self.state, self.directory.joint(command.joint), command):
                self._stepper.assemble_joints()
        elif isinstance(command, WorldCommand):
            apply_world_command(self, command)
        elif isinstance(command, FieldCommand):
            apply_field_command(self, command)
            self._last_switch = last_switch(self.state)
        elif not isinstance(command, Command):
            raise CommandError(f"{command!r} is no command; they are in sandbox.engine.commands")
        else:
            index = self.directory.body(command.body)
            body = self.state.bodies[index]
            stirs = isinstance(command, PUSHES) and body.type == DYNAMIC and body.awake == 1
            if isinstance(command, SetPose):
                self._interlude.note_pose(index, self.state.bodies[index])
            elif isinstance(command, SetSurface) and command.density is not None:
                self._events = self.events  # places are measured from centres of mass, which may move
            apply_command(self.state, index, command)
            if isinstance(command, SetPose) and self.state.bodies[index].type == STATIC:
                join_tiles(self.state.bodies, self.state.shapes, self.state.vertices, self.state.seams)
        if not stirs:
            self._stepper.forget()
        self._stepper.counters["still"][0] = 0
        self._stepper.counters["substep_watch"][0] = 0

    @property
    def time(self) -> float:
        """Seconds since the start."""
        return self.step_count * float(self.state.settings[0].step_seconds)

    @property
    def step_count(self) -> int:
        """Steps taken since the start."""
        return int(self._stepper.counters["step_count"][0])

    @property
    def names(self) -> tuple[str, ...]:
        """Body ids in the order of `bodies`."""
        return self.state.names

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Joint ids in the order of the scene, then those that were spawned."""
        return self.state.joint_names

    @property
    def flat(self) -> FlatScene:
        """The scene with the bodies and joints that are there now, row by row, as they came into the world."""
        return self.state.roster.flat

    @property
    def layout(self) -> int:
        """Counts how often rows have moved: while it stays the same, row `i` of `bodies` is the same body."""
        return self.state.layout

    @cached_property
    def spawning(self) -> Spawning:
        """Reads what is spawned."""
        from sandbox.scene.flat import FlatScene
        from sandbox.scene.spawned import Spawning  # worlds in which nothing is spawned pay nothing

        return Spawning(self.scene if not isinstance(self.scene, FlatScene) else None)

    def joint(self, name: str) -> Joint:
        """The joint of that id. Raises `UnknownJointError` with the nearest name."""
        return Joint(self, self.directory.joint(name))

    def body(self, name: str) -> Body:
        """The body of that id. Raises `UnknownBodyError` with the nearest name."""
        return Body(self, self.directory.body(name))

    @property
    def awake_count(self) -> int:
        """How many dynamic bodies are awake now."""
        bodies = self.state.bodies
        return int(np.count_nonzero((bodies.type == DYNAMIC) & (bodies.awake == 1)))

    @property
    def contacts(self) -> Any:
        """The contacts of the last step: `records.CONTACT` rows, sorted by shape. A view; copy what you keep."""
        return self.state.contacts[: int(self.state.counters[0].contact_count)]

    @property
    def contact_impulses(self) -> Floats:
        """Normal impulse (N s) of each of `contacts` over the whole last step, impacts included. A copy."""
        impulses: Floats = self.scratch.contacts.reports.total_impulse[: len(self.contacts)].copy()
        return impulses

    @property
    def events(self) -> Events:
        """What happened during the last step: contacts that began, ended or struck, sensors, sleep. Ask every step."""
        if self._events is None:
            sensing = self._sensing
            enter, leave = differences(sensing.before, sensing.now) if sensing else (SENSOR_EVENT.zeros(0),) * 2
            reports = self.scratch.contacts.reports
            self._events = happened(self.state, self.scratch.contacts.now, reports, enter, leave, self._interlude)
        return self._events

    @property
    def sensed(self) -> tuple[tuple[str, str], ...]:
        """(sensor's body, other body) for everything that a sensor has in it now, each pair once, in scene order."""
        if self._sensing is None:
            return ()
        rows = self._sensing.now
        pairs = sorted(set(zip(rows.sensor_body.tolist(), rows.body.tolist(), strict=True)))
        return tuple((self.names[a], self.names[b]) for a, b in pairs)

    @property
    def scratch(self) -> Scratch:
        """What the last step left in its memory (boxes, proposed pairs), for tools that look into it; read only."""
        return self._stepper.scratch

    @property
    def frozen(self) -> list[tuple[str, int]]:
        """(body id, step) of every body that bad numbers froze."""
        rows = self.state.bodies.frozen_step
        return [(self.names[i], int(rows[i])) for i in range(len(rows)) if rows[i] >= 0]

    @cached_property
    def query(self) -> Queries:
        """Rays, casts, overlaps and distances: read-only questions about where things are."""
        from sandbox.engine.queries.queries import Queries  # worlds that are asked nothing pay nothing

        return Queries(self)

    def digest(self) -> str:
        """Fingerprint of the whole state, 16 hex digits: equal bits, equal digest."""
        return digest(self.state)

    def snapshot(self) -> bytes:
        """The whole state as bytes, for `restore`."""
        return snapshot(self.state)

    def restore(self, data: bytes) -> None:
        """Go back to a snapshot of this scene. Raises `SnapshotError` and changes nothing if it can't."""
        self.changes += 1
        layout = self.layout
        restore(self.state, data, self._read_roster)
        if self.layout != layout:
            self._know_rows()
        self._last_switch = last_switch(self.state)
        if self.layout != layout or len(self.state.contacts) != len(self.scratch.contacts.now):
            self._stepper.renew()
        elif len(self.state.joints):
            self._stepper.assemble_joints()
        self._stepper.forget()
        self._events, self._interlude = nothing(self.step_count, self.names), Interlude()
        self.scratch.contacts.reports.total_impulse = 0.0
        if self.layout != layout:
            self._sensing = self._make_sensing()
        if self._sensing is not None:
            self._sensing.forget()

    def _read_roster(self, text: bytes) -> Roster:
        from sandbox.world.roster_reading import read_roster

        return read_roster(text, self.state.roster.scene, self.spawning.read)

    def _know_rows(self) -> None:
        """Note where everybody is now, and when fields begin and end."""
        self.directory = Directory(self.state)
        self._last_switch = last_switch(self.state)

    def _follow(self, moved: Moved) -> None:
        """Bring everything that knows of rows up to date after rows have come or gone."""
        self._know_rows()
        old, blocks = self.scratch.contacts.reports, len(self.scratch.blocks.blocks)
        self._stepper.renew(blocks=blocks)
        self.scratch.contacts.reports[: len(moved.contacts)] = old[moved.contacts]
        before, self._sensing = self._sensing, self._make_sensing()
        if self._sensing is not None and before is not None:
            self._sensing.follow(before, moved)

    def _make_sensing(self) -> Sensing | None:
        if not self.state.shapes.sensor.any():
            return None
        from sandbox.engine.events.sensors import Sensing  # worlds without sensors pay nothing

        return Sensing(self.state)

    def __repr__(self) -> str:
        return f"<World of {len(self.names)} bodies at step {self.step_count}>"
