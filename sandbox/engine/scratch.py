"""Memory that a step needs and forgets: never hashed, never saved, only grown."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.engine.census import new_census
from sandbox.engine.contact_blocks import BLOCK_SIZE, GATHER_SIZE, LANES, MAX_COLORS
from sandbox.engine.fields.work import field_memory
from sandbox.engine.grid import LEVEL_SPACE
from sandbox.engine.joints.layout import lay_out
from sandbox.engine.joints.work import JointWork
from sandbox.engine.keeping import KEEPER, RUN
from sandbox.engine.pace import PILE
from sandbox.geometry.manifold import MANIFOLD
from sandbox.geometry.sweep import SWEEP, SWEPT_ROWS
from sandbox.tables import Field, Floats, Integers, Records, Table, aligned_zeros
from sandbox.world.records import CONTACT, VERTEX
from sandbox.world.state import State

MOTION = Table(
    "motion",
    (
        Field("velocity_x", "m/s", "what the solver works on"),
        Field("velocity_y", "m/s", "what the solver works on"),
        Field("angular_velocity", "rad/s", "what the solver works on"),
        Field("delta_x", "m", "way of the centre since the step began"),
        Field("delta_y", "m", "way of the centre since the step began"),
        Field("delta_cos", "1", "rotation since the step began"),
        Field("delta_sin", "1", "rotation since the step began"),
        Field("delta_angle", "rad", "rotation since the step began"),
    ),
)
"""One row a body, one cache line: all that the solver gathers and scatters."""

FLIGHT = Table(
    "flight",
    (
        Field("start_x", "m/s", "velocity when the substep began"),
        Field("start_y", "m/s", "velocity when the substep began"),
        Field("start_w", "rad/s", "velocity when the substep began"),
        Field("free_x", "m/s", "velocity at its end if nothing touches the body"),
        Field("free_y", "m/s", "velocity at its end if nothing touches the body"),
        Field("free_w", "rad/s", "velocity at its end if nothing touches the body"),
        Field("island", "-", "root of its island", "i8"),
        Field("pace", "-", "its island takes 2**pace times the substeps of the scene", "i8"),
        Field("buoyed", "-", "1 when it floats at rest", "i8"),
        Field("was_awake", "-", "before the step woke anybody", "i8"),
        Field("was_island", "-", "before the step woke anybody", "i8"),
        Field("was_slow", "s", "sleep time before the step woke anybody"),
    ),
)
"""One row a body: where an unhindered body would go, and its place in the constraint graph."""

PULL = Table(
    "pull",
    (
        Field("push_x", "m/s", "what gravity and forces add to the velocity in a substep"),
        Field("push_y", "m/s", "the same"),
        Field("push_w", "rad/s", "what torques add to it"),
        Field("slow", "1", "share of the velocity that damping leaves"),
        Field("brake", "1", "share of the angular velocity that damping leaves"),
        Field("extent", "m", "that of the body"),
        Field("moves", "-", "1 when the solver moves it, 2 when it is driven, 0 for the others", "i8"),
        Field("spare", "-", "fills the cache line", "i8"),
    ),
)
"""One row a body, one cache line: all that the substeps ask of the body itself."""

HOLD = Table(
    "hold",
    (
        Field("thin", "m", "half the smallest width of its thinnest shape"),
        Field("deep", "-", "1 when it overlaps something immovable more than a little", "i8"),
        Field("fresh", "-", "1 when it touches something that it was not even near to a step before", "i8"),
        Field("fast", "-", "1 when its way in the step has to be looked at", "i8"),
        Field("hemmed", "-", "1 when something immovable may stop it during the step", "i8"),
    ),
)
"""One row a body: what `continuous` asks of it. By itself, as most steps hardly look at it."""

STOP = Table(
    "stop",
    (
        Field("time", "1", "when it is stopped, as a share of the step; 1 is not at all"),
        Field("bounces", "-", "1 when what stops it bounces it", "i8"),
        Field("struck", "-", "1 when it has touched what stops it from the start of the step on", "i8"),
        Field("normal_x", "1", "of what stops it, towards the body"),
        Field("normal_y", "1", "of what stops it, towards the body"),
        Field("arm_x", "m", "where it is stopped, from the centre of the body"),
        Field("arm_y", "m", "where it is stopped, from the centre of the body"),
        Field("restitution", "1", "of the body and what stops it"),
        Field("friction", "1", "of the body and what stops it"),
        Field("surface_speed", "m/s", "of the body and what stops it"),
    ),
)
"""One row a body: where `continuous` stops it."""

BOX = Table(
    "box",
    (
        Field("lower_x", "m", "bounds of the shape, its margin and its way during the step"),
        Field("lower_y", "m", ""),
        Field("upper_x", "m", ""),
        Field("upper_y", "m", ""),
        Field("cell_x", "-", "cell of the box's middle, on the grid of its level", "i8"),
        Field("cell_y", "-", "", "i8"),
        Field("level", "-", "cells of its grid are 2**level m wide", "i8"),
        Field("shape_index", "-", "row of the shape", "i8"),
    ),
)
"""One row a shape, one cache line: all that the grid looks at before it finds an overlap."""

OWNER = Table(
    "owner",
    (
        Field("body", "-", "index of the body", "i8"),
        Field("moves", "-", "`ACTIVE`, `SLEEPS`, `DRIVEN` or 0, see `bounds`", "i8"),
        Field("category", "-", "", "i8"),
        Field("mask", "-", "", "i8"),
        Field("group", "-", "", "i8"),
        Field("hemmed", "-", "1 when it may meet something immovable during the step", "i8"),
    ),
)

PROXY = Table(
    "proxy",
    (
        Field("center_x", "m", "centre of mass of its body"),
        Field("center_y", "m", "centre of mass of its body"),
        Field("velocity_x", "m/s", "of its body"),
        Field("velocity_y", "m/s", "of its body"),
        Field("speed", "m/s", "of its body"),
        Field("swing", "m/s", "fastest that its core can turn"),
        Field("margin", "m", "half of what its pairs look ahead at low speed"),
        Field("traits", "-", "bits of the shape and of how it moves, see `bounds`", "i8"),
        Field("vertex_start", "-", "", "i8"),
        Field("vertex_count", "-", "", "i8"),
        Field("radius", "m", ""),
        Field("body", "-", "index of the body", "i8"),
        Field("friction", "1", ""),
        Field("restitution", "1", ""),
        Field("rolling_resistance", "m", ""),
        Field("surface_speed", "m/s", ""),
    ),
)
"""One row a shape, two cache lines: all that the narrow phase asks of the shapes of a slow pair and their bodies."""

PAIR = Table("pair", (Field("shape_a", "-", "", "i8"), Field("shape_b", "-", "", "i8")))

SLOT = Table(
    "slot",
    (
        Field("contact", "-", "row in the contact table", "i8"),
        Field("body_a", "-", "", "i8"),
        Field("body_b", "-", "", "i8"),
    ),
)
"""Contacts in the order they are solved in: colour by colour."""

BLOCK = Table(
    "block",
    (
        Field("first", "-", "its first slot", "i8"),
        Field("count", "-", "lanes in use, 1..64", "i8"),
        Field(
            "stride",
            "-",
            "lanes from contact to contact; more than 1 when they share bodies and go one by one",
            "i8",
        ),
        Field("rolling", "-", "1 when some contact has rolling resistance", "i8"),
    ),
)


REPORT = Table(
    "report",
    (
        Field("total_impulse", "N s", "normal impulse over the whole step, impacts included, both points"),
        Field("hit_speed", "m/s", "at which points that did not push before closed in during the step; 0 if none"),
    ),
)
"""What a contact did during the step; same row as the contact."""


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
