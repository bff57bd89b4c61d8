"""The bundles of tables that a step works in, as memory for so many bodies, shapes and pairs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sandbox._jit import interpreted
from sandbox.engine.active.active_set import most_touched, new_active_set
from sandbox.engine.active.sleeping_islands import NOBODY
from sandbox.engine.broad_phase.fat_boxes import AHEAD
from sandbox.engine.broad_phase.grid import LEVEL_SPACE, LEVELS, head_count
from sandbox.engine.contact_solver.blocks import ALL_COLORS, BLOCK_SIZE, MAX_COLORS
from sandbox.engine.contact_solver.further_colors import MOST_WORDS
from sandbox.engine.memory.limit import FAT_PAIRS, most_batches, most_blocks
from sandbox.engine.narrow_phase.sleeping_contacts import NOTHING
from sandbox.engine.records.active_set import ActiveSet
from sandbox.engine.records.batches import BLOCKS, IMPACT, IMPACT_SLOT, SIZE, STRUCK_BODY, Batches
from sandbox.engine.records.bodies import (
    BODY_FORCES,
    FREE_MOTION,
    IMPACT_BODY,
    MOTION,
    VELOCITY_PART,
    SolverBodies,
)
from sandbox.engine.records.calls import ROWS
from sandbox.engine.records.ccd import CCD_BODY, CCD_IMPACT, Ccd
from sandbox.engine.records.colliders import (
    BOX,
    FILTER,
    GRID_BOX,
    GRID_INFO,
    PAIR,
    PAIR_CACHE,
    PROXY,
    Colliders,
    Grid,
    PairCache,
)
from sandbox.engine.records.contact_blocks import BLOCK, ContactBlocks
from sandbox.engine.records.contacts import KEPT, KEPT_LINK, REPORT, SLEEPING_CURSOR, SLEEPING_RUN, SLOT, Contacts
from sandbox.geometry.manifold import MANIFOLD
from sandbox.geometry.time_of_impact import POSED_ROWS, SWEEP
from sandbox.tables import Records, aligned_zeros, plain
from sandbox.world.records import CONTACT, VERTEX
from sandbox.world.state import State


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


def active_memory(room: Room) -> ActiveSet:
    """Who may move: so far everybody is to be looked at."""
    return ActiveSet(
        info=new_active_set(),
        bodies=np.zeros(room.bodies + 1, np.int64),
        touched=np.zeros(most_touched(room.bodies) + 1, np.int64),
        settled=np.zeros(most_touched(room.bodies) + 1, np.int64),
        activity=np.zeros(room.bodies, np.int64),
        shapes=np.arange(room.shapes),
        last_member=np.full(room.bodies, NOBODY),
        member_before=np.full(room.bodies, NOBODY),
    )


def solver_memory(state: State, bodies: int) -> SolverBodies:
    """What the solver has beside the body table, with so many rows."""
    ccd = CCD_BODY.zeros(bodies)
    measure_thin(ccd, state, 0, 0)
    motions = MOTION.zeros(bodies + 1)
    motions.delta_cos = 1.0  # of the world; that of bodies is set in each step
    return SolverBodies(
        motions=motions,
        free_motions=FREE_MOTION.zeros(bodies),
        forces=BODY_FORCES.zeros(bodies),
        impact_bodies=IMPACT_BODY.zeros(bodies),
        parts=VELOCITY_PART.zeros(bodies),
        flags=np.zeros(bodies, np.int64),
        colors=np.zeros(bodies, np.int64),
        first_impact=np.zeros(bodies, np.int64),
        struck=np.zeros(bodies, np.int64),
        islands=np.zeros(bodies, np.int64),
        batches=np.zeros(bodies, np.int64),
        ccd=ccd,
    )


def collider_memory(room: Room) -> Colliders:
    """Cores, boxes and proxies."""
    return Colliders(
        cores=VERTEX.zeros(room.vertices),
        boxes=BOX.zeros(room.shapes),
        filters=FILTER.zeros(room.shapes),
        proxies=PROXY.zeros(room.shapes),
    )


def grid_memory(shapes: int, pairs: int) -> Grid:
    """The grids of boxes, and the pairs that they find."""
    buckets = interpreted(head_count)(shapes)
    return Grid(
        info=GRID_INFO.zeros(1),
        fat_boxes=GRID_BOX.zeros(shapes),
        outgrown=np.zeros(shapes, np.int64),
        enlarged=np.zeros(shapes, np.int64),
        ordered=GRID_BOX.zeros(shapes),
        heads=np.zeros(buckets, np.int64),
        levels=np.zeros(LEVEL_SPACE, np.int64),
        moved_heads=np.zeros(buckets, np.int64),
        moved_next=np.zeros(shapes, np.int64),
        moved_on=np.zeros(LEVELS, np.int64),
        counts=np.zeros(shapes + 1, np.int64),
        cache=cache_memory(pairs),
        pairs=PAIR.zeros(pairs),
    )


def cache_memory(pairs: int) -> PairCache:
    """The pairs of fat boxes where there are so many pairs of boxes."""
    fat = FAT_PAIRS * pairs
    info = PAIR_CACHE.zeros(1)
    info.ahead = AHEAD
    # Continuous collision keeps one pair apart.
    return PairCache(info=info, pairs=PAIR.zeros(fat), spare=PAIR.zeros(fat + 1))


def contact_memory(state: State, bodies: int, pairs: int) -> Contacts:
    """Contacts of this step and of the one before, which the state holds."""
    return Contacts(
        now=CONTACT.zeros(pairs),
        before=state.contacts,
        active=SLOT.zeros(pairs + 1),
        impact_candidates=np.zeros(pairs + 1, np.int64),
        cursor=SLEEPING_CURSOR.zeros(1),
        runs=SLEEPING_RUN.zeros(3 * (pairs + 1)),
        kept=KEPT.zeros(2 * pairs),
        links=KEPT_LINK.zeros(2 * pairs),
        first_kept=np.full(bodies, NOTHING),
        reports=REPORT.zeros(pairs),
        calls=np.zeros((1, ROWS, 2), np.int64),  # `StepCalls` has those of all workers
    )


def block_memory(pairs: int, batches: Batches) -> ContactBlocks:
    """Blocks and lanes of contacts, and what they are coloured with."""
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


def batch_memory(bodies: int, pairs: int, workers: int) -> Batches:
    """Batches of islands, with memory for the blocks of further workers if there can be several."""
    batches = most_batches(pairs)
    blocks = (workers - 1) * BLOCKS if batches > 1 else 0
    return Batches(
        size=np.full(1, SIZE),
        bodies=np.zeros(bodies, np.int64),
        struck=STRUCK_BODY.zeros(bodies),
        first_body=np.zeros(batches + 1, np.int64),
        impacts=IMPACT.zeros(pairs),
        impact_slots=IMPACT_SLOT.zeros(pairs),
        first_impact=np.zeros(batches + 1, np.int64),
        blocks=BLOCK.zeros(blocks),
        lanes=aligned_zeros(blocks * BLOCK_SIZE, np.float64),
        starts=np.zeros(blocks + 2 * workers, np.int64),
    )


def ccd_memory(room: Room) -> Ccd:
    """Sweeps and times of impact."""
    impacts = CCD_IMPACT.zeros(room.bodies)
    impacts.time = 1.0
    impacts.stopped = -1
    hit = np.zeros(room.bodies + 1, np.int64)
    return Ccd(impacts, hit, GRID_BOX.zeros(room.shapes), SWEEP.zeros(1), VERTEX.zeros(POSED_ROWS), MANIFOLD.zeros(2))


def measure_thin(bodies: Records, state: State, first: int, first_shape: int) -> None:
    """Measure the thinnest shapes of the bodies from row `first` on, whose shapes begin at `first_shape`."""
    shapes = plain(state.shapes)[first_shape:]
    thin = np.full(len(state.bodies) - first, np.inf)
    if len(thin) == 1:  # `minimum.at` takes longer than all else here
        thin[0] = shapes["thin"].min(initial=np.inf)
    else:
        np.minimum.at(thin, shapes["body"] - first, shapes["thin"])
    thin[thin == np.inf] = 0.0
    plain(bodies)["thin"][first : len(state.bodies)] = thin
