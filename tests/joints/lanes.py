"""What lies in the lanes of the joint solver, told by joint and row."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from sandbox._vectors import WIDTH
from sandbox.engine.joints.direct import places as at
from sandbox.engine.world import World


class LaneRow(NamedTuple):
    """A row of a factorised part: its joint and slot, where it lasts and where it is worked on, both in its own lane,
    and the bodies on its sides, -1 the world. `last` is true in the batch that was worked on last."""

    joint: int
    slot: int
    kept: int
    place: int
    bodies: list[int]
    last: bool


def lane_rows(world: World) -> Iterator[LaneRow]:
    """All rows of a world whose parts are awake and all factorised."""
    work: Any = world.scratch.joints
    d = work.direct
    count = int(d.found[0])
    last = max(range(count), key=lambda n: (int(d.batches[n].level), n), default=-1)
    for n, batch in enumerate(d.batches[:count]):
        layout = d.layouts[batch.layout]
        for k in range(batch.count):
            part = work.parts[d.parts[n * WIDTH + k]]
            bodies = d.bodies[batch.bodies : batch.bodies + layout.seats * WIDTH].reshape(-1, WIDTH)[:, k].tolist()
            for f in range(layout.first_frame, layout.frame_end):
                frame = d.layout_frames[f]
                joint = int(work.constraints[part.first_constraint + frame.joint].joint)
                for row in d.equations[frame.first_row : frame.row_end]:
                    sides = [bodies[row[f"seat_{s + 1}"] // at.SEAT_SIZE] for s in range(row.sides)]
                    kept, place = int(batch.rows + row.kept) + k, int(row.place) + k
                    yield LaneRow(joint, int(row.slot), kept, place, sides, n == last)


def some_part_is_separated(world: World) -> bool:
    """Whether the last substep of some part that is awake took its joints for torn apart."""
    d: Any = world.scratch.joints.direct  # type: ignore[union-attr]
    batches = d.batches[: int(d.found[0])]
    return any(d.memory[batch.lanes + at.SEPARATED + k] == 1.0 for batch in batches for k in range(int(batch.count)))


def strained_bodies(world: World) -> list[int]:
    """Bodies that were given more inertia than their own in the last substep."""
    d: Any = world.scratch.joints.direct  # type: ignore[union-attr]
    inertia = world.state.bodies.inverse_inertia
    found = []
    for batch in d.batches[: int(d.found[0])]:
        for slot in range(d.layouts[batch.layout].moving):
            for k in range(int(batch.count)):
                body = int(d.bodies[batch.bodies + slot * WIDTH + k])
                if d.memory[batch.seats + slot * at.SEAT_SIZE + at.INVERSE_INERTIA + k] != inertia[body]:
                    found.append(body)
    return found


def kept_field(world: World, rows: list[tuple[int, int]], field: int) -> Any:
    """What lasts of the rows of these joints and slots."""
    memory = world.scratch.joints.direct.memory  # type: ignore[union-attr]
    place = {(row.joint, row.slot): float(memory[row.kept + field]) for row in lane_rows(world)}
    return np.array([place[row] for row in rows])
