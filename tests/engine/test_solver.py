"""The block solver against a naive one, and blocks of 64 against blocks of one, bit for bit."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import pytest

from sandbox.engine.contact_solver import soft_constraint
from sandbox.engine.contact_solver.blocks import KIND, LANES, MAX_COLORS
from sandbox.engine.contact_solver.passes import OVER_RELAXATION
from sandbox.engine.records.contact_blocks import BlockRanges
from sandbox.engine.world import World
from sandbox.reference.simple.bodies import Body
from sandbox.reference.simple.contacts import Point
from sandbox.reference.simple.solver import Pass
from sandbox.tables import plain
from tests.determinism import busy
from tests.determinism.test_scratch import laden_plank
from tests.engine.stages import Paused, fill_blocks
from tests.flat import body as flat_body
from tests.flat import box, circle, ground
from tests.flat import world as put
from tests.kernels import called_from_python
from tests.naive.point_pairs import Pair, solve, warm_start
from tests.physics.test_momentum import crowd as drifting
from tests.physics.test_stacks import falling_pile

soft_coefficients = called_from_python(soft_constraint.soft_coefficients)


def busy_world(steps: int) -> World:
    """The busy scene after some steps with its commands."""
    world = World(busy.scene())
    busy.digests(world, 0, steps)
    return world


def stepped(world: World, steps: int) -> World:
    """A world some steps on."""
    world.step(steps)
    return world


def half_slippery() -> World:
    """A pile in which every third shape has no friction: most blocks have contacts with friction and without."""
    world = falling_pile(0.6, 2)
    world.state.shapes.friction[3::3] = 0.0
    return stepped(world, 80)


WORLDS = {
    "busy 8": lambda: busy_world(8),
    "busy 16": lambda: busy_world(16),
    "plank": lambda: stepped(World(laden_plank()), 9),
    "pile": lambda: stepped(falling_pile(0.6, 1), 80),
    "slippery pile": lambda: stepped(falling_pile(0.0, 1), 80),
    "half slippery pile": half_slippery,
    "drift": lambda: stepped(drifting(2), 70),
}


@pytest.fixture(params=WORLDS)
def paused(request) -> Paused:
    """A world in the middle of a step: contacts are laid out, gravity has worked for a substep."""
    p = Paused(WORLDS[request.param]())
    p.detect()
    assert p.count > 5
    p.lay_out()
    p.begin()
    return p


def vector(row, x: str, y: str) -> complex:
    """Two fields of a record."""
    return complex(row[x], row[y])


@dataclass(eq=False)
class Waiting(Pair):
    """Points that are apart may close in faster by `allowance` (m/s), in substeps of `seconds`."""

    allowance: float = 0.0
    seconds: float = 1.0

    def gap(self, p: Point) -> float:
        """The gap that leads to the speed it may close at."""
        gap = super().gap(p)
        return gap + self.allowance * self.seconds if gap > 0.0 else gap


def twin(p: Paused, bouncy: bool = False) -> tuple[list[Body], list[Waiting]]:
    """The twin's bodies and its contacts in the order of the slots; `bouncy` ones wait for their impact."""
    bodies = [
        Body(float(b.inverse_mass), float(b.inverse_inertia), vector(m, "velocity_x", "velocity_y"),
             float(m.angular_velocity), moved=vector(m, "delta_x", "delta_y"),
             turned=vector(m, "delta_cos", "delta_sin"))
        for b, m in zip(p.state.bodies, p.motions, strict=True)
    ]  # fmt: skip
    contacts = []
    for slot in slots(p):
        c = p.scratch.contacts.now[slot]
        points = [
            Point(vector(c, f"anchor_ax{k}", f"anchor_ay{k}"), vector(c, f"anchor_bx{k}", f"anchor_by{k}"),
                  float(c[f"separation{k}"] - c[f"rest_length{k}"]), float(c[f"normal_impulse{k}"]),
                  float(c[f"tangent_impulse{k}"]))
            for k in range(1, int(c.point_count) + 1)
        ]  # fmt: skip
        waits = bouncy and (c.restitution > 0.0 or closes_hard(p, c))
        contacts.append(
            Waiting(
                bodies[c.body_a], bodies[c.body_b], vector(c, "normal_x", "normal_y"), points, float(c.friction),
                float(c.restitution), float(c.surface_speed), float(c.rolling_resistance), float(c.rolling_impulse),
                float(c.radius_a), float(c.radius_b), seconds=p.substep if waits else 0.0,
            )
        )  # fmt: skip
    return bodies, contacts


def closes_hard(p: Paused, c) -> bool:
    """Whether two points meet, one of them at more than 2 m/s."""

    def speed(row, k: int, side: str) -> complex:
        arm = vector(c, f"anchor_{side}x{k}", f"anchor_{side}y{k}")
        return vector(row, "velocity_x", "velocity_y") + 1j * float(row.angular_velocity) * arm

    a, b = p.state.bodies[c.body_a], p.state.bodies[c.body_b]
    normal = vector(c, "normal_x", "normal_y")
    closing = [
        ((speed(a, k, "a") - speed(b, k, "b")) * normal.conjugate()).real for k in range(1, int(c.point_count) + 1)
    ]
    return len(closing) == 2 and max(closing) > 2.0


def slots(p: Paused) -> list[int]:
    """Contacts in the order they are solved in."""
    blocks = p.scratch.blocks.blocks[: p.blocks]
    return [int(p.scratch.blocks.slots[b.first + k].contact) for b in blocks for k in range(b.count)]


def assert_same(p: Paused, bodies: list[Body], contacts: list[Waiting]) -> None:
    """Velocities and impulses agree to rounding."""
    motions = p.motions
    assert motions.velocity_x == pytest.approx(np.array([b.velocity.real for b in bodies]), abs=1e-11)
    assert motions.velocity_y == pytest.approx(np.array([b.velocity.imag for b in bodies]), abs=1e-11)
    assert motions.angular_velocity == pytest.approx(np.array([b.angular for b in bodies]), abs=1e-10)
    p.store()
    for slot, contact in zip(slots(p), contacts, strict=True):
        row = p.scratch.contacts.now[slot]
        assert row.rolling_impulse == pytest.approx(contact.rolling, abs=1e-11)
        for k, point in enumerate(contact.points, start=1):
            assert row[f"normal_impulse{k}"] == pytest.approx(point.normal, abs=1e-11)
            assert row[f"tangent_impulse{k}"] == pytest.approx(point.tangent, abs=1e-11)


def test_warm_start(paused):
    bodies, contacts = twin(paused)
    paused.warm()
    warm_start(contacts)
    assert_same(paused, bodies, contacts)


@pytest.mark.parametrize("bouncy", [False, True])
def test_a_substep_of_the_solver(paused, bouncy):
    """Warm start, solve softly, move, relax: twice."""
    paused.prepare(bouncy)
    soft = soft_coefficients(55.0, 1.5, paused.substep)
    bodies, contacts = twin(paused, bouncy)
    rate = 1.0 / paused.substep
    for _ in range(2):
        paused.warm()
        warm_start(contacts)
        paused.solve(soft[0], soft[2], -3.0)
        solve(contacts, Pass(rate, *soft, 3.0), 0.0)
        assert_same(paused, bodies, contacts)
        paused.move()
        for body, motion in zip(bodies, paused.motions, strict=True):
            body.moved, body.turned = vector(motion, "delta_x", "delta_y"), vector(motion, "delta_cos", "delta_sin")
        paused.solve(0.0, 0.0, 0.0, 1e30, OVER_RELAXATION)
        for contact in contacts:
            contact.allowance = 1e30
        solve(contacts, Pass(rate), OVER_RELAXATION)
        for contact in contacts:
            contact.allowance = 0.0
        assert_same(paused, bodies, contacts)


def test_warm_starting_by_bodies_is_warm_starting_by_contacts(paused):
    """After a substep whose contacts gave impulses along normals and tangents, and torques."""
    soft = soft_coefficients(55.0, 1.5, paused.substep)
    paused.begin_parts()
    paused.warm()
    paused.solve(soft[0], soft[2], -3.0)
    paused.move()
    for _ in range(3):
        paused.solve(0.0, 0.0, 0.0, 1e30, OVER_RELAXATION)
    paused.turn_parts()
    motions = plain(paused.motions)
    ended = motions.copy()
    paused.warm()
    by_contacts = motions.copy()
    motions[:] = ended
    paused.add_parts()
    for name in ("velocity_x", "velocity_y", "angular_velocity"):
        assert motions[name] == pytest.approx(by_contacts[name], abs=1e-10)
        assert paused.scratch.solver.parts[name] == pytest.approx(ended[name], abs=1e-15)
    assert np.abs(by_contacts["velocity_y"] - ended["velocity_y"]).max() > 1e-3


def run(p: Paused) -> tuple[list[list[float]], list[list[float]]]:
    """Motions and contacts after two substeps: to the last bit, but for the sign of zero."""
    soft = soft_coefficients(55.0, 1.5, p.substep)
    for _ in range(2):
        p.warm()
        p.solve(soft[0], soft[2], -3.0)
        p.move()
        p.solve(0.0, 0.0, 0.0)
    p.store()
    return p.motions.tolist(), p.scratch.contacts.now[: p.count].tolist()


@pytest.mark.parametrize("make", WORLDS.values(), ids=WORLDS)
def test_lanes_are_independent_to_the_bit(make):
    together, alone = Paused(make()), Paused(make())
    for p in (together, alone):
        p.detect()
        p.lay_out()
        p.begin()
    alone.one_contact_a_block()
    assert run(together) == run(alone)


def test_blocks_know_whether_a_contact_of_theirs_has_friction():
    mixed, none = Paused(half_slippery()), Paused(stepped(falling_pile(0.0, 1), 80))
    for p in (mixed, none):
        p.detect()
        p.lay_out()
    for block in mixed.scratch.blocks.blocks[: mixed.blocks]:
        rows = mixed.scratch.blocks.slots.contact[block.first : block.first + block.count]
        friction = mixed.scratch.contacts.now.friction[rows]
        assert block.frictional == (1 if (friction > 0.0).any() else 0)
    frictional = mixed.scratch.blocks.blocks.frictional[: mixed.blocks]
    assert 0 < frictional.sum() < len(frictional)
    assert not none.scratch.blocks.blocks.frictional[: none.blocks].any()


def test_colours_share_no_moving_body(paused):
    bodies, contacts, colors = paused.state.bodies, paused.scratch.contacts.now, paused.scratch.blocks.colors % KIND
    seen: dict[int, set[int]] = {}
    for i in range(paused.count):
        touched = {int(b) for b in (contacts[i].body_a, contacts[i].body_b) if bodies[b].inverse_mass > 0.0}
        color = int(colors[i])
        assert 0 <= color <= MAX_COLORS
        if color < MAX_COLORS:
            assert not touched & seen.setdefault(color, set())
            seen[color] |= touched
        # Greedy: all lower colours are taken by earlier contacts of one of the two bodies.
        lower = {int(colors[k]) for k in range(i) if touched & {int(contacts[k].body_a), int(contacts[k].body_b)}}
        assert set(range(color)) <= lower


def test_every_contact_has_one_slot_and_every_block_one_colour(paused):
    assert sorted(slots(paused)) == list(range(paused.count))
    place, last = 0, -1
    for block in paused.scratch.blocks.blocks[: paused.blocks]:
        assert block.first == place
        members = [int(paused.scratch.blocks.slots[place + k].contact) for k in range(block.count)]
        colors = {int(paused.scratch.blocks.colors[m]) for m in members}
        assert len(colors) == 1
        (color,) = colors
        assert color >= last
        assert members == sorted(members)
        serial = color % KIND == MAX_COLORS
        assert block.serial == (1 if serial else 0)
        assert 1 <= block.count <= LANES
        assert block.rolling == (paused.scratch.contacts.now.rolling_resistance[members] > 0.0).any()
        for k in range(block.count):
            slot = paused.scratch.blocks.slots[place + k]
            contact = paused.scratch.contacts.now[slot.contact]
            assert (slot.body_a, slot.body_b) == (contact.body_a, contact.body_b)
        place, last = place + int(block.count), color
    assert place == paused.count


def test_the_plank_has_serial_contacts():
    p = Paused(WORLDS["plank"]())
    p.detect()
    p.lay_out()
    assert (p.scratch.blocks.colors[: p.count] % KIND == MAX_COLORS).sum() >= 10


def test_contacts_of_unsettled_bodies_come_first(paused):
    scratch, bodies = paused.scratch, paused.state.bodies
    unsettled = (scratch.solver.ccd.unsettled != 0) & (bodies.inverse_mass > 0.0)
    ranges = BlockRanges(*fill_blocks(scratch.solver.colors, scratch.blocks, 0))
    count = int(scratch.blocks.blocks.count[: ranges.unsettled].sum())
    touch = [unsettled[slot.body_a] or unsettled[slot.body_b] for slot in scratch.blocks.slots[: paused.count]]
    assert ranges.struck == 0
    assert ranges.total == paused.blocks
    assert touch == [True] * count + [False] * (paused.count - count)


def crate(name: str, x: float, y: float):
    """A box of 1 m."""
    return flat_body(name, box(1.0, 1.0), position=(x, y))


def test_only_what_overlaps_deeply_or_touches_something_new_is_unsettled():
    def unsettled(spacing, steps):
        world = put(ground(), *(crate(f"b{k}", 3.0 * k, 0.5) for k in range(3)), crate("top", 3.0, 0.5 + spacing))
        world.step(steps)
        p = Paused(world)
        p.detect()
        return [name for name, row in zip(world.names, p.scratch.solver.ccd, strict=True) if row.unsettled]

    assert unsettled(1.0, 0) == ["ground", "b0", "b1", "b2", "top"]
    assert unsettled(1.0, 1) == []
    assert unsettled(0.5, 1) == ["b1", "top"]


@pytest.mark.parametrize("make", WORLDS.values(), ids=WORLDS)
def test_rubbish_of_an_earlier_step_reaches_nobody(make):
    clean, dirty = Paused(make()), Paused(make())
    dirty.scratch.blocks.lanes[:] = 1e3
    dirty.scratch.blocks.heads[:] = dirty.scratch.blocks.further[:] = dirty.scratch.blocks.starts[:] = 12345
    for table in dirty.scratch.decisions:
        plain(table).view(np.float64)[:] = 1e3
    dirty.scratch.solver.colors[:] = -1
    for p in (clean, dirty):
        p.detect()
        p.lay_out()
        p.begin()
    assert run(clean) == run(dirty)


def ranges(blocks):
    """The blocks of each colour, first to last."""
    count = int(blocks.starts[0])
    return [blocks.blocks[int(first) : int(end)] for first, end in pairwise(blocks.starts[1 : count + 2])]


@pytest.mark.parametrize("count", [2, 40, 70, 100])
def test_bodies_in_one_place_get_colours_for_nearly_all_their_contacts(count):
    w = put(ground(), *(flat_body(f"{k}", circle(0.5 + 0.001 * k), position=(0.01 * k, 3.0)) for k in range(count)))
    w.step(2)
    p = Paused(w)
    p.detect()
    p.lay_out()
    blocks, bodies = p.scratch.blocks, p.state.bodies
    assert sorted(slots(p)) == list(range(p.count))
    one_by_one = 0
    for colour in ranges(blocks):
        assert len({int(block.serial) for block in colour}) == 1
        taken = [slot for block in colour for slot in blocks.slots[int(block.first) : int(block.first + block.count)]]
        if colour[0].serial:
            one_by_one += len(taken)
            continue
        moving = [int(b) for slot in taken for b in (slot.body_a, slot.body_b) if bodies[b].inverse_mass > 0.0]
        assert len(moving) == len(set(moving))
    assert sum(int(block.count) for colour in ranges(blocks) for block in colour) == p.count
    assert one_by_one <= 0.05 * p.count


def test_contacts_of_one_body_with_hundreds_are_solved_one_by_one():
    p = Paused(WORLDS["plank"]())
    p.detect()
    p.lay_out()
    assert sum(int(block.count) for colour in ranges(p.scratch.blocks) for block in colour if block.serial) >= 10


@pytest.mark.parametrize("left", [-3, -2, -1, 0, 1, 7])
def test_who_takes_part_in_a_hard_blow_does_not_depend_on_what_impacts_have_left(left):
    """Groups of impacts use the same numbers of bodies as scratch, and leave there which impact is their first."""
    p = Paused(WORLDS["pile"]())
    p.detect()
    p.lay_out()
    p.begin()
    p.scratch.solver.struck[:] = left
    touching = {int(body) for slot in p.scratch.blocks.slots[: p.count] for body in (slot.body_a, slot.body_b)}
    assert p.moved() == sorted(touching & {int(row) for row in p.active_bodies})
