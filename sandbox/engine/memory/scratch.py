"""Memory that a step needs and forgets: never hashed, never saved, only grown."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.engine.active.active_set import new_active_set
from sandbox.engine.active.pile_stability import PILE
from sandbox.engine.broad_phase.grid import LEVEL_SPACE, head_count
from sandbox.engine.contact_solver.blocks import BLOCK_SIZE, GATHER_SIZE
from sandbox.engine.contact_solver.graph_coloring import SETTLED
from sandbox.engine.fields.records import Fields
from sandbox.engine.joints.assembly import assemble
from sandbox.engine.joints.pair_filter import JointFilter
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.engine.joints.records import JointWork
from sandbox.engine.memory.limit import most_blocks
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.bodies import BODY_FORCES, FREE_MOTION, MOTION, SolverBodies
from sandbox.engine.records.ccd import CCD_BODY, CCD_IMPACT, Ccd
from sandbox.engine.records.colliders import BOX, FILTER, PAIR, PROXY, Colliders, Grid
from sandbox.engine.records.contact_blocks import BLOCK, SLOT, ContactBlocks
from sandbox.engine.records.contacts import REPORT, SLEEPING_CURSOR, SLEEPING_RUN, Contacts
from sandbox.geometry.manifold import MANIFOLD
from sandbox.geometry.time_of_impact import POSED_ROWS, SWEEP
from sandbox.tables import Records, aligned_zeros
from sandbox.world.records import CONTACT, VERTEX
from sandbox.world.state import State


@dataclass
class Scratch:
    """The memory of one world's step, a bundle of tables for each concept.

    After a step, `contacts.now` has the contacts of the step before, which the next one overwrites.
    """

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

    @classmethod
    def for_state(cls, state: State, pair_capacity: int, layouts: PartLayouts | None = None) -> Scratch:
        """Scratch for all bodies and shapes of `state`, and for so many candidate pairs.

        `layouts` are those of parts that joints hold together, as far as they are known.
        """
        joint_filter, joints = assemble(state.joints, state.bodies, layouts or PartLayouts())
        return cls(
            active=_active_set(state),
            solver=_solver_bodies(len(state.bodies)),
            piles=PILE.zeros(len(state.bodies)),
            colliders=_colliders(state),
            grid=_grid(len(state.shapes), pair_capacity),
            contacts=_contacts(state, pair_capacity),
            blocks=_blocks(pair_capacity),
            ccd=_ccd(state),
            joint_filter=joint_filter,
            joints=joints,
            fields=Fields.for_state(state),
        )


def _active_set(state: State) -> ActiveSet:
    bodies = len(state.bodies)
    lists = np.zeros(bodies + 1, np.int64), np.zeros(bodies, np.int64)
    return ActiveSet(new_active_set(), *lists, np.arange(len(state.shapes)))


def _solver_bodies(bodies: int) -> SolverBodies:
    return SolverBodies(
        motions=MOTION.zeros(bodies),
        free_motions=FREE_MOTION.zeros(bodies),
        forces=BODY_FORCES.zeros(bodies),
        flags=np.zeros(bodies, np.int64),
        colors=np.zeros(bodies, np.int64),
        struck=np.zeros(bodies, np.int64),
    )


def _colliders(state: State) -> Colliders:
    shapes = len(state.shapes)
    return Colliders(
        cores=VERTEX.zeros(len(state.vertices)),
        boxes=BOX.zeros(shapes),
        filters=FILTER.zeros(shapes),
        proxies=PROXY.zeros(shapes),
    )


def _grid(shapes: int, pairs: int) -> Grid:
    return Grid(
        spare_boxes=BOX.zeros(shapes),
        ordered=BOX.zeros(shapes),
        heads=np.zeros(head_count(shapes), np.int64),
        levels=np.zeros(LEVEL_SPACE, np.int64),
        resting_heads=np.zeros(head_count(shapes), np.int64),
        resting_levels=np.zeros(LEVEL_SPACE, np.int64),
        pairs=PAIR.zeros(pairs),
        sorted_pairs=PAIR.zeros(pairs + 1),  # continuous collision keeps one pair apart
    )


def _contacts(state: State, pairs: int) -> Contacts:
    return Contacts(
        now=CONTACT.zeros(pairs),
        before=state.contacts,
        active=np.zeros(pairs + 1, np.int64),
        impact_candidates=np.zeros(pairs + 1, np.int64),
        cursor=SLEEPING_CURSOR.zeros(1),
        runs=SLEEPING_RUN.zeros(3 * (pairs + 1)),
        reports=REPORT.zeros(pairs),
        manifold=MANIFOLD.zeros(2),
    )


def _blocks(pairs: int) -> ContactBlocks:
    blocks = most_blocks(pairs)
    return ContactBlocks(
        slots=SLOT.zeros(pairs),
        blocks=BLOCK.zeros(blocks),
        colors=np.zeros(pairs, np.int64),
        lanes=aligned_zeros(blocks * BLOCK_SIZE, np.float64),
        gathered=aligned_zeros(GATHER_SIZE, np.float64),
        heads=np.zeros(2 * SETTLED + 1, np.int64),
        impacts=SLOT.zeros(pairs),
    )


def _ccd(state: State) -> Ccd:
    bodies = CCD_BODY.zeros(len(state.bodies))
    thin = np.full(len(bodies), np.inf)
    np.minimum.at(thin, state.shapes.body, state.shapes.thin)
    bodies.thin = np.where(thin < np.inf, thin, 0.0)
    for rows in (state.joints.body_a, state.joints.body_b):
        bodies.linked[rows[rows >= 0]] = 1
    impacts = CCD_IMPACT.zeros(len(state.bodies))
    impacts.time = 1.0
    return Ccd(bodies, impacts, SWEEP.zeros(1), VERTEX.zeros(POSED_ROWS), MANIFOLD.zeros(2))
