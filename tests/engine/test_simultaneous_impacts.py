"""Impacts that fall on a body in the same moment, against closed forms and against trying who pushes."""

from __future__ import annotations

import math
import random
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sandbox import SetVelocity
from sandbox._jit import interpreted
from sandbox.engine.records.state import StateTables
from sandbox.engine.restitution.groups import ALONE, STRIKES
from sandbox.engine.restitution.impact_list import listed_impacts
from sandbox.engine.restitution.in_turn import _select_closing
from sandbox.engine.restitution.rattling import FEWEST_STRIKES
from sandbox.engine.restitution.worklist import list_all
from tests.engine.test_impacts import check_momentum_and_energy, highest_closing_speed, struck
from tests.examples import examples
from tests.flat import body, box, circle, segment, world
from tests.naive.simultaneous import impulses_of

restitutions = st.floats(0.05, 1.0)


def bed(directions, surfaces, moves: float = 0.0):
    """Lines that touch a disc of half a metre around the origin from these directions (rad), on one body."""
    lines = []
    for angle, surface in zip(directions, surfaces, strict=True):
        x, y = math.cos(angle), math.sin(angle)
        middle, along = (0.5 * x, 0.5 * y), (-y * 0.1, x * 0.1)
        ends = [(middle[0] + s * along[0], middle[1] + s * along[1]) for s in (-1, 1)]
        lines.append(segment(ends[0], ends[1], **surface))
    return body("bed", *lines, type="kinematic" if moves else "static", velocity=(0.0, moves))


def disc_in(directions, e, velocity, friction: float = 0.0, moves: float = 0.0):
    """The motion of a disc that strikes several lines at once; `e` by line."""
    surfaces = [{"restitution": each, "friction": friction} for each in e]
    disc = body("disc", circle(0.5, friction=friction), velocity=velocity)
    return struck(world(bed(directions, surfaces, moves), disc, gravity=(0.0, 0.0)))


@pytest.mark.parametrize("e", [0.3, 0.8, 1.0])
@pytest.mark.parametrize("slope", [10.0, 30.0, 60.0, 80.0])
@pytest.mark.parametrize("moves", [0.0, 3.0])
def test_a_disc_rebounds_straight_from_a_notch(slope, e, moves):
    """Also from one that comes to meet it, as if it stood still."""
    directions = [math.radians(-90.0 - slope), math.radians(-90.0 + slope)]
    motion = disc_in(directions, [e, e], (0.0, -4.0 + moves), 0.0, moves).motions[1]
    assert motion.velocity_x == pytest.approx(0.0, abs=1e-5)
    assert motion.velocity_y == pytest.approx(4.0 * e + moves, rel=1e-5)


@pytest.mark.parametrize("apart", [1e-5, 4e-3])
def test_what_hardly_comes_later_strikes_in_the_same_moment(apart):
    """At 3.5 m/s 10 um are 3 us, a 1,400th of a substep; 4 mm are a quarter, and the first one turns the disc away."""
    slope = math.radians(30.0)
    lines = []
    for side, gap in ((-1.0, 0.001), (1.0, 0.001 + apart)):
        nx, ny = -side * math.sin(slope), math.cos(slope)
        middle = (-(0.5 + gap) * nx, -(0.5 + gap) * ny)
        ends = [(middle[0] + s * 0.1 * ny, middle[1] - s * 0.1 * nx) for s in (-1, 1)]
        lines.append(segment(ends[0], ends[1], restitution=1.0, friction=0.0))
    disc = body("disc", circle(0.5, friction=0.0), velocity=(0.0, -4.0))
    motion = struck(world(body("bed", *lines, type="static"), disc, gravity=(0.0, 0.0))).motions[1]
    if apart < 1e-4:
        assert (motion.velocity_x, motion.velocity_y) == pytest.approx((0.0, 4.0), abs=1e-5)
    else:
        assert (motion.velocity_x, motion.velocity_y) == pytest.approx((4.0 * math.cos(slope), 2.0), abs=1e-5)


@pytest.mark.parametrize("e", [0.3, 0.5, 1.0])
@pytest.mark.parametrize("friction", [0.1, 0.3, 0.5])
def test_friction_turns_round_when_a_disc_in_a_notch_does(friction, e):
    """On the way in it helps to stop the disc, by c + s friction a unit of load, on the way out it holds it back."""
    slope = math.radians(30.0)
    c, s = math.cos(slope), math.sin(slope)
    motion = disc_in([-0.5 * math.pi - slope, -0.5 * math.pi + slope], [e, e], (0.0, -4.0), friction).motions[1]
    assert motion.velocity_y == pytest.approx(4.0 * e * (c - s * friction) / (c + s * friction), rel=2e-3)
    assert abs(motion.velocity_x) + abs(motion.angular_velocity) < 2e-3


@pytest.mark.parametrize("friction", [0.0, 0.2, 0.5])
def test_a_box_rebounds_from_a_corner_the_way_it_came(friction):
    """It strikes wall and floor flat."""
    lines = [segment((0, 0), (9, 0), friction=friction, restitution=0.5),
             segment((0, 9), (0, 0), friction=friction, restitution=0.5)]  # fmt: skip
    case = body("box", box(1.0, 1.0, friction=friction), position=(0.5, 0.5), velocity=(-4.0, -4.0))
    motion = struck(world(body("walls", *lines, type="static"), case, gravity=(0.0, 0.0))).motions[1]
    speed = 2.0 * (1.0 - friction) / (1.0 + friction)
    assert (motion.velocity_x, motion.velocity_y) == pytest.approx((speed, speed), rel=2e-3)
    assert abs(motion.angular_velocity) < 2e-3


@given(
    st.lists(st.tuples(st.floats(-2.8, -0.4), restitutions), min_size=2, max_size=4, unique_by=lambda line: line[0]),
    st.floats(-2.0, 2.0),
)
@examples(200)
def test_a_disc_on_any_lines_is_what_trying_finds(lines, sideways):
    directions, e = zip(*sorted(lines), strict=True)
    assume(min(b - a for a, b in pairwise(directions)) > 0.25)
    p = disc_in(directions, e, (sideways, -4.0))
    normals = np.array([[-math.cos(a), -math.sin(a)] for a in directions])
    before = np.array([sideways, -4.0])
    closing = -normals @ before
    assume(np.all(np.abs(closing - 0.2) > 1e-6) and p.count == len(directions))
    strikes = closing > 0.2
    inverse = float(p.state.bodies[1].inverse_mass)
    pushed, rebounds = normals[strikes], np.array(e)[strikes]
    loads = impulses_of(inverse * pushed @ pushed.T, closing[strikes], rebounds)
    after = before + inverse * loads @ pushed
    assume(np.all(normals @ after > -0.2 + 1e-6))  # else others strike next
    motion = p.motions[1]
    assert np.array([motion.velocity_x, motion.velocity_y]) == pytest.approx(after, abs=1e-4)


@given(st.integers(0, 2**32), restitutions, st.floats(0.0, 1.0), st.integers(2, 9))
@examples(150)
def test_what_strikes_together_keeps_momentum_and_never_gains_energy(seed, e, friction, count):
    """Discs that touch, in a hexagon, thrown at each other."""
    rng = np.random.default_rng(seed)
    places = (
        [(0.0, 0.0)] + [(math.cos(a), math.sin(a)) for a in math.pi / 3 * np.arange(6)] + [(2.0, 0.0), (0.0, 3**0.5)]
    )
    discs = [
        body(f"{k}", circle(0.5, restitution=e * (0.3 if k % 3 else 1.0), friction=friction), position=place,
             velocity=tuple(map(float, 4.0 * rng.normal(size=2) - 3.0 * np.array(place))),
             angular_velocity=float(5.0 * rng.normal()), mass=float(10.0 ** rng.uniform(-1.0, 1.0)))
        for k, place in enumerate(places[:count])
    ]  # fmt: skip
    p = struck(world(*discs, gravity=(0.0, 0.0)))
    check_momentum_and_energy(p)
    assert highest_closing_speed(p) <= 0.2 + 1e-9


@pytest.mark.parametrize("e", [0.5, 1.0])
def test_a_ball_that_strikes_two_at_once(e):
    """The textbook's answer: the two share (1 + e) times what stops it, and part at 30 degrees."""
    two = [body(f"{s}", circle(0.5, restitution=e, friction=0.0), position=(0.5 * s, 0.75**0.5)) for s in (-1, 1)]
    cue = body("cue", circle(0.5, restitution=e, friction=0.0), velocity=(0.0, 5.0))
    motions = struck(world(cue, *two, gravity=(0.0, 0.0))).motions
    along = (1.0 + e) * 5.0 * math.cos(math.pi / 6) / 2.5
    assert motions[0].velocity_y == pytest.approx(5.0 - 2.0 * along * math.cos(math.pi / 6), abs=1e-5)
    assert motions[0].velocity_x == pytest.approx(0.0, abs=1e-5)
    for k, side in ((1, -1.0), (2, 1.0)):
        assert motions[k].velocity_x == pytest.approx(side * along * 0.5, abs=1e-5)
        assert motions[k].velocity_y == pytest.approx(along * 0.75**0.5, abs=1e-5)


def break_of(rows: int, order: list[int]):
    """A rack of balls, 1 mm apart, and a cue ball that comes straight on; listed in an order."""
    r, apart = 0.03, 0.061
    balls = [
        body(
            f"{k}.{j}",
            circle(r, restitution=1.0, friction=0.0),
            position=((j - 0.5 * k) * apart, k * apart * 0.75**0.5),
        )
        for k in range(rows)
        for j in range(k + 1)
    ]
    balls.append(body("cue", circle(r, restitution=1.0, friction=0.0), position=(0.0, -0.3), velocity=(0.0, 8.0)))
    return world(*(balls[k] for k in order), gravity=(0.0, 0.0))


def test_a_break_is_the_same_left_and_right_in_whatever_order_balls_are_listed():
    rows = 5
    names = [f"{k}.{j}" for k in range(rows) for j in range(k + 1)]
    order = list(range(len(names) + 1))
    first = break_of(rows, order)
    random.Random(1).shuffle(order)
    second = break_of(rows, order)
    energies = []
    for w in (first, second):
        w.step(30)
        energies.append(sum(math.hypot(*w.body(name).velocity) ** 2 for name in [*names, "cue"]))
    assert energies == pytest.approx([64.0, 64.0], rel=1e-9)
    for k in range(rows):
        for j in range(k + 1):
            x, y = first.body(f"{k}.{j}").position
            for other, sign in ((first.body(f"{k}.{k - j}"), -1.0), (second.body(f"{k}.{j}"), 1.0)):
                assert other.position == pytest.approx((sign * x, y), abs=2e-5)


@pytest.mark.parametrize("order", [1, -1])
def test_what_comes_later_waits(order):
    """A disc strikes a post head on after 1 ms and never gets to the other one, in whose way it would be after 3 ms; in
    which order they are listed changes nothing."""
    posts = [
        body("near", circle(0.1), type="static", position=(0.0, 0.42)),
        body("far", circle(0.1), type="static", position=(-0.25, 0.37)),
    ]
    ball = body("ball", circle(0.3, restitution=1.0, friction=0.0), velocity=(0.0, 20.0))
    p = struck(world(ball, *posts[::order], gravity=(0.0, 0.0)))
    motion = p.motions[0]
    assert p.count == 2
    assert (motion.velocity_x, motion.velocity_y) == pytest.approx((0.0, -20.0), abs=1e-9)


def test_more_impacts_at_once_than_are_solved_together_end_too():
    """500 discs fall into notches: those past the limit strike one by one, and none gains energy or stays closing."""
    lines, discs = [], []
    for k in range(500):
        x = 3.0 * k
        for side in (-1.0, 1.0):
            lines.append(segment((x, 0.0), (x + side, 3.0**-0.5), restitution=0.8, friction=0.0))
        discs.append(body(f"{k}", circle(0.5), position=(x, 0.5 / math.cos(math.pi / 6)), velocity=(0.0, -4.0)))
    p = struck(world(body("bed", *lines, type="static"), *discs, gravity=(0.0, 0.0)))
    motions = p.motions[1:501]
    straight = np.abs(motions.velocity_x) < 1e-5
    assert 40 <= straight.sum() < 500
    assert motions.velocity_y[straight] == pytest.approx(3.2, rel=1e-5)
    assert np.all(np.hypot(motions.velocity_x, motions.velocity_y) <= 4.0 + 1e-9)
    assert highest_closing_speed(p) <= 0.2 + 1e-9


def test_an_impact_as_a_substep_ends_is_not_lost():
    """A ball of 2 m/s, 0.2 m away: it touches as a substep ends, but for rounding."""
    for count in range(2, 8):
        balls = [body(f"{k}", circle(0.5, restitution=1.0), position=(float(k), 0.0)) for k in range(1, count)]
        first = body("first", circle(0.5, restitution=1.0), position=(-0.2, 0.0), velocity=(2.0, 0.0))
        w = world(first, *balls, gravity=(0.0, 0.0))
        w.step(10)
        speeds = [w.body(name).velocity[0] for name in ["first", *(f"{k}" for k in range(1, count))]]
        assert speeds == pytest.approx([0.0] * (count - 1) + [2.0], abs=1e-9)


def test_a_long_cradle_passes_many_on():
    """As many leave as came, up to 16 that touch: a contact strikes once for each."""
    for came in (3, 10, 15):
        speed = [3.0] * came + [0.0] * (31 - came)
        balls = [
            body(
                f"{k}", circle(0.5, restitution=1.0), position=(k - (0.01 if k < came else 0.0), 0.0), velocity=(v, 0.0)
            )
            for k, v in enumerate(speed)
        ]
        w = world(*balls, gravity=(0.0, 0.0))
        w.step(4)
        assert [w.body(f"{k}").velocity[0] for k in range(31)] == pytest.approx(speed[::-1], abs=1e-9)


def test_what_rattles_knows_what_it_had_before_the_impacts():
    """Also a contact that found no more to do at each of its turns: what it had in another step means nothing."""
    p = world(
        body("ground", box(9.0, 2.0), type="static"), body("ball", circle(0.5, restitution=1.0), position=(0, 1.6))
    )
    p.apply(SetVelocity("ball", (0.0, -10.0), 0.0))
    p.step()
    tables = StateTables(*[getattr(p.state, name) for name in StateTables._fields])
    solver, impacts = p.scratch.solver, interpreted(listed_impacts)(tables, p.scratch.blocks, 0)
    assert impacts.length == 1
    listed = interpreted(list_all)(impacts.slots, 1)
    solver.free_motions[1].start_y = solver.free_motions[1].free_y = -3.0
    solver.motions[1].delta_y = solver.struck[1] = 0
    solver.impact_bodies[1].start_y = 7.0
    p.state.contacts[0].separation1 = 0.0
    impacts.rows[0].group, impacts.slots[0].strikes = ALONE, FEWEST_STRIKES
    arguments = p.state.bodies, solver, p.state.contacts, impacts, listed, 0.01, True
    closing, _ = interpreted(_select_closing)(*arguments)
    assert closing.first == 0
    assert impacts.rows[0].group == STRIKES
    assert solver.impact_bodies[1].start_y == -3.0
