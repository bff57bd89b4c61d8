"""Memory that a step needs and forgets: never hashed, never saved, only grown."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.engine.active.pile_measures import PILE
from sandbox.engine.fields.records import Fields, has_fields
from sandbox.engine.joints.assembly import assemble
from sandbox.engine.joints.pair_filter import NO_BOND, JointFilter
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.joints.records import JointWork
from sandbox.engine.memory.bundles import (
    Room,
    active_memory,
    batch_memory,
    block_memory,
    cache_memory,
    ccd_memory,
    collider_memory,
    contact_memory,
    grid_memory,
    measure_thin,
    solver_memory,
)
from sandbox.engine.narrow_phase.sleeping_contacts import NOTHING
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.batches import STRUCK_BODY
from sandbox.engine.records.bodies import SolverBodies
from sandbox.engine.records.ccd import Ccd
from sandbox.engine.records.colliders import PAIR, Colliders, Grid
from sandbox.engine.records.contact_blocks import ContactBlocks
from sandbox.engine.records.contacts import Contacts
from sandbox.engine.records.decisions import Decisions, decisions_memory
from sandbox.engine.records.workers import Workers, workers_memory
from sandbox.tables import Records, plain
from sandbox.world.state import State

_LEAST = 64
"""Room for bodies and shapes once more of them come than there were at first."""


@dataclass
class Scratch:
    """The memory of one world's step, a bundle of tables for each concept. Tables with a row for each body or shape may
    have spare ones at the end, as `room` says.

    After a step, `contacts.now` has the contacts of the step before, which the next one overwrites.
    """

    room: Room
    active: ActiveSet
    solver: SolverBodies
    piles: Records
    colliders: Colliders
    grid: Grid
    contacts: Contacts
    blocks: ContactBlocks
    ccd: Ccd
    joint_filter: JointFilter
    joints: JointWork | None
    fields: Fields
    workers: Workers
    decisions: Decisions

    @classmethod
    def for_state(
        cls,
        state: State,
        pair_capacity: int,
        layouts: PartLayouts | None = None,
        room: Room | None = None,
        workers: int = 1,
    ) -> Scratch:
        """Scratch for all bodies and shapes of `state`, or for as many as `room` says if that is more, and for so many
        candidate pairs.

        `layouts` are those of parts that joints hold together, as far as they are known; `workers` is how many threads
        step the state.
        """
        room = room if room is not None and room.holds(Room.of(state)) else Room.of(state)
        layouts = layouts or PartLayouts(units_per_meter=float(state.settings[0].units_per_meter))
        joint_filter, joints = assemble(state.joints, state.bodies, layouts, room.bodies)
        return cls(
            room=room,
            active=active_memory(room),
            solver=solver_memory(state, room.bodies),
            piles=PILE.zeros(room.bodies),
            colliders=collider_memory(room),
            grid=grid_memory(room.shapes, pair_capacity),
            contacts=contact_memory(state, room.bodies, pair_capacity),
            blocks=block_memory(pair_capacity, batch_memory(room.bodies, pair_capacity, workers)),
            ccd=ccd_memory(room),
            joint_filter=joint_filter,
            joints=joints,
            fields=Fields.for_state(state, room.bodies),
            workers=workers_memory(workers),
            decisions=decisions_memory(workers),
        )

    def follow_rows(self, state: State, bodies: int, shapes: int) -> bool:
        """Bring up to date what is known of the bodies and shapes from those rows on, which have come or moved.

        If there are more of them than there is room for, memory for twice as many is taken, and all has to be looked at
        anew (`active.info.stale`); returns whether it was.
        """
        fits = self.room.holds(Room.of(state))
        if not fits:
            self._grow(state)
        else:
            measure_thin(self.solver.ccd, state, bodies, shapes)
        self.follow_fields(state)
        return not fits

    def follow_fields(self, state: State) -> None:
        """Bring up to date what is known of regions and thrusters, and take what memory they lack."""
        if len(self.fields.regions) + len(self.fields.thrusters) > 0 and not has_fields(state):
            plain(self.solver.free_motions)["buoyed"] = 0  # nobody else notes that they float no longer
        fields = self.fields._replace(regions=state.regions, edges=state.edges, thrusters=state.thrusters)
        lacks_bodies = has_fields(state) and len(fields.pushes) < self.room.bodies
        lacks_regions = len(fields.spans) < len(state.regions)
        self.fields = Fields.for_state(state, self.room.bodies) if lacks_bodies or lacks_regions else fields

    def make_room_for_pairs(self, state: State, pairs: int, workers: int) -> None:
        """Take memory for so many pairs; what is known of bodies, shapes and joints is kept."""
        self.grid = self.grid._replace(cache=cache_memory(pairs), pairs=PAIR.zeros(pairs))
        self.contacts = contact_memory(state, self.room.bodies, pairs)
        self.blocks = block_memory(pairs, batch_memory(self.room.bodies, pairs, workers))

    def make_room_for_joints(self) -> None:
        """Let the joint solver know as many bodies as there is room for."""
        lacking = self.room.bodies - len(self.joint_filter.first)
        first = np.append(self.joint_filter.first, np.full(lacking, NO_BOND))
        self.joint_filter = self.joint_filter._replace(first=first)
        if self.joints is not None:
            part_of = np.append(self.joints.part_of, np.full(lacking, -1))
            self.joints = self.joints._replace(part_of=part_of)

    def _grow(self, state: State) -> None:
        """Take memory for twice as many bodies and shapes as there are, or `_LEAST`; pairs and contacts keep theirs."""
        room = self.room = Room(*(max(_LEAST, 2 * count) for count in Room.of(state)))
        self.active = active_memory(room)._replace(info=self.active.info)
        plain(self.active.info)["stale"] = 1
        self.solver = solver_memory(state, room.bodies)
        self.piles = PILE.zeros(room.bodies)
        self.contacts = self.contacts._replace(first_kept=np.full(room.bodies, NOTHING))
        more = STRUCK_BODY.zeros(room.bodies)
        batches = self.blocks.batches._replace(bodies=np.zeros(room.bodies, np.int64), struck=more)
        self.blocks = self.blocks._replace(batches=batches)
        self.colliders = collider_memory(room)
        self.grid = grid_memory(room.shapes, 0)._replace(cache=self.grid.cache, pairs=self.grid.pairs)
        plain(self.grid.cache.info)["valid"] = 0  # its pairs are those of the fat boxes that there were
        self.ccd = ccd_memory(room)
        self.fields = Fields.for_state(state, room.bodies)
