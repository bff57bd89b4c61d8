"""Bodies that rules and controls bring: which number they get, where they come, and how many may be there."""

from __future__ import annotations

from typing import Any

from sandbox.engine.commands.spawn import Spawn
from sandbox.engine.rules.base import RuledWorld
from sandbox.geometry.rotation import RADIANS_PER_DEGREE
from sandbox.scene.flat_rules import FlatSpawn
from sandbox.tables import plain
from sandbox.world.build_fields import step_at
from sandbox.world.build_rules import spawned_names

Words = dict[str, Any]


class Spawner:
    """Makes the entries of new bodies for one world."""

    def __init__(self, world: RuledWorld) -> None:
        self._world = world
        self._rows = {name: row for row, name in enumerate(spawned_names(world.state.census.scene))}

    def command(self, action: FlatSpawn, at: str | None) -> tuple[int, Spawn] | None:
        """The number and the command for a new body, in the frame of the body `at`; None if none may come now."""
        assert action.body is not None
        state, name = self._world.state, action.body.id
        row = plain(state.spawners)[self._rows[name]]
        step, pause = int(state.counters[0].step_count), step_at(action.every, state.census.scene.settings.step_rate)
        if (row["last_step"] >= 0 and step - row["last_step"] < pause) or state.census.bodies.numbered(
            name
        ) >= action.limit:
            return None
        number = int(row["count"]) + 1
        while self._world.directory.has_body(f"{name}-{number}"):
            number += 1
        words = {**action.words, "id": f"{name}-{number}"}
        return number, Spawn(words if at is None else {**words, **self._framed(action, at)})

    def note(self, action: FlatSpawn, number: int) -> str:
        """The body of that number has come; returns its id."""
        assert action.body is not None
        state, name = self._world.state, action.body.id
        row = plain(state.spawners)[self._rows[name]]
        row["count"], row["last_step"] = number, int(state.counters[0].step_count)
        return f"{name}-{number}"

    def _framed(self, action: FlatSpawn, at: str) -> Words:
        """Where a body is and how it moves, whose entry counts from another body."""
        body, frame = action.body, plain(self._world.state.bodies)[self._world.directory.body(at)]
        assert body is not None
        cosine, sine = float(frame["rotation_cos"]), float(frame["rotation_sin"])

        def turned(x: float, y: float) -> list[float]:
            return [cosine * x - sine * y, sine * x + cosine * y]

        x, y = turned(*body.position)
        found: Words = {"position": [float(frame["position_x"]) + x, float(frame["position_y"]) + y]}
        angle = body.angle + float(frame["angle"])
        if angle != 0.0:
            found["angle"] = angle / RADIANS_PER_DEGREE
        if body.velocity != (0.0, 0.0):
            found["velocity"] = turned(*body.velocity)
        return found
