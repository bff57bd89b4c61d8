"""The stages of a step called one by one, each compiled for calls from Python and kept on disk.

The only place in the tests that knows the signatures of kernels and the layout of scratch memory.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from sandbox._jit import entry_point, kernel_argument
from sandbox.engine.active import active_set as census
from sandbox.engine.active import islands
from sandbox.engine.bodies import integrate
from sandbox.engine.broad_phase import grid
from sandbox.engine.broad_phase import pairs as broad_phase
from sandbox.engine.broad_phase import proxies as bounds
from sandbox.engine.contact_solver import graph_coloring as coloring
from sandbox.engine.contact_solver import prepare as contact_prepare
from sandbox.engine.contact_solver import solve as contact_solver
from sandbox.engine.joints import mouse_joint as drags
from sandbox.engine.memory.records import BOX, FLIGHT, OWNER, PAIR
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.narrow_phase import find_contacts as narrow_phase
from sandbox.engine.narrow_phase import speculative as look_ahead
from sandbox.engine.restitution import impacts
from sandbox.engine.world import World
from sandbox.tables import Integers
from sandbox.world.records import BODY, CONTACT, DYNAMIC
from sandbox.world.state import State
from tests.naive.grid import Box

Pair = tuple[int, int]


def stage(kernel: Any) -> Callable[..., Any]:
    """A kernel to call with record arrays."""
    compiled = entry_point(getattr(kernel, "py_func", kernel))

    def call(*arguments: Any) -> Any:
        return compiled(*(plain(argument) for argument in arguments))

    return call


def plain(argument: Any) -> Any:
    """A whole record array as a plain one over the same memory (with the compiler; Python needs the fields)."""
    if isinstance(argument, np.recarray) and argument.base is None:
        raise TypeError("a copied recarray has no base: use Table.zeros and fill it")
    return kernel_argument(argument)


take_census = stage(census.take_census)
bound_shapes = stage(bounds.bound_shapes)
find_pairs = stage(broad_phase.find_pairs)
sort_pairs = stage(broad_phase.sort_pairs)
mark_hemmed = stage(look_ahead.mark_hemmed)
find_contacts = stage(narrow_phase.find_contacts)
color_contacts = stage(coloring.color_contacts)
fill_blocks = stage(coloring.fill_blocks)
prepare_contacts = stage(contact_prepare.prepare_contacts)
store_impulses = stage(contact_prepare.store_impulses)
warm_start = stage(contact_solver.warm_start)
solve_contacts = stage(contact_solver.solve_contacts)
begin_motions = stage(integrate.begin_motions)
begin_pulls = stage(integrate.begin_pulls)
integrate_velocities = stage(integrate.integrate_velocities)
integrate_positions = stage(integrate.integrate_positions)
resolve_impacts = stage(impacts.resolve_impacts)
list_bouncy = stage(impacts.list_bouncy)
solve_drags = stage(drags.solve_drags)
find_islands = stage(islands.find_islands)


class Grid:
    """The broad phase on a list of boxes."""

    def __init__(self, boxes: Sequence[Box], capacity: int = 100_000) -> None:
        self.count = len(boxes)
        self.boxes, self.owners = BOX.zeros(self.count), OWNER.zeros(self.count)
        self.ordered = BOX.zeros(self.count)
        self.pairs, self.buffer = PAIR.zeros(capacity), PAIR.zeros(capacity)
        buckets = 128
        while buckets < 2 * self.count:
            buckets *= 2
        self.heads = np.zeros(buckets + 1, np.int64)
        self.levels = np.zeros(grid.LEVEL_SPACE, np.int64)
        for i, box in enumerate(boxes):
            row, owner = self.boxes[i], self.owners[i]
            row.lower_x, row.lower_y = box.lower
            row.upper_x, row.upper_y = box.upper
            row.shape_index = i
            owner.body, owner.moves = box.body, bounds.ACTIVE if box.moves else 0
            owner.category, owner.mask, owner.group = box.category, box.mask, box.group

    def find(self) -> int:
        """Run the grid; the number of pairs it counted."""
        return int(find_pairs(self.boxes, self.owners, self.ordered, self.heads, self.levels, self.pairs))

    def found(self, count: int) -> list[Pair]:
        """The pairs written, in the order of the grid."""
        rows = self.pairs[:count]
        return list(zip(rows.shape_a.tolist(), rows.shape_b.tolist(), strict=True))

    def sorted_pairs(self) -> list[Pair]:
        """Find and sort: what the narrow phase gets."""
        count = self.find()
        sort_pairs(self.pairs, count, self.buffer, self.heads, self.count)
        return self.found(count)


class Paused:
    """The state and scratch memory of a world, to run the stages of its next step by hand."""

    def __init__(self, world: World) -> None:
        self.state: State = world.state
        self.scratch: Scratch = world.scratch
        self.count = self.colors = self.blocks = self.bouncy = 0
        self.setting = world.state.settings[0]
        self.seconds = float(self.setting.step_seconds)
        self.substep = self.seconds / int(self.setting.substeps)

    @property
    def movers(self) -> Integers:
        """Rows of the bodies that the step may move."""
        rows: Integers = self.scratch.movers
        return rows[1 : 1 + int(rows[0])]

    @property
    def live(self) -> Integers:
        """Rows of the contacts with an active body."""
        rows: Integers = self.scratch.live
        return rows[1 : 1 + int(rows[0])]

    def survey(self) -> None:
        """Who may move."""
        s, m = self.state, self.scratch
        m.census.stale = 1
        take_census(s.bodies, m.census, m.movers, m.stirs, m.motions, m.flights, m.pulls, m.marks, m.palettes, m.holds)

    def detect(self) -> None:
        """Bounds, grid, contacts."""
        s, m = self.state, self.scratch
        self.survey()
        rows = np.arange(len(s.shapes))
        bound_shapes(s.bodies, s.shapes, s.vertices, rows, self.seconds, m.turned, m.boxes, m.owners, m.proxies)
        count = find_pairs(m.boxes, m.owners, m.sorted_boxes, m.heads, m.levels, m.pairs)
        assert count <= len(m.pairs)
        sort_pairs(m.pairs, count, m.sorted_pairs, m.heads, len(s.shapes))
        mark_hemmed(m.owners, self.movers, rows, m.holds, m.proxies)
        gravity = float(np.hypot(self.setting.gravity_x, self.setting.gravity_y))
        self.count = find_contacts(
            s.bodies, self.movers, m.stirs, m.holds, s.shapes, m.proxies, m.turned, s.seams, m.pairs, count,
            0.5 * gravity * self.seconds**2,
            self.seconds, m.manifold, s.contacts, int(s.counters[0].contact_count), m.contacts, m.live,
            m.strikers, m.keeper[0], m.runs,
        )  # fmt: skip

    def lay_out(self) -> None:
        """Colours, slots, blocks and lanes."""
        s, m = self.state, self.scratch
        self.colors = color_contacts(
            s.bodies, self.movers, m.flights, m.palettes, m.contacts, self.live, 0, False, m.colors
        )
        self.blocks = fill_blocks(m.contacts, self.live, m.colors, self.colors, m.heads, m.slots, m.blocks)
        assert self.blocks <= len(m.blocks)
        self.prepare()

    def prepare(self, bouncy: bool = False) -> None:
        """Fill the lanes of the blocks there are."""
        s, m = self.state, self.scratch
        prepare_contacts(s.bodies, m.contacts, m.slots, m.blocks, self.blocks, bouncy, m.lanes)

    def one_contact_a_block(self) -> None:
        """The same slots, but every contact alone in its block."""
        m = self.scratch
        roomy = Scratch.for_state(self.state, len(m.pairs), self.count + 1)
        m.blocks, m.lanes = roomy.blocks, roomy.lanes
        for k in range(self.count):
            m.blocks[k].first, m.blocks[k].count, m.blocks[k].stride = k, 1, 1
        self.blocks = self.count
        self.prepare()

    def begin(self) -> None:
        """Load the velocities and add a substep of gravity."""
        s, m = self.state, self.scratch
        self.survey()
        begin_motions(s.bodies, self.movers, m.motions, m.flights)
        begin_pulls(
            s.bodies, self.movers, m.flights, m.pulls, 0, self.setting.gravity_x, self.setting.gravity_y, self.substep
        )
        integrate_velocities(self.movers, m.motions, m.flights, m.pulls)

    def warm(self) -> None:
        """Warm start."""
        m = self.scratch
        warm_start(m.motions, m.slots, m.blocks, self.blocks, m.lanes, m.gathered)

    def solve(self, bias: float, mass: float, impulse: float, slowest: float, allowance: float = 0.0) -> None:
        """One pass."""
        m = self.scratch
        solve_contacts(
            m.motions, m.slots, m.blocks, self.blocks, m.lanes, m.gathered, 1.0 / self.substep, bias, mass, impulse,
            slowest, allowance,
        )  # fmt: skip

    def move(self) -> None:
        """Integrate positions over a substep."""
        m = self.scratch
        gravity = float(np.hypot(self.setting.gravity_x, self.setting.gravity_y))
        integrate_positions(self.movers, m.motions, m.flights, m.pulls, gravity, self.substep)

    def store(self) -> None:
        """Impulses back into the contacts."""
        m = self.scratch
        store_impulses(self.state.bodies, m.marks, m.contacts, m.slots, m.blocks, self.blocks, m.lanes, m.reports)


def island_roots(count: int, links: Sequence[tuple[int, int]], active: Sequence[bool]) -> list[int]:
    """What `find_islands` finds for bodies that are joined by contacts."""
    bodies, flights, contacts = BODY.zeros(count), FLIGHT.zeros(count), CONTACT.zeros(len(links) + 1)
    for row, awake in zip(bodies, active, strict=True):
        row.type, row.awake = DYNAMIC, int(awake)
    for row, (a, b) in zip(contacts, links, strict=False):
        row.body_a, row.body_b = a, b
    find_islands(bodies, np.arange(count), flights, contacts, np.arange(len(links)), None)
    return [int(i) for i in flights.island]
