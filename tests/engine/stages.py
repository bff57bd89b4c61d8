"""The stages of a step called one by one.

The only place in the tests that knows the signatures of kernels and the layout of scratch memory.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from sandbox._jit import kernel_argument
from sandbox.engine.active import active_set, islands
from sandbox.engine.bodies import integrate
from sandbox.engine.bodies import integrate_positions as positions
from sandbox.engine.broad_phase import grid, pair_cache, pairs, proxies
from sandbox.engine.broad_phase.fat_boxes import SLACK
from sandbox.engine.contact_solver import fill_blocks as filling
from sandbox.engine.contact_solver import (
    graph_coloring,
    mouse_joint,
    nesterov,
    prepare,
    soft_constraint,
    solve,
    store,
    velocity_parts,
)
from sandbox.engine.contact_solver import warm_start as warm_starting
from sandbox.engine.contact_solver.blocks import LANES
from sandbox.engine.joints.part_tables import no_joints
from sandbox.engine.memory.scratch import Scratch
from sandbox.engine.narrow_phase import find_contacts as narrow_phase
from sandbox.engine.narrow_phase import speculative
from sandbox.engine.records.colliders import FILTER, GRID_BOX, GRID_INFO, PAIR
from sandbox.engine.records.contact_blocks import BlockRanges, SoftContact
from sandbox.engine.records.state import StateTables
from sandbox.engine.restitution import impact_list, impacts, worklist
from sandbox.engine.restitution.impact_list import ImpactList
from sandbox.engine.world import World
from sandbox.tables import Integers, Records
from sandbox.world.build import build_state
from sandbox.world.records import BODY, DYNAMIC
from sandbox.world.state import State
from tests.flat import scene
from tests.kernels import called_from_python
from tests.naive.grid import Box

Pair = tuple[int, int]


def stage(kernel: Any) -> Callable[..., Any]:
    """A kernel to call with record arrays; or a function, compiled for that."""
    compiled = called_from_python(kernel)

    def call(*arguments: Any) -> Any:
        return compiled(*(plain(argument) for argument in arguments))

    return call


def plain(argument: Any) -> Any:
    """A whole record array as a plain one over the same memory (with the compiler; Python needs the fields)."""
    if isinstance(argument, np.recarray) and argument.base is None:
        raise TypeError("a copied recarray has no base: use Table.zeros and fill it")
    return kernel_argument(argument)


def begin_bodies(bodies: Any, rows: Any, motions: Any, free_motions: Any) -> None:
    """Load the velocities."""
    for i in rows:
        integrate.begin_motion(bodies[i], motions[i], free_motions[i])


def prepare_forces(bodies: Any, rows: Any, solver: Any, settings: Any, seconds: float) -> None:
    """Takes the table of settings: a row cannot be passed from Python."""
    integrate.prepare_some_forces(bodies, rows, solver, settings[0], seconds)


update_active_set = stage(active_set.update_active_set)
bound_shapes = stage(proxies.bound_shapes)
update_pair_cache = stage(pair_cache.update_pair_cache)
select_pairs = stage(pair_cache.select_pairs)
find_pairs = stage(pairs.find_pairs)
sort_pairs = stage(pairs.sort_pairs)
mark_may_stop = stage(speculative.mark_may_stop)
find_contacts = stage(narrow_phase.find_contacts)
color_contacts = stage(graph_coloring.color_contacts)
sort_contacts = stage(filling.sort_contacts)
fill_blocks = stage(filling.fill_blocks)
prepare_contacts = stage(prepare.prepare_contacts)
contact_spring = called_from_python(soft_constraint.contact_spring)
store_impulses = stage(store.store_impulses)
warm_start = stage(warm_starting.warm_start)
begin_parts = stage(velocity_parts.begin_parts)
turn_parts = stage(velocity_parts.turn_parts)
add_parts = stage(velocity_parts.add_parts)
solve_contacts = stage(solve.solve_contacts)
begin_motions = stage(begin_bodies)
prepare_setting = stage(prepare_forces)
integrate_velocities = stage(integrate.integrate_velocities)
integrate_positions = stage(positions.integrate_positions)
list_bodies = stage(nesterov.list_bodies)
link_contacts = stage(worklist.link_contacts)
resolve_impacts = stage(impacts.resolve_impacts)
list_impact_contacts = stage(impact_list.list_impact_contacts)
solve_mouse_joints = stage(mouse_joint.solve_mouse_joints)
find_islands = stage(islands.find_islands)


class Grid:
    """The broad phase on a list of boxes."""

    def __init__(self, boxes: Sequence[Box], capacity: int = 100_000) -> None:
        self.count = len(boxes)
        self.boxes, self.filters = GRID_BOX.zeros(self.count), FILTER.zeros(self.count)
        self.ordered = GRID_BOX.zeros(self.count)
        self.pairs, self.buffer = PAIR.zeros(capacity), PAIR.zeros(capacity)
        buckets = 128
        while buckets < 2 * self.count:
            buckets *= 2
        self.heads = np.zeros(buckets + 1, np.int64)
        self.levels = np.zeros(grid.LEVEL_SPACE, np.int64)
        for i, box in enumerate(boxes):
            row, filters = self.boxes[i], self.filters[i]
            row.lower_x, row.lower_y = box.lower
            row.upper_x, row.upper_y = box.upper
            row.shape_index = i
            filters.body, filters.moves = box.body, proxies.ACTIVE if box.moves else 0
            filters.category, filters.mask, filters.group = box.category, box.mask, box.group

    def find(self) -> int:
        """Run the grid; the number of pairs it counted."""
        info = GRID_INFO.zeros(1)
        return int(find_pairs(self.boxes, self.filters, self.ordered, self.heads, self.levels, info, self.pairs))

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
        self.tables = StateTables(*(getattr(world.state, name) for name in StateTables._fields))
        self.scratch: Scratch = world.scratch
        self.count = self.colors = self.blocks = 0
        self.setting = world.state.settings[0]
        self.seconds = float(self.setting.step_seconds)
        self.substep = self.seconds / int(self.setting.substeps)

    @property
    def active_bodies(self) -> Integers:
        """Rows of the bodies that the step may move."""
        rows: Integers = self.scratch.active.bodies
        return rows[1 : 1 + int(rows[0])]

    @property
    def motions(self) -> Records:
        """Those of the bodies: the last one in memory is the world's."""
        rows: Records = self.scratch.solver.motions[: len(self.state.bodies)]
        return rows

    @property
    def active_contacts(self) -> Integers:
        """Rows of the contacts with an active body."""
        rows: Integers = self.scratch.contacts.active.contact
        return rows[1 : 1 + int(rows[0])]

    def survey(self) -> None:
        """Who may move."""
        m = self.scratch
        m.active.info.stale = 1
        update_active_set(self.state.bodies, m.active, m.solver)

    def detect(self) -> None:
        """Bounds, grid, contacts."""
        s, m = self.state, self.scratch
        self.survey()
        m.solver.flags[:] = 0  # of the step before
        m.active.shapes[:] = np.arange(len(s.shapes))
        m.active.info.moving = len(s.shapes)
        bound_shapes(self.tables, m.active.shapes, True, m.colliders, m.grid, m.workers)
        g = m.grid
        g.cache.info.valid = 0
        assert update_pair_cache(m.colliders, m.active.shapes, len(s.shapes), self.seconds, SLACK, g) == 0
        count = select_pairs(m.colliders, self.seconds, m.joint_filter, g)
        assert count <= len(g.pairs)
        mark_may_stop(m.colliders, m.active, m.solver.ccd)
        s.counters[0].pair_count = count
        self.count = find_contacts(
            self.tables, m.active, m.colliders, g.pairs, m.contacts, m.solver.ccd, m.workers, m.decisions
        )

    def lay_out(self) -> None:
        """Colours, slots, blocks and lanes."""
        s, m = self.state, self.scratch
        self.colors, _ = color_contacts(s.bodies, m.active, m.solver, m.contacts, 0, False, False, m.blocks)
        sort_contacts(m.contacts, m.solver.batches, m.blocks, 1)
        self.blocks = BlockRanges(*fill_blocks(m.solver.colors, m.blocks, 0)).total
        assert self.blocks <= len(m.blocks.blocks)
        self.prepare()

    def _spring(self) -> soft_constraint.Spring:
        return soft_constraint.Spring(*contact_spring(self.state.settings[0], 0))

    def prepare(self, impacts: bool = False, impact_speed: float = 2.0) -> None:
        """Fill the lanes of the blocks there are."""
        m = self.scratch
        now = m.contacts.now
        criteria = prepare.ImpactCriteria(impacts, self.blocks, impact_speed)
        prepare_contacts(self.tables, m.solver, now, m.blocks, self.blocks, m.workers, self._spring(), criteria)

    def one_contact_a_block(self) -> None:
        """The same slots, but every contact alone in its block."""
        m = self.scratch
        roomy = Scratch.for_state(self.state, LANES * (self.count + 1))
        m.blocks = m.blocks._replace(blocks=roomy.blocks.blocks, lanes=roomy.blocks.lanes)
        for k in range(self.count):
            block = m.blocks.blocks[k]
            block.first, block.count, block.serial = k, 1, 0
        self.blocks = self.count
        self.prepare()

    def begin(self) -> None:
        """Load the velocities and add a substep of gravity."""
        s, m = self.state, self.scratch
        self.survey()
        begin_motions(s.bodies, self.active_bodies, m.solver.motions, m.solver.free_motions)
        prepare_setting(s.bodies, self.active_bodies, m.solver, s.settings, self.substep)
        integrate_velocities(s.bodies, self.active_bodies, m.solver, m.active.info, 0, m.workers)

    def warm(self) -> None:
        """Warm start."""
        warm_start(self.scratch.solver.motions, self.scratch.blocks, self.blocks, self.scratch.workers)

    def begin_parts(self) -> None:
        """Contacts have given nothing yet."""
        begin_parts(self.active_bodies, self.scratch.solver)

    def turn_parts(self) -> None:
        """The other of the two parts of all velocities."""
        turn_parts(self.active_bodies, self.scratch.solver, self.scratch.workers)

    def add_parts(self) -> None:
        """Warm start by bodies."""
        add_parts(self.active_bodies, self.scratch.solver, self.scratch.workers)

    def solve(self, bias: float, softness: float, slowest: float, allowance: float = 0.0, beyond: float = 0.0) -> None:
        """One pass."""
        m = self.scratch
        soft = SoftContact(1.0 / self.substep, bias, softness, softness, slowest, allowance, beyond, 0.0, False, True)
        solve_contacts(m.solver.motions, m.blocks, 0, self.blocks, m.workers, soft)

    def strike(self) -> None:
        """Resolve the impacts of contacts that close at more than 0.2 m/s."""
        m = self.scratch
        rows, slots = m.blocks.batches.impacts, m.blocks.batches.impact_slots
        count = list_impact_contacts(self.state.bodies, m.solver, m.contacts, 0, 1e9, 0.2, slots)
        link_contacts(self.state.bodies, slots, count, m.solver)
        resolve_impacts(self.state.bodies, m.solver, m.contacts.now, ImpactList(rows, slots, count, 0.2), self.substep)

    def moved(self) -> list[int]:
        """The bodies that take part in an inelastic impact of all contacts."""
        m = self.scratch
        rows = m.blocks.batches.struck
        count = list_bodies(m.solver, rows, m.blocks, self.blocks)
        return sorted(int(row.body) for row in rows[:count])

    def move(self) -> None:
        """Integrate positions over a substep."""
        scale = positions.Scale(float(np.hypot(self.setting.gravity_x, self.setting.gravity_y)), 1.0)
        integrate_positions(self.active_bodies, self.scratch.solver, scale, self.substep, False, self.scratch.workers)

    def store(self) -> None:
        """Impulses back into the contacts."""
        m = self.scratch
        store_impulses(self.tables, m.solver, m.contacts, m.blocks, self.blocks, m.workers, self._spring())


def island_roots(count: int, links: Sequence[tuple[int, int]], active: Sequence[bool]) -> list[int]:
    """What `find_islands` finds for bodies that are joined by contacts."""
    bodies, found = BODY.zeros(count), np.zeros(count, np.int64)
    contacts = Scratch.for_state(build_state(scene()), len(links) + 1).contacts
    for row, awake in zip(bodies, active, strict=True):
        row.type, row.awake = DYNAMIC, int(awake)
    contacts.active[0].contact = len(links)
    for k, (a, b) in enumerate(links):
        contacts.active[1 + k] = k, a, b
    find_islands(bodies, np.arange(count), found, contacts, kernel_argument(no_joints()))
    return [int(i) for i in found]
