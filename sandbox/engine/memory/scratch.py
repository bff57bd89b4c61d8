"""Memory that a step needs and forgets: never hashed, never saved, only grown."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.engine.active.active_set import new_census
from sandbox.engine.active.substep_level import PILE
from sandbox.engine.broad_phase.grid import LEVEL_SPACE
from sandbox.engine.contact_solver.blocks import BLOCK_SIZE, GATHER_SIZE, LANES, MAX_COLORS
from sandbox.engine.fields.records import field_memory
from sandbox.engine.joints.assembly import lay_out
from sandbox.engine.joints.records import JointWork
from sandbox.engine.memory.records import (
    BLOCK,
    BOX,
    FLIGHT,
    HOLD,
    MOTION,
    OWNER,
    PAIR,
    PROXY,
    PULL,
    REPORT,
    SLOT,
    STOP,
)
from sandbox.engine.narrow_phase.sleeping_contacts import KEEPER, RUN
from sandbox.geometry.manifold import MANIFOLD
from sandbox.geometry.sweep import SWEEP, SWEPT_ROWS
from sandbox.tables import Floats, Integers, Records, aligned_zeros
from sandbox.world.records import CONTACT, VERTEX
from sandbox.world.state import State


@dataclass
class Scratch:
    """The arrays of one world's step. `pairs` decides the capacity of everything that grows with contacts."""

    census: Records
    movers: Integers
    stirs: Integers
    parts: Integers
    motions: Records
    flights: Records
    pulls: Records
    marks: Integers
    palettes: Integers
    piles: Records
    holds: Records
    stops: Records
    turned: Records
    boxes: Records
    owners: Records
    proxies: Records
    spare_boxes: Records
    sorted_boxes: Records
    heads: Integers
    levels: Integers
    rest_heads: Integers
    rest_levels: Integers
    pairs: Records
    sorted_pairs: Records
    contacts: Records
    live: Integers
    strikers: Integers
    keeper: Records
    runs: Records
    reports: Records
    manifold: Records
    sweep: Records
    swept: Records
    slots: Records
    blocks: Records
    colors: Integers
    lanes: Floats
    gathered: Floats
    bonds: Records
    joined: Integers
    joints: JointWork | None
    pushes: Records
    pieces: Records
    spare_pieces: Records

    @classmethod
    def for_state(cls, state: State, pair_capacity: int, block_capacity: int = 0) -> Scratch:
        """Scratch for all bodies and shapes of `state`, for so many candidate pairs and so many solver blocks."""
        shapes = len(state.shapes)
        block_capacity = max(block_capacity, pair_capacity // LANES + MAX_COLORS + 2)
        return cls(
            census=new_census(),
            movers=np.zeros(len(state.bodies) + 1, np.int64),
            stirs=np.zeros(len(state.bodies), np.int64),
            parts=np.arange(shapes),
            motions=MOTION.zeros(len(state.bodies)),
            flights=FLIGHT.zeros(len(state.bodies)),
            pulls=PULL.zeros(len(state.bodies)),
            marks=np.zeros(len(state.bodies), np.int64),
            palettes=np.zeros(len(state.bodies), np.int64),
            piles=PILE.zeros(len(state.bodies)),
            holds=_holds(state),
            stops=_stops(state),
            turned=VERTEX.zeros(len(state.vertices)),
            boxes=BOX.zeros(shapes),
            owners=OWNER.zeros(shapes),
            proxies=PROXY.zeros(shapes),
            spare_boxes=BOX.zeros(shapes),
            sorted_boxes=BOX.zeros(shapes),
            heads=np.zeros(head_count(shapes), np.int64),
            levels=np.zeros(LEVEL_SPACE, np.int64),
            rest_heads=np.zeros(head_count(shapes), np.int64),
            rest_levels=np.zeros(LEVEL_SPACE, np.int64),
            pairs=PAIR.zeros(pair_capacity),
            sorted_pairs=PAIR.zeros(pair_capacity + 1),  # `catch` keeps one pair apart
            contacts=CONTACT.zeros(pair_capacity),
            live=np.zeros(pair_capacity + 1, np.int64),
            strikers=np.zeros(pair_capacity + 1, np.int64),
            keeper=KEEPER.zeros(1),
            runs=RUN.zeros(3 * (pair_capacity + 1)),
            reports=REPORT.zeros(pair_capacity),
            manifold=MANIFOLD.zeros(2),
            sweep=SWEEP.zeros(1),
            swept=VERTEX.zeros(SWEPT_ROWS),
            slots=SLOT.zeros(pair_capacity),
            blocks=BLOCK.zeros(block_capacity),
            colors=np.zeros(pair_capacity, np.int64),
            lanes=aligned_zeros(block_capacity * BLOCK_SIZE, np.float64),
            gathered=aligned_zeros(GATHER_SIZE, np.float64),
            **vars(lay_out(state.joints, state.bodies)),
            **field_memory(state),
        )


def _holds(state: State) -> Records:
    holds = HOLD.zeros(len(state.bodies))
    thin = np.full(len(holds), np.inf)
    np.minimum.at(thin, state.shapes.body, state.shapes.thin)
    holds.thin = np.where(thin < np.inf, thin, 0.0)
    for rows in (state.joints.body_a, state.joints.body_b):
        holds.linked[rows[rows >= 0]] = 1
    return holds


def _stops(state: State) -> Records:
    stops = STOP.zeros(len(state.bodies))
    stops.time = 1.0
    return stops


def head_count(shapes: int) -> int:
    """Buckets of the grid: a power of two, about two a shape, and one more to close the last."""
    buckets = 128
    while buckets < 2 * shapes:
        buckets *= 2
    return buckets + 1
