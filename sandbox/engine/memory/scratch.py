"""Memory that a step needs and forgets: never hashed, never saved, only grown."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sandbox.engine.active.active_set import new_active_set
from sandbox.engine.active.pile_stability import PILE
from sandbox.engine.broad_phase.grid import LEVEL_SPACE, head_count
from sandbox.engine.contact_solver.blocks import ALL_COLORS, BLOCK_SIZE, MAX_COLORS
from sandbox.engine.contact_solver.further_colors import MOST_WORDS
from sandbox.engine.fields.records import Fields, has_fields
from sandbox.engine.joints.assembly import assemble
from sandbox.engine.joints.pair_filter import JointFilter
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.joints.records import JointWork
from sandbox.engine.memory.limit import most_batches, most_blocks
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.batches import BLOCKS, IMPACT, SIZE, STRUCK_BODY, Batches
from sandbox.engine.records.bodies import BEFORE_IMPACTS, BODY_FORCES, FREE_MOTION, MOTION, SolverBodies
from sandbox.engine.records.ccd import CCD_BODY, CCD_IMPACT, Ccd
from sandbox.engine.records.colliders import BOX, FILTER, PAIR, PROXY, RESTING_GRID, Colliders, Grid, RestingGrid
from sandbox.engine.records.contact_blocks import BLOCK, SLOT, ContactBlocks
from sandbox.engine.records.contacts import REPORT, SLEEPING_CURSOR, SLEEPING_RUN, Contacts
from sandbox.engine.records.decisions import Decisions, decisions_memory
from sandbox.engine.records.workers import Workers, workers_memory
from sandbox.geometry.manifold import MANIFOLD
from sandbox.geometry.time_of_impact import POSED_ROWS, SWEEP
from sandbox.tables import Records, aligned_zeros, plain
from sandbox.world.records import CONTACT, VERTEX
from sandbox.world.state import State


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
        joint_filter, joints = assemble(state.joints, state.bodies, layouts or PartLayouts(), room.bodies)
        return cls(
            room=room,
            active=_active_set(state, room),
            solver=_solver_bodies(room.bodies),
            piles=PILE.zeros(room.bodies),
            colliders=_colliders(room),
            grid=_grid(room.shapes, pair_capacity),
            contacts=_contacts(state, pair_capacity),
            blocks=_blocks(pair_capacity, _batches(room.bodies, pair_capacity, workers)),
            ccd=_ccd(state, room),
            joint_filter=joint_filter,
            joints=joints,
            fields=Fields.for_state(state, room.bodies),
            workers=workers_memory(workers),
            decisions=decisions_memory(workers),
        )

    def follow_rows(self, state: State, bodies: int, shapes: int) -> bool:
        """Bring up to date what is known of the bodies and shapes from those rows on, which have come or moved.

        If there are more of them than there is room for, memory for twice as many is taken; returns whether it was.
        All of it has to be looked at anew (`active.info.stale`).
        """
        fits = self.room.holds(Room.of(state))
        if not fits:
            self._grow(state)
        else:
            _fill_thin(self.ccd.bodies, state, bodies, shapes)
        self.follow_fields(state)
        plain(self.active.info)["stale"] = 1
        return not fits

    def follow_fields(self, state: State) -> None:
        """Bring up to date what is known of regions and thrusters, and take what memory they lack."""
        fields = self.fields._replace(regions=state.regions, edges=state.edges, thrusters=state.thrusters)
        lacks_bodies = has_fields(state) and len(fields.pushes) < self.room.bodies
        lacks_pieces = len(state.regions) > 0 and len(fields.pieces) == 0
        self.fields = Fields.for_state(state, self.room.bodies) if lacks_bodies or lacks_pieces else fields

    def make_room_for_pairs(self, state: State, pairs: int, workers: int) -> None:
        """Take memory for so many pairs; what is known of bodies, shapes and joints is kept."""
        self.grid = self.grid._replace(pairs=PAIR.zeros(pairs), sorted_pairs=PAIR.zeros(pairs + 1))
        self.contacts = _contacts(state, pairs)
        self.blocks = _blocks(pairs, _batches(self.room.bodies, pairs, workers))

    def make_room_for_joints(self) -> None:
        """Let the joint solver know as many bodies as there is room for."""
        lacking = self.room.bodies - len(self.joint_filter.joined)
        joined = np.append(self.joint_filter.joined, np.zeros(lacking, np.int64))
        self.joint_filter = self.joint_filter._replace(joined=joined)
        if self.joints is not None:
            part_of = np.append(self.joints.part_of, np.full(lacking, -1))
            self.joints = self.joints._replace(part_of=part_of)

    def _grow(self, state: State) -> None:
        """Take memory for twice as many bodies and shapes as there are; pairs and contacts keep theirs."""
        room = self.room = Room(*(2 * count for count in Room.of(state)))
        self.active = _active_set(state, room)._replace(info=self.active.info)
        self.solver = _solver_bodies(room.bodies)
        self.piles = PILE.zeros(room.bodies)
        more = STRUCK_BODY.zeros(room.bodies)
        batches = self.blocks.batches._replace(bodies=np.zeros(room.bodies, np.int64), struck=more)
        self.blocks = self.blocks._replace(batches=batches)
        self.colliders = _colliders(room)
        shapes = _grid(room.shapes, 0)
        self.grid = shapes._replace(pairs=self.grid.pairs, sorted_pairs=self.grid.sorted_pairs)
        self.ccd = _ccd(state, room)
        self.fields = Fields.for_state(state, room.bodies)


class Room(NamedTuple):
    """For how many bodies, shapes and core vertices there is memory."""

    bodies: int
    shapes: int
    vertices: int

    @classmethod
    def of(cls, state: State) -> Room:
        """As many as a state has."""
        return cls(len(state.bodies), len(state.shapes), len(state.vertices))

    def holds(self, other: Room) -> bool:
        """Whether it is as large, in everything."""
        return self.bodies >= other.bodies and self.shapes >= other.shapes and self.vertices >= other.vertices


def _active_set(state: State, room: Room) -> ActiveSet:
    return ActiveSet(
        info=new_active_set(),
        bodies=np.zeros(room.bodies + 1, np.int64),
        loose=np.zeros(room.bodies + 1, np.int64),
        activity=np.zeros(room.bodies, np.int64),
        shapes=np.arange(room.shapes),
        loose_shapes=np.zeros(room.shapes, np.int64),
    )


def _solver_bodies(bodies: int) -> SolverBodies:
    return SolverBodies(
        motions=MOTION.zeros(bodies),
        free_motions=FREE_MOTION.zeros(bodies),
        forces=BODY_FORCES.zeros(bodies),
        before_impacts=BEFORE_IMPACTS.zeros(bodies),
        flags=np.zeros(bodies, np.int64),
        colors=np.zeros(bodies, np.int64),
        struck=np.zeros(bodies, np.int64),
        islands=np.zeros(bodies, np.int64),
        batches=np.zeros(bodies, np.int64),
    )


def _colliders(room: Room) -> Colliders:
    return Colliders(
        cores=VERTEX.zeros(room.vertices),
        boxes=BOX.zeros(room.shapes),
        filters=FILTER.zeros(room.shapes),
        proxies=PROXY.zeros(room.shapes),
    )


def _grid(shapes: int, pairs: int) -> Grid:
    return Grid(
        spare_boxes=BOX.zeros(shapes),
        ordered=BOX.zeros(shapes),
        heads=np.zeros(head_count(shapes), np.int64),
        levels=np.zeros(LEVEL_SPACE, np.int64),
        resting=_resting_grid(shapes),
        apart=_resting_grid(shapes),
        pairs=PAIR.zeros(pairs),
        sorted_pairs=PAIR.zeros(pairs + 1),  # continuous collision keeps one pair apart
    )


def _resting_grid(shapes: int) -> RestingGrid:
    heads, levels = np.zeros(head_count(shapes), np.int64), np.zeros(LEVEL_SPACE, np.int64)
    return RestingGrid(RESTING_GRID.zeros(1), heads, levels)


def _contacts(state: State, pairs: int) -> Contacts:
    return Contacts(
        now=CONTACT.zeros(pairs),
        before=state.contacts,
        active=np.zeros(pairs + 1, np.int64),
        impact_candidates=np.zeros(pairs + 1, np.int64),
        cursor=SLEEPING_CURSOR.zeros(1),
        runs=SLEEPING_RUN.zeros(3 * (pairs + 1)),
        reports=REPORT.zeros(pairs),
    )


def _blocks(pairs: int, batches: Batches) -> ContactBlocks:
    blocks = most_blocks(pairs)
    return ContactBlocks(
        slots=SLOT.zeros(pairs),
        blocks=BLOCK.zeros(blocks),
        colors=np.zeros(pairs, np.int64),
        lanes=aligned_zeros(blocks * BLOCK_SIZE, np.float64),
        heads=np.zeros(ALL_COLORS * most_batches(pairs) + 1, np.int64),
        further=np.zeros(MOST_WORDS * MAX_COLORS + 1, np.int64),
        further_heads=np.zeros(MOST_WORDS * MAX_COLORS + 1, np.int64),
        sets=np.zeros(pairs, np.int64),
        starts=np.zeros(blocks + 2, np.int64),
        spare=SLOT.zeros(pairs),
        batches=batches,
    )


def _batches(bodies: int, pairs: int, workers: int) -> Batches:
    batches = most_batches(pairs)
    blocks = (workers - 1) * BLOCKS if batches > 1 else 0
    return Batches(
        size=np.full(1, SIZE),
        bodies=np.zeros(bodies, np.int64),
        struck=STRUCK_BODY.zeros(bodies),
        first_body=np.zeros(batches + 1, np.int64),
        impacts=IMPACT.zeros(pairs),
        first_impact=np.zeros(batches + 1, np.int64),
        blocks=BLOCK.zeros(blocks),
        lanes=aligned_zeros(blocks * BLOCK_SIZE, np.float64),
        starts=np.zeros(blocks + 2 * workers, np.int64),
    )


def _ccd(state: State, room: Room) -> Ccd:
    bodies = CCD_BODY.zeros(room.bodies)
    _fill_thin(bodies, state, 0, 0)
    impacts = CCD_IMPACT.zeros(room.bodies)
    impacts.time = 1.0
    return Ccd(bodies, impacts, SWEEP.zeros(1), VERTEX.zeros(POSED_ROWS), MANIFOLD.zeros(2))


def _fill_thin(bodies: Records, state: State, first: int, first_shape: int) -> None:
    """Measure the thinnest shapes of the bodies from row `first` on, whose shapes begin at `first_shape`."""
    shapes = plain(state.shapes)[first_shape:]
    thin = np.full(len(state.bodies) - first, np.inf)
    np.minimum.at(thin, shapes["body"] - first, shapes["thin"])
    plain(bodies)["thin"][first : len(state.bodies)] = np.where(thin < np.inf, thin, 0.0)
