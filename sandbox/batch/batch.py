"""The public face of a batch."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from sandbox.arguments import checked_count, checked_list, shown
from sandbox.attributes import FixedAttributes, attributes_besides
from sandbox.batch import column_commands as columns
from sandbox.batch.fleet import Fleet, Saved
from sandbox.engine.commands.base import Command
from sandbox.engine.world import World
from sandbox.errors import ArgumentError
from sandbox.scene import Scene
from sandbox.scene.near_names import nearest
from sandbox.tables import Floats, Integers


class Batch(FixedAttributes):
    """Many worlds of one scene, stepped in one call over all cores; each goes its way as it would alone, to the bit.

    `Batch(scene, 1000)` has 1,000 worlds that begin alike; `Batch([scene, ...])` one for each scene. A scene that has
    the same bodies and shapes as the first one shares memory with it, whatever its poses, masses and materials.
    `threads` are one for each processor by default. Units are SI, angles are in radians.

    Columns (`positions` and others) are read-only views (worlds, bodies, ...) that follow the batch. `worlds` of a
    method are all by default, or the numbers of some, or a mask with a truth for each. What controls, rules and paths
    do runs in Python: scenes with those work, but each of their worlds costs what a `World` does.
    """

    __slots__ = ("_columns", "_fleet", "_start", "names", "scene")

    def __init__(self, scene: Scene | Sequence[Scene], count: int | None = None, threads: int | None = None) -> None:
        wanted = "a Scene and how many worlds, or a list of Scenes"
        if isinstance(scene, Scene):
            scenes = [scene] * checked_count("Batch", count, "worlds", 1)
        else:
            scenes = checked_list("Batch", wanted, scene)
        if not scenes or not all(isinstance(each, Scene) for each in scenes):
            raise ArgumentError(f"Batch: takes {wanted}, not {shown(scene)}")
        threads = None if threads is None else checked_count("Batch", threads, "threads", 1)
        self.scene = scenes[0]
        self._fleet = Fleet(scenes, threads)
        self._start = self._fleet.saved()
        self.names: tuple[str, ...] = self._fleet.look(0).names
        self._columns = self._fleet.layout.columns(self._fleet.rows.words, "bodies")

    def __reduce_ex__(self, protocol: Any) -> tuple[Any, ...]:
        """How to make a batch like it: from the scenes and snapshots, never from memory that both would share."""
        fleet = self._fleet
        made_of = type(self), fleet.scenes, fleet.threads, self._start, fleet.saved()
        return _made_again, made_of, attributes_besides(Batch, object.__getstate__(self))

    def __len__(self) -> int:
        return len(self._fleet.scenes)

    def step(self, n: int = 1) -> None:
        """Advance all worlds by `n` steps.

        Raises `CapacityError` where a world would need more memory than is allowed; others may have been stepped then.
        """
        self._fleet.step(checked_count("Batch.step", n))

    def apply(self, command: Command | Sequence[Command], worlds: Any = None) -> None:
        """Apply a command to each of `worlds`, or to each its own from a list of as many; as with `World.apply`.

        Raises what that raises, at the first world that refuses; those before it have been changed then.
        """
        chosen = self._chosen(worlds)
        one = isinstance(command, Command)
        wanted = "a command, or a list of one for each world"
        commands = [command] * len(chosen) if one else checked_list("Batch.apply", wanted, command)
        if len(commands) != len(chosen):
            raise ArgumentError(f"Batch.apply: {len(commands)} commands for {len(chosen)} worlds")
        for world, one in zip(chosen.tolist(), commands, strict=True):
            self._fleet.apply(world, one)

    def apply_force(self, body: str, force: Any, torque: Any = 0.0, worlds: Any = None) -> None:
        """Push a body during the next step in each of `worlds`: the command `ApplyForce`, for all of them at once.

        `force` is (worlds, 2) or one for all, N; `torque` (worlds,) or one, N m. Raises `ArgumentError`.
        """
        call, chosen = "Batch.apply_force", self._chosen(worlds)
        forces = columns.numbers(call, "force", force, (len(chosen), 2))
        torques = columns.numbers(call, "torque", torque, (len(chosen),))
        columns.push(self._fleet, self._told(body), forces, torques, chosen)

    def set_pose(self, body: str, position: Any, angle: Any, worlds: Any = None) -> None:
        """Put a body at `position` (worlds, 2), m, and `angle` (worlds,), rad, as `SetPose` does, or at one for all.

        Raises `ArgumentError`.
        """
        call, chosen = "Batch.set_pose", self._chosen(worlds)
        positions = columns.numbers(call, "position", position, (len(chosen), 2))
        angles = columns.numbers(call, "angle", angle, (len(chosen),))
        columns.pose(self._fleet, self._told(body), positions, angles, chosen)

    def set_velocity(self, body: str, velocity: Any, angular_velocity: Any = 0.0, worlds: Any = None) -> None:
        """Give a body a `velocity` (worlds, 2), m/s, and an angular one (worlds,), rad/s, as `SetVelocity` does.

        Raises `ArgumentError`.
        """
        call, chosen = "Batch.set_velocity", self._chosen(worlds)
        velocities = columns.numbers(call, "velocity", velocity, (len(chosen), 2))
        rates = columns.numbers(call, "angular_velocity", angular_velocity, (len(chosen),))
        columns.velocity(self._fleet, self._told(body), velocities, rates, chosen)

    def reset(self, worlds: Any = None) -> None:
        """Begin anew with some worlds, from where the batch began."""
        self._fleet.restore(self._start, self._chosen(worlds))

    def snapshot(self) -> Saved:
        """All worlds as they are now, for `restore`. It stays in this process."""
        return self._fleet.saved()

    def restore(self, snapshot: Saved, worlds: Any = None) -> None:
        """Go back to a snapshot of this batch, with some worlds or with all."""
        if not isinstance(snapshot, Saved) or snapshot.words.shape != self._fleet.rows.words.shape:
            raise ArgumentError(f"Batch.restore: takes what snapshot of this batch gave, not {shown(snapshot)}")
        self._fleet.restore(snapshot, self._chosen(worlds))

    def world(self, number: int) -> World:
        """A world by itself that goes on from where that one is: for events, queries, pictures."""
        return self._fleet.own(self._number(number))

    def digest(self, number: int) -> str:
        """The digest of one world, that of a `World` which has gone the same way."""
        return self._fleet.look(self._number(number)).digest()

    def row(self, body: str) -> int:
        """Where a body is in the columns. Raises `ArgumentError` with the nearest name."""
        if not isinstance(body, str) or body not in self.names:
            near = nearest(body, self.names) if isinstance(body, str) else None
            hint = f"; did you mean {near!r}?" if near else ""
            raise ArgumentError(f"no body {shown(body)} in these worlds{hint}")
        return self.names.index(body)

    @property
    def positions(self) -> Floats:
        """(worlds, bodies, 2) m, the bodies' origins."""
        return self._vectors("position_x")

    @property
    def angles(self) -> Floats:
        """(worlds, bodies) rad, not wrapped."""
        view: Floats = self._column("angle")
        return view

    @property
    def velocities(self) -> Floats:
        """(worlds, bodies, 2) m/s, of the centres of mass."""
        return self._vectors("velocity_x")

    @property
    def angular_velocities(self) -> Floats:
        """(worlds, bodies) rad/s."""
        view: Floats = self._column("angular_velocity")
        return view

    @property
    def step_counts(self) -> Integers:
        """(worlds,) steps taken since the start. A copy."""
        counters = self._fleet.layout.columns(self._fleet.rows.words, "counters")
        steps: Integers = counters["step_count"][:, 0].copy()
        return steps

    def _told(self, body: str) -> tuple[str, int]:
        return body, self.row(body)

    def _column(self, name: str) -> Any:
        if self._fleet.ragged:
            which = min(self._fleet.ragged)
            text = f"world {which} has other bodies than at first, so that columns cannot show it"
            raise ArgumentError(f"{text}; world({which}) shows it, reset({which}) mends it")
        view = self._columns[name]
        view.flags.writeable = False
        return view

    def _vectors(self, first: str) -> Floats:
        column = self._column(first)
        stride = column.itemsize  # the y of a vector follows its x
        shape, strides = (*column.shape, 2), (*column.strides, stride)
        view: Floats = np.lib.stride_tricks.as_strided(column, shape, strides, writeable=False)
        return view

    def _number(self, number: Any) -> int:
        return int(self._chosen(checked_count("Batch", number, "the world"))[0])

    def _chosen(self, worlds: Any) -> Integers:
        """The numbers of some worlds. Raises `ArgumentError`."""
        count = len(self)
        if worlds is None:
            return np.arange(count)
        found = np.atleast_1d(np.asarray(worlds))
        if found.dtype == np.bool_ and found.shape == (count,):
            return np.flatnonzero(found)
        if found.ndim == 1 and (found.dtype.kind in "iu" or not len(found)):
            numbers = found.astype(np.int64)
            if not len(numbers) or (numbers.min() >= 0 and numbers.max() < count):
                return numbers
        raise ArgumentError(f"worlds are numbers from 0 to {count - 1}, or {count} truths, not {shown(worlds)}")

    def __repr__(self) -> str:
        return f"<Batch of {len(self)} worlds of {len(self.names)} bodies>"


def _made_again(kind: type[Batch], scenes: Sequence[Scene], threads: int, start: Saved, now: Saved) -> Batch:
    """The batch that `Batch.__reduce_ex__` tells of. A subclass gets its own attributes afterwards."""
    batch = kind.__new__(kind)
    Batch.__init__(batch, scenes, threads=threads)
    batch._start = start
    batch.restore(now)
    return batch
