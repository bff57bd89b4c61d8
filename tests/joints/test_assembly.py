"""The tables of the joint solver, put together part by part, against those of all joints at once."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import Delete, Spawn
from sandbox._vectors import WIDTH
from sandbox.engine.joints import part_layout
from sandbox.engine.joints.assembly import assemble
from sandbox.engine.joints.components import components
from sandbox.engine.joints.direct import places as at
from sandbox.engine.joints.direct.records import OF_BODY, OF_JACOBIAN, OF_MASS
from sandbox.engine.joints.part_layout import PartLayouts
from sandbox.world.build import build_state
from sandbox.world.joint_records import GEAR, JOINT, KINDS
from sandbox.world.records import BODY
from tests.flat import world
from tests.naive import assembly as naive
from tests.shipped import FILES, shipped

JOINTED = [name for name in sorted(FILES) if shipped(name).flatten().joints]


def same(joints: Any, bodies: Any, layouts: PartLayouts) -> None:
    """Both ways give the same tables, and what parts share says the same of every part."""
    (bonds, first), work = assemble(joints, bodies, layouts, len(bodies))
    expected = naive.assemble(joints, bodies)
    assert (bonds.tobytes(), first.tobytes()) == (expected[0].bonds.tobytes(), expected[0].first.tobytes())
    assert (work is None) == (expected[1] is None)
    if work is None:
        return
    judge = expected[1]
    for name in ("ties", "part_of", "members", "constraints", "rows"):
        assert getattr(work, name).tobytes() == getattr(judge, name).tobytes(), name
    for name in work.side_by_side._fields:
        assert getattr(work.side_by_side, name).tobytes() == getattr(judge.side_by_side, name).tobytes(), name
    for name in (name for name in work.parts.dtype.names if name != "layout"):
        assert work.parts[name].tolist() == judge.parts[name].tolist(), name
    assert {p: decoded(work, p) for p in np.flatnonzero(work.parts.direct).tolist()} == judge.factors
    check_frames(work)


def slices(table: Any, first: int, end: int) -> Any:
    return np.asarray(table)[first:end].view(np.recarray)


def decoded(work: Any, p: int) -> naive.Factor:
    """What the shared tables say of part `p`, in numbers of the world."""
    d, part = work.direct, work.parts[p]
    layout = d.layouts[part.layout]
    frames = slices(d.layout_frames, layout.first_frame, layout.frame_end)
    equations = slices(d.equations, layout.first_row, layout.row_end)
    bodies = [*work.members.body[part.first_member : part.member_end].tolist()]
    bodies += d.fixed[part.first_fixed : part.first_fixed + layout.seats - layout.moving].tolist()
    assert len(bodies) == layout.seats
    assert layout.moving == part.member_end - part.first_member
    joint_of = work.constraints.joint[part.first_constraint : part.constraint_end].tolist()
    owner = {r - layout.first_row: joint_of[f.joint] for f in frames for r in range(f.first_row, f.row_end)}
    assert [r for r in range(len(equations)) if r not in owner] == np.flatnonzero(
        equations.augmented == OF_BODY
    ).tolist()
    rows = [
        naive.Row(
            owner.get(r, -1),
            int(row.slot),
            tuple(bodies[row[f"seat_{k + 1}"] // at.SEAT_SIZE] for k in range(row.sides)),
        )
        for r, row in enumerate(equations)
    ]
    number = {int(row.place): r for r, row in enumerate(equations)}
    entries = [slices(d.entries, row.first_entry, row.entry_end) for row in equations]
    first = int(entries[0].place[0]) if rows else 0
    columns = [[number[int(e.other)] for e in each] for each in entries]
    products = [
        [product(number, x, bodies) for x in slices(d.products, e.first_product, e.product_end)]
        for each in entries
        for e in each
    ]
    below = [len(column) - 1 for column in columns]
    ends = [int(row.first_target) + n * (n + 1) // 2 for row, n in zip(equations, below, strict=True) if n >= 0]
    targets = d.targets[equations.first_target[0] : max(ends)] if rows else np.zeros(0, np.int64)
    return naive.Factor(rows, columns, products, ((targets - first) // WIDTH).tolist(), bool(layout.bounded))


def product(number: dict[int, int], x: Any, bodies: list[int]) -> naive.Product:
    row, side = divmod(int(x.one) - min(number), at.ROW_SIZE)
    if x.linear >= OF_JACOBIAN:
        axis = (side - at.JACOBIAN) % at.SIDE // WIDTH if x.linear == OF_JACOBIAN else 2 * (x.linear - OF_MASS)
        other = -1 if x.linear == OF_JACOBIAN else -2
        return naive.Product(row, side // at.SIDE, other, int(axis), bodies[x.seat // at.SEAT_SIZE])
    other, other_side = divmod(int(x.other) - min(number), at.ROW_SIZE)
    return naive.Product(row, side // at.SIDE, other, other_side // at.SIDE, bodies[x.seat // at.SEAT_SIZE])


def check_frames(work: Any) -> None:
    """Every frame is that of its joint; after a gear come those of the joints it couples; places are apart."""
    d = work.direct
    for part in (part for part in work.parts if part.direct):
        layout = d.layouts[part.layout]
        frames = slices(d.layout_frames, layout.first_frame, layout.frame_end)
        joints = work.joints[work.constraints.joint[part.first_constraint : part.constraint_end]]
        assert frames.joint[frames.coupled == 0].tolist() == list(range(len(joints)))
        assert layout.joints == len(joints)
        for k, frame in enumerate(frames):
            joint = joints[frame.joint]
            if frame.coupled:
                joint = work.joints[joint.joint_1 if frame.coupled == 1 else joint.joint_2]
            elif joint.kind == GEAR:
                assert frames.coupled[k + 1 : k + 3].tolist() == [1, 2]
                assert [frame.coordinate_1, frame.coordinate_2] == frames.place[k + 1 : k + 3].tolist()
                assert [frame.kind_1, frame.kind_2] == frames.kind[k + 1 : k + 3].tolist()
            assert frame.kind == joint.kind
            if not frame.coupled:
                assert (frame.limit, frame.motor) == (joint.limit != 0, joint.motor != 0)
        assert np.diff(frames.place).tolist() == [at.FRAME_SIZE] * (len(frames) - 1)


@st.composite
def tables(draw: st.DrawFn, star: bool = False) -> tuple[Any, Any]:
    """Any joints between some bodies, a few of which do not move; gears among them. In a `star` most hold the first."""
    bodies = BODY.zeros(draw(st.integers(20, 30) if star else st.integers(2, 9)))
    bodies.mass = draw(st.lists(st.sampled_from((0.0, 1.0, 1.0, 1.0)), min_size=len(bodies), max_size=len(bodies)))
    bodies.frozen_step = draw(st.lists(st.sampled_from((-1, -1, -1, 5)), min_size=len(bodies), max_size=len(bodies)))
    joints = JOINT.zeros(draw(st.integers(20, 40) if star else st.integers(0, 14)))
    side = st.integers(-1, len(bodies) - 1)
    first = st.sampled_from((0, 0, 0, 3)) if star else side
    flags = st.sampled_from((0, 0, 0, 1))
    for row in joints:
        row.kind = draw(st.integers(0, len(KINDS) - 1).filter(lambda kind: kind != GEAR))
        row.body_a, row.body_b = draw(st.tuples(first, side).filter(lambda pair: pair[0] != pair[1]))
        row.spring, row.limit, row.motor, row.collide = (draw(flags) for _ in range(4))
        row.enabled, row.broken_step = 1 - draw(flags), -draw(st.sampled_from((1, 1, 1, 0)))
        row.joint_1 = row.joint_2 = -1
    plain = st.integers(0, max(len(joints) // 2 - 1, 0))
    for row in joints[len(joints) // 2 :] if len(joints) > 1 else ():
        if draw(flags):
            row.kind, row.body_a, row.body_b = GEAR, -1, -1
            row.joint_1, row.joint_2 = draw(plain), draw(plain)
    return joints, bodies


@given(st.lists(tables(), max_size=3))
def test_random_joints(drawn):
    layouts = PartLayouts()
    for joints, bodies in drawn:
        same(joints, bodies, layouts)


@given(tables(star=True))
def test_random_stars(drawn):
    """Many of which have bodies that stay in the system."""
    joints, bodies = drawn
    same(joints, bodies, PartLayouts())


@pytest.mark.parametrize("name", JOINTED)
def test_shipped_scenes(name):
    built = build_state(shipped(name).flatten())
    same(built.joints, built.bodies, PartLayouts())


def rope(name: str, x: float, links: int) -> tuple[list[Any], list[Any]]:
    """A hanging rope."""
    bodies = [{"id": f"{name}{k}", "position": [x, -k], "shapes": [{"box": [0.2, 0.8]}]} for k in range(links)]
    ties = [
        {"id": f"{name}j{k}", "type": "revolute", "bodies": [f"{name}{k - 1}" if k else None, f"{name}{k}"],
         "anchor": [x, 0.5 - k]}
        for k in range(links)
    ]  # fmt: skip
    return bodies, ties


def test_only_parts_of_a_new_kind_are_laid_out(monkeypatch):
    asked = []
    layout = part_layout.part_layout
    monkeypatch.setattr(part_layout, "part_layout", lambda key: asked.append(key) or layout(key))
    w = world()
    w.apply(Spawn(*rope("a", 0.0, 5)))
    w.apply(Spawn(*rope("b", 3.0, 5)))
    assert len(asked) == 1
    w.apply(Spawn(*rope("c", 6.0, 7)))
    assert len(asked) == 2
    w.apply(Delete("b4"))
    assert w.scratch.joints is not None  # has it done
    assert len(asked) == 3
    layouts = w._stepper._joints.layouts
    assert len(layouts.known) == 3
    w.apply(Delete(tuple(f"c{k}" for k in range(7))))
    assert "c0" not in w.names
    assert len(layouts.known) == 2
    same(w.state.joints, w.state.bodies, layouts)


@given(st.integers(1, 30), st.lists(st.tuples(st.integers(0, 29), st.integers(0, 29)), max_size=40))
def test_components(count, edges):
    edges = [(a % count, b % count) for a, b in edges]
    found = components(count, *(np.array(column, np.int64) for column in (list(zip(*edges, strict=True)) or ([], []))))
    labels = list(range(count))
    for _ in range(count):
        for a, b in edges:
            labels[a] = labels[b] = min(labels[a], labels[b])
    assert found.tolist() == labels


@pytest.mark.parametrize("count", [2, 3000])
def test_components_of_a_long_line_whose_numbers_jump(count):
    order = np.random.default_rng(1).permutation(count)
    assert components(count, order[1:], order[:-1]).tolist() == [0] * count
