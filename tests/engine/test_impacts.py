"""Impacts against the textbook: impulses of rigid bodies that strike at points."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.engine.stages import Paused
from tests.examples import examples
from tests.flat import body, box, circle, ground, world
from tests.naive.rough_blow import impulse_of


def struck(w):
    """The world paused after `resolve_impacts` of its first substep, and its contact."""
    p = Paused(w)
    p.detect()
    p.begin()
    p.strike()
    return p


def points(contact, k: int) -> tuple[np.ndarray, np.ndarray]:
    """Anchors of a point."""
    a = np.array([contact[f"anchor_ax{k}"], contact[f"anchor_ay{k}"]])
    return a, np.array([contact[f"anchor_bx{k}"], contact[f"anchor_by{k}"]])


def cross(a, b) -> float:
    """Scalar cross product."""
    return float(a[0] * b[1] - a[1] * b[0])


def speed_at(va, wa, ra, vb, wb, rb) -> np.ndarray:
    """Velocity of b against a at the anchors."""
    return vb + wb * np.array([-rb[1], rb[0]]) - va - wa * np.array([-ra[1], ra[0]])


def energy(body, motion) -> float:
    """Kinetic energy."""
    square = motion.velocity_x**2 + motion.velocity_y**2
    return float(0.5 * body.mass * square + 0.5 * body.inertia * motion.angular_velocity**2)


speeds = st.floats(-5.0, 5.0)


@given(
    st.tuples(speeds, speeds),
    st.tuples(speeds, speeds),
    speeds,
    speeds,
    st.floats(0.0, 1.0),
    st.floats(0.0, 1.0),
    st.floats(0.05, 1.5),
    st.floats(0.1, 10.0),
)
@examples(200)
def test_a_disc_strikes_the_corner_of_a_box(va, vb, wa, wb, e, friction, angle, mass):
    """A disc touches a tilted box off its centre: normal impulse with restitution, and Coulomb friction."""
    corner = np.array([0.5 * math.cos(angle) - 0.3 * math.sin(angle), 0.5 * math.sin(angle) + 0.3 * math.cos(angle)])
    n = np.array([math.cos(0.8), math.sin(0.8)]) if angle < 0.5 else np.array([math.cos(angle), math.sin(angle)])
    place = corner + 0.2 * n
    w = world(
        body("a", box(1.0, 0.6, restitution=e, friction=friction), angle=angle, velocity=va, angular_velocity=wa),
        body("b", circle(0.2, friction=friction), position=tuple(map(float, place)), velocity=vb, angular_velocity=wb,
             mass=mass),
        gravity=(0.0, 0.0),
    )  # fmt: skip
    before = [np.array(v) for v in (va, vb)]
    p = struck(w)
    assume(p.count == 1)
    contact, (a, b), (ma, mb) = p.scratch.contacts.now[0], p.state.bodies, p.motions
    assume(abs(contact.separation1) < 1e-9)
    n = np.array([contact.normal_x, contact.normal_y])
    t = np.array([n[1], -n[0]])
    ra, rb = points(contact, 1)
    closing = float(speed_at(before[0], wa, ra, before[1], wb, rb) @ n)

    def inverse_mass(one, other):
        turning = cross(ra, one) * cross(ra, other) * a.inverse_inertia
        turning += cross(rb, one) * cross(rb, other) * b.inverse_inertia
        return (a.inverse_mass + b.inverse_mass) * float(one @ other) + turning

    impulse = np.zeros(2)
    if closing < -0.2 and e > 0.0:
        slip = float(speed_at(before[0], wa, ra, before[1], wb, rb) @ t)
        inverse = np.array([[inverse_mass(one, other) for other in (n, t)] for one in (n, t)])
        normal, rub = impulse_of(inverse, np.array([closing, slip]), friction, e)
        impulse = normal * n + rub * t
        assume(closing + inverse[0] @ (normal, rub) > -0.2 + 1e-9)  # else they strike twice
    assume(abs(closing + 0.2) > 1e-9)
    assert energy(a, ma) + energy(b, mb) <= (energy(a, a) + energy(b, b)) * (1 + 1e-9)
    assert ma.velocity_x == pytest.approx(va[0] - impulse[0] * a.inverse_mass, abs=1e-9)
    assert ma.velocity_y == pytest.approx(va[1] - impulse[1] * a.inverse_mass, abs=1e-9)
    assert mb.velocity_x == pytest.approx(vb[0] + impulse[0] * b.inverse_mass, abs=1e-9)
    assert mb.velocity_y == pytest.approx(vb[1] + impulse[1] * b.inverse_mass, abs=1e-9)
    assert ma.angular_velocity == pytest.approx(wa - cross(ra, impulse) * a.inverse_inertia, abs=1e-9)
    assert mb.angular_velocity == pytest.approx(wb + cross(rb, impulse) * b.inverse_inertia, abs=1e-9)


@given(st.floats(0.01, 1.0), st.floats(-9.0, -0.5), st.floats(-2.0, 2.0))
@examples(100)
def test_a_flat_box_rebounds_at_both_corners(e, fall, spin):
    w = world(
        ground(),
        body("a", box(1.0, 1.0, restitution=e, friction=0.0), position=(0.0, 0.5), velocity=(0.0, fall),
             angular_velocity=spin),
        gravity=(0.0, 0.0),
    )  # fmt: skip
    p = struck(w)
    motion = p.motions[1]
    before = [fall - 0.5 * spin, fall + 0.5 * spin]
    after = [motion.velocity_y - 0.5 * motion.angular_velocity, motion.velocity_y + 0.5 * motion.angular_velocity]
    assume(all(abs(v + 0.2) > 1e-6 for v in before))
    if all(v < -0.2 for v in before):
        # Two impulses that both push give each corner its own rebound: j1 + j2 = m dv, (j2 - j1) / 2 = I dw.
        wanted = [-e * v for v in before]
        dv, dw = sum(wanted) / 2 - fall, wanted[1] - wanted[0] - spin
        if abs(dw / 6.0) < abs(dv) / 2:
            assert after == pytest.approx(wanted, abs=1e-9)
    assert all(v > -1e-9 or abs(v) <= 0.2 for v in after)
    energy = motion.velocity_y**2 + motion.angular_velocity**2 / 6.0
    assert energy <= (fall**2 + spin**2 / 6.0) * (1 + 1e-9)


def test_slow_impacts_do_not_bounce():
    w = world(
        ground(restitution=1.0),
        body("a", circle(0.5), position=(0.0, 0.5), velocity=(0.0, -0.19)),
        gravity=(0.0, 0.0),
    )
    p = struck(w)
    assert p.motions[1].velocity_y == -0.19


def test_a_body_that_moves_away_is_not_struck():
    w = world(
        ground(restitution=1.0),
        body("a", circle(0.5), position=(0.0, 0.5), velocity=(0.0, 3.0)),
        gravity=(0.0, 0.0),
    )
    assert struck(w).motions[1].velocity_y == 3.0


def test_an_impact_within_the_substep_only():
    """5 m/s closes 21 mm in a substep: a gap of 20 mm strikes, one of 30 mm has to wait."""
    speeds = []
    for gap in (0.02, 0.03):
        ball = body("a", circle(0.5), position=(0.0, 0.5 + gap), velocity=(0.0, -5.0))
        speeds.append(float(struck(world(ground(restitution=1.0), ball, gravity=(0, 0))).motions[1].velocity_y))
    assert speeds == pytest.approx([5.0, -5.0])


@given(st.integers(0, 2**32), st.floats(0.0, 1.0), st.floats(0.0, 1.0))
@examples(60)
def test_impacts_in_a_row_of_boxes_keep_momentum_and_never_gain_energy(seed, e, friction):
    random = np.random.default_rng(seed)
    shape = box(1.0, 1.0, restitution=e, friction=friction)
    boxes = [
        body(f"{i}", shape, position=(1.0 * i, float(0.3 * random.normal())), angular_velocity=float(random.normal()),
             velocity=(float(random.normal() - 2.0 * i), float(random.normal())))
        for i in range(4)
    ]  # fmt: skip
    check_momentum_and_energy(struck(world(*boxes, gravity=(0.0, 0.0))))


def check_momentum_and_energy(p) -> None:
    """Impacts have kept the one and have not raised the other."""
    bodies, motions = p.state.bodies, p.motions
    for way in ("velocity_x", "velocity_y"):
        assert np.sum(bodies.mass * motions[way]) == pytest.approx(np.sum(bodies.mass * bodies[way]), abs=1e-11)
    before = sum(energy(b, b) for b in bodies)
    assert sum(energy(b, m) for b, m in zip(bodies, motions, strict=True)) <= before * (1 + 1e-9)


def heavy_on_light(ratio: float, e: float, flip: float = 1.0):
    """A heavy box comes down on light bodies that lie on the ground and touch it; `flip` -1 mirrors it."""
    surface = {"restitution": e, "friction": 0.0}
    light = [body(f"ball-{x}", circle(0.5, **surface), position=(flip * x, 0.5), mass=1.0) for x in (-1.5, 1.2)]
    light.append(body("box", box(1.0, 1.0, **surface), position=(flip * 0.1, 0.5), mass=1.0))
    heavy = body("heavy", box(4.0, 1.0, **surface), position=(flip * 0.2, 1.5), velocity=(0.0, -5.0), mass=ratio)
    return world(ground(**surface), *light, heavy, gravity=(0.0, 0.0))


def light_between(ratio: float, e: float, flip: float = 1.0):
    """Two heavy balls meet with a light one between them."""
    surface = {"restitution": e, "friction": 0.0}
    return world(
        body("left", circle(0.5, **surface), position=(-flip, 0.0), velocity=(5.0 * flip, 0.0), mass=ratio),
        body("light", circle(0.5, **surface), mass=1.0),
        body("right", circle(0.5, **surface), position=(flip, 0.0), velocity=(-5.0 * flip, 0.0), mass=ratio),
        gravity=(0.0, 0.0),
    )


def highest_closing_speed(p) -> float:
    """Over all points of contacts."""
    motions, worst = p.motions, 0.0
    for contact in p.scratch.contacts.now[: p.count]:
        a, b = motions[contact.body_a], motions[contact.body_b]
        va, vb = (np.array([m.velocity_x, m.velocity_y]) for m in (a, b))
        for k in range(1, contact.point_count + 1):
            ra, rb = points(contact, k)
            speed = speed_at(va, a.angular_velocity, ra, vb, b.angular_velocity, rb)
            worst = max(worst, -float(speed @ [contact.normal_x, contact.normal_y]))
    return worst


@pytest.mark.parametrize("e", [0.3, 0.5, 0.8, 1.0])
@pytest.mark.parametrize("ratio", [1.0, 10.0, 100.0, 1e3, 1e4])
@pytest.mark.parametrize("meet", [heavy_on_light, light_between])
def test_impacts_end_whatever_the_masses(meet, ratio, e):
    """No contact closes faster than the threshold; energy does not rise; what is mirrored has the mirrored outcome."""
    p, mirrored = struck(meet(ratio, e)), struck(meet(ratio, e, -1.0))
    bodies, motions = p.state.bodies, p.motions
    assert highest_closing_speed(p) <= 0.2 + 1e-9
    before = sum(energy(b, b) for b in bodies if b.mass > 0.0)
    after = sum(energy(b, m) for b, m in zip(bodies, motions, strict=True) if b.mass > 0.0)
    assert after <= before * (1.0 + 1e-9)
    other = mirrored.motions
    assert other.velocity_y == pytest.approx(motions.velocity_y, abs=1e-6)
    assert other.velocity_x == pytest.approx(-motions.velocity_x, abs=1e-6)
    assert other.angular_velocity == pytest.approx(-motions.angular_velocity, abs=1e-6)


@pytest.mark.parametrize("e", [0.3, 0.8, 1.0])
@pytest.mark.parametrize("ratio", [1e3, 1e4])
def test_what_is_heavy_rebounds_from_light_ones_with_the_restitution(ratio, e):
    for meet, row, way in ((heavy_on_light, -1, "velocity_y"), (light_between, 2, "velocity_x")):
        w = meet(ratio, e)
        assert struck(w).motions[row][way] == pytest.approx(5.0 * e, abs=0.05)


@pytest.mark.parametrize("ratio", [1.0, 300.0])
def test_what_is_pressed_into_a_nook_is_not_shot_out(ratio):
    """A lift takes discs up into a wedge in which they have no room: no law of impacts may make energy of that."""
    lift = body("lift", box(4.0, 1.0, restitution=0.3), type="kinematic", position=(0.0, 0.0), velocity=(0.0, 2.0))
    roof = [
        body(f"roof{s}", box(6.0, 0.2, restitution=0.3), type="static", position=(1.5 * s, 2.2), angle=-0.6 * s)
        for s in (-1, 1)
    ]
    discs = [
        body(
            f"disc{k}", circle(0.3, restitution=0.3, density=ratio if k == 1 else 1.0), position=(0.62 * k - 0.62, 0.81)
        )
        for k in range(3)
    ]
    w = world(lift, *roof, *discs)
    for _ in range(60):
        w.step()
        assert max(math.hypot(*w.body(f"disc{k}").velocity) for k in range(3)) < 12.0
