"""The step: every stage of the engine, in order. Window, replay, benchmark and test all come through here.

It has two halves, so that an empty kernel cache can be filled by two processes at once (`warm_up.py`).
"""

from __future__ import annotations

import math

from sandbox._jit import entry_point
from sandbox.engine.active.active_set import list_live, take_census
from sandbox.engine.active.body_flags import clear_marks
from sandbox.engine.active.islands import fall_asleep, undo_waking, wake_touched
from sandbox.engine.active.quarantine import guard_positions
from sandbox.engine.active.substep_level import MOST, assign_paces
from sandbox.engine.bodies.integrate import (
    begin_motions,
    finish_motions,
    rewind_driven,
)
from sandbox.engine.broad_phase.pairs import sort_pairs
from sandbox.engine.broad_phase.proxies import bound_shapes
from sandbox.engine.broad_phase.resting_grid import find_all_pairs, part_shapes
from sandbox.engine.contact_solver.graph_coloring import color_contacts, fill_blocks
from sandbox.engine.contact_solver.prepare import clear_reports, prepare_contacts, store_impulses
from sandbox.engine.continuous_collision.candidates import expect_fast, mark_fast
from sandbox.engine.joints.pair_filter import drop_joined_pairs
from sandbox.engine.joints.reactions import finish_joints
from sandbox.engine.joints.records import JointWork
from sandbox.engine.joints.solve import begin_joints
from sandbox.engine.narrow_phase.find_contacts import find_contacts
from sandbox.engine.narrow_phase.sleeping_contacts import begin_keeping, end_keeping
from sandbox.engine.narrow_phase.speculative import mark_hemmed
from sandbox.engine.restitution.impacts import list_bouncy
from sandbox.engine.substeps import RELAX_DEEP, run_substeps, some_fresh
from sandbox.tables import Floats, Integers, Records

MUST_CATCH = -1
"""What `move` returns when bodies may have passed through something."""


@entry_point
def find_touching(
    bodies: Records,
    shapes: Records,
    vertices: Records,
    seams: Records,
    old_contacts: Records,
    settings: Records,
    counters: Records,
    census: Records,
    movers: Integers,
    stirs: Integers,
    parts: Integers,
    motions: Records,
    flights: Records,
    pulls: Records,
    marks: Integers,
    palettes: Integers,
    holds: Records,
    turned: Records,
    boxes: Records,
    owners: Records,
    proxies: Records,
    spare_boxes: Records,
    sorted_boxes: Records,
    heads: Integers,
    levels: Integers,
    rest_heads: Integers,
    rest_levels: Integers,
    pairs: Records,
    sorted_pairs: Records,
    contacts: Records,
    live: Integers,
    strikers: Integers,
    keeper: Records,
    runs: Records,
    manifold: Records,
    bonds: Records,
    joined: Integers,
) -> int:
    """The first half: grid and SAT at the poses of now. `contacts` and `counters.found_count` have the answer.

    Returns 0, or the number of pairs that scratch memory must have room for before this is called again.
    """
    setting = settings[0]
    counter = counters[0]
    seconds = setting.step_seconds
    take_census(bodies, census, movers, stirs, motions, flights, pulls, marks, palettes, holds)
    anew = part_shapes(shapes, census[0], stirs, parts)
    moving = parts[: census[0].moving]
    known = parts[: census[0].moving if census[0].parted == 1 and not anew else parts.shape[0]]
    bound_shapes(bodies, shapes, vertices, known, seconds, turned, boxes, owners, proxies)
    pair_count = find_all_pairs(
        boxes, owners, parts, census[0], anew, spare_boxes, sorted_boxes, heads, levels, rest_heads, rest_levels, pairs
    )
    kept = counter.contact_count if counter.asleep_count > 0 else 0
    if pair_count + kept > pairs.shape[0]:
        return pair_count + kept
    sort_pairs(pairs, pair_count, sorted_pairs, heads, shapes.shape[0])
    if bonds.shape[0] > 0:
        pair_count = drop_joined_pairs(bonds, joined, shapes, pairs, pair_count)
    mark_hemmed(owners, movers[1 : 1 + movers[0]], moving, holds, proxies)
    gravity = math.sqrt(setting.gravity_x * setting.gravity_x + setting.gravity_y * setting.gravity_y)
    counter.pair_count = pair_count
    begin_keeping(keeper[0], census[0].era)
    counter.found_count = find_contacts(
        bodies,
        movers[1 : 1 + movers[0]],
        stirs,
        holds,
        shapes,
        proxies,
        turned,
        seams,
        pairs,
        pair_count,
        0.5 * gravity * seconds * seconds,
        seconds,
        manifold,
        old_contacts,
        counter.contact_count,
        contacts,
        live,
        strikers,
        keeper[0],
        runs,
    )
    end_keeping(keeper[0], runs, census[0].era)
    return 0


@entry_point
def move(
    bodies: Records,
    drags: Records,
    settings: Records,
    counters: Records,
    census: Records,
    movers: Integers,
    stirs: Integers,
    motions: Records,
    flights: Records,
    pulls: Records,
    marks: Integers,
    palettes: Integers,
    piles: Records,
    holds: Records,
    heads: Integers,
    contacts: Records,
    live: Integers,
    strikers: Integers,
    slots: Records,
    blocks: Records,
    colors: Integers,
    lanes: Floats,
    gathered: Floats,
    joints: JointWork | None,
    reports: Records,
) -> int:
    """The second half: solve the contacts found and move everything.

    Returns 0, or the number of blocks that scratch memory must have room for; then nothing has changed, and the
    step begins again with `find_touching`. `MUST_CATCH` if the step ends with `continuous.catch`.
    """
    setting = settings[0]
    counter = counters[0]
    count = counter.found_count
    if wake_touched(bodies, flights, contacts, live[1 : 1 + live[0]], joints, census, counters):
        take_census(bodies, census, movers, stirs, motions, flights, pulls, marks, palettes, holds)
        list_live(bodies, contacts, count, live, strikers)
    active = movers[1 : 1 + movers[0]]
    touched = live[1 : 1 + live[0]]
    paces = assign_paces(
        bodies, active, flights, piles, contacts, touched, joints, counter, setting.gravity_x, setting.gravity_y,
        setting.contact_hertz,
    )  # fmt: skip
    block_count = 0
    counter.color_count = 0
    for pace in range(MOST, -1, -1):
        if (paces >> pace) & 1:
            color_count = color_contacts(bodies, active, flights, palettes, contacts, touched, pace, paces > 1, colors)
            counter.color_count = color_count if color_count > counter.color_count else counter.color_count
            block_count = fill_blocks(contacts, touched, colors, color_count, heads, slots, blocks)
            if block_count > blocks.shape[0]:
                undo_waking(bodies, flights, census)
                return block_count

    fastest = begin_motions(bodies, active, motions, flights)
    clear_marks(bodies, active, flights, drags, marks)
    expect_fast(bodies, active, holds, setting.step_seconds)
    if joints is not None:
        begin_joints(joints, bodies, contacts, touched)
    clear_reports(reports, count)
    for pace in range(MOST + 1):
        if (paces >> pace) & 1 == 0:
            continue
        if pace > 0:
            rewind_driven(bodies, active, motions)
            color_count = color_contacts(bodies, active, flights, palettes, contacts, touched, pace, paces > 1, colors)
            block_count = fill_blocks(contacts, touched, colors, color_count, heads, slots, blocks)
        bouncy_count = list_bouncy(
            bodies, flights, marks, contacts, touched, strikers, pace, fastest, setting.restitution_threshold, colors
        )
        deep = prepare_contacts(bodies, contacts, slots, blocks, block_count, bouncy_count > 0, lanes)
        run_substeps(
            bodies, active, motions, flights, pulls, drags, setting, census, counters, contacts, colors, bouncy_count,
            slots, blocks, block_count, lanes, gathered, pace, RELAX_DEEP if deep else 1,
            some_fresh(bodies, active, flights, holds, pace), joints,
        )  # fmt: skip
        store_impulses(bodies, marks, contacts, slots, blocks, block_count, lanes, reports)
    if joints is not None:
        finish_joints(joints, setting.step_seconds, counter)
    guard_positions(bodies, active, motions, census, counters)
    finish_motions(bodies, active, motions)

    fall_asleep(
        bodies, active, flights, marks, contacts, touched, joints, setting.step_seconds, setting.sleeping == 1, census,
        counters,
    )  # fmt: skip
    counter.step_count += 1
    counter.old_contact_count = counter.contact_count
    counter.contact_count = count
    return MUST_CATCH if mark_fast(bodies, active, motions, holds) > 0 else 0
