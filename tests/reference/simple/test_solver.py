"""The simple solver against closed forms: one impulse, many passes, and what each technique is for."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from sandbox.reference.simple.bodies import Body
from sandbox.reference.simple.contacts import Contact, Point
from sandbox.reference.simple.solver import BAUMGARTE, Numbers, Pass, forget, solve, step, warm_start
from sandbox.reference.simple.techniques import Techniques

STILL = Numbers(gravity=0j)
RIGID = Pass(60.0)


def ground() -> Body:
    """A body that nothing moves."""
    return Body(0.0, 0.0, 0j, 0.0, dynamic=False)


def falling(speed: float, mass: float = 2.0, inertia: float = 0.5, spin: float = 0.0) -> Body:
    """A body on its way down."""
    return Body(1 / mass, 1 / inertia, complex(0, -speed), spin)


def landing(body: Body, *anchors: complex, gap: float = 0.0, **surface: float) -> Contact:
    """A body above the ground, touching it at points given from its centre."""
    points = [Point(10 + anchor, anchor, gap) for anchor in anchors]
    return Contact(ground(), body, 1j, points, **surface)


def test_one_impulse_below_the_centre_stops_the_fall() -> None:
    body = falling(3.0)
    contact = landing(body, -1j)
    solve([contact], RIGID)
    assert contact.points[0].normal == pytest.approx(2.0 * 3.0)
    assert (body.velocity, body.angular) == (pytest.approx(0j), 0.0)


def test_an_impulse_beside_the_centre_turns_and_costs_less() -> None:
    body = falling(3.0)
    contact = landing(body, 0.5 - 1j, friction=0.0)
    solve([contact], RIGID)
    mass = 1 / (1 / 2.0 + 0.5 * 0.5 / 0.5)
    assert contact.points[0].normal == pytest.approx(mass * 3.0)
    assert body.angular == pytest.approx(0.5 * mass * 3.0 / 0.5)
    assert contact.speed(contact.points[0], 1j) == pytest.approx(0.0, abs=1e-15)
    assert body.velocity.imag < 0.0


def test_momentum_is_kept_between_two_bodies() -> None:
    a, b = Body(1 / 3.0, 1 / 0.7, 2 + 1j, 0.3), Body(1 / 5.0, 1 / 2.0, -1 + 0.5j, -0.2)
    contact = Contact(a, b, complex(0.6, 0.8), [Point(0.3 + 0.2j, -0.4 - 0.1j, 0.0)], friction=0.4)
    place = 0.3 + 0.2j  # of the point, from the centre of a
    center_b = place - (-0.4 - 0.1j)

    def momenta() -> tuple[complex, float]:
        spin = 0.7 * a.angular + 2.0 * b.angular + (center_b.conjugate() * 5.0 * b.velocity).imag
        return 3.0 * a.velocity + 5.0 * b.velocity, spin

    before = momenta()
    solve([contact], RIGID)
    assert contact.points[0].normal > 0.0
    assert contact.points[0].tangent != 0.0
    assert momenta() == (pytest.approx(before[0]), pytest.approx(before[1]))


def test_what_parts_is_let_go() -> None:
    body = falling(-3.0)
    contact = landing(body, -1j, gap=-0.1)
    solve([contact], RIGID)
    assert (contact.points[0].normal, body.velocity) == (0.0, 3j)


def test_a_gap_may_close_within_the_time_and_no_faster() -> None:
    body = falling(3.0)
    solve([landing(body, -1j, gap=0.01)], RIGID)
    assert body.velocity == pytest.approx(-0.6j)
    slow = falling(0.5)
    solve([landing(slow, -1j, gap=0.01)], RIGID)
    assert slow.velocity == -0.5j


@pytest.mark.parametrize(("slip", "after"), [(0.5, 0.0), (5.0, 5.0 - 0.4 * 3.0)])
def test_friction_holds_up_to_its_share_of_the_load(slip: float, after: float) -> None:
    body = Body(0.5, 0.0, complex(slip, -3.0), 0.0)
    solve([landing(body, -1j, friction=0.4)], RIGID)
    assert body.velocity == pytest.approx(complex(after, 0.0), abs=1e-15)


def test_a_belt_drags_along_and_rolling_is_braked() -> None:
    body = Body(0.5, 0.0, -3j, 0.0)
    solve([landing(body, -1j, friction=1.0, surface_speed=2.0)], RIGID)
    assert body.velocity == pytest.approx(2.0 + 0j)
    disc = falling(3.0, spin=4.0)
    solve([landing(disc, -1j, friction=0.0, rolling_resistance=0.1)], RIGID)
    assert disc.angular == pytest.approx(4.0 - 0.1 * 6.0 / 0.5)


def test_restitution_gives_back_its_share_of_the_speed_before() -> None:
    body = falling(3.0)
    step([body], [landing(body, -1j, restitution=0.5)], STILL, Techniques(), lambda: None)
    assert body.velocity == pytest.approx(1.5j)
    slow = falling(0.1)
    step([slow], [landing(slow, -1j, restitution=0.5)], STILL, Techniques(), lambda: None)
    assert slow.velocity == pytest.approx(0j, abs=1e-15)


def tower(count: int, speed: float = 1.0) -> list[Contact]:
    """Bodies of 1 kg, one above the other, all falling together."""
    bodies = [ground(), *(falling(speed, 1.0) for _ in range(count))]
    return [Contact(a, b, 1j, [Point(1j, -1j, 0.0)]) for a, b in pairwise(bodies)]


def test_passes_come_to_what_holds_all_at_once() -> None:
    contacts = tower(3)
    errors = []
    for _ in range(60):
        solve(contacts, RIGID)
        errors.append(abs(contacts[0].points[0].normal - 3.0))
    assert [contact.points[0].normal for contact in contacts] == pytest.approx([3.0, 2.0, 1.0], abs=1e-4)
    # The slowest error shrinks by cos^2(pi / (2 n)) in a pass.
    assert errors[20] / errors[19] == pytest.approx(math.cos(math.pi / 6) ** 2, rel=1e-3)


def test_a_clamped_sum_takes_back_what_was_too_much() -> None:
    # A crate of 1 m and 1 kg on a post of half its width.
    def fallen(accumulate: bool) -> tuple[Body, Contact]:
        body = falling(1.0, 1.0, 1 / 6)
        contact = landing(body, -0.25 - 0.5j, 0.25 - 0.5j, friction=0.0)
        for _ in range(40):
            solve([contact], Pass(60.0, accumulate=accumulate))
        return body, contact

    body, contact = fallen(True)
    assert [point.normal for point in contact.points] == pytest.approx([0.5, 0.5])
    assert (body.velocity, body.angular) == (pytest.approx(0j, abs=1e-12), pytest.approx(0.0, abs=1e-12))
    body, contact = fallen(False)
    first = 1 / (1 + 6 / 16)
    second = first * (1 - first * (1 - 6 / 16))
    assert body.velocity.imag == pytest.approx(first + second - 1.0)  # it leaves, faster than it would have to
    assert body.velocity.imag > 0.1
    assert abs(body.angular) > 0.1


def test_warm_starting_begins_where_the_last_substep_ended() -> None:
    contacts = tower(8)
    for _ in range(2000):
        solve(contacts, RIGID)
    bodies = [contact.b for contact in contacts]
    for body in bodies:
        body.velocity = -1j
    warm_start(contacts)
    assert [body.velocity.imag for body in bodies] == pytest.approx([0.0] * 8, abs=1e-9)
    forget(contacts)
    assert {(p.normal, p.tangent) for contact in contacts for p in contact.points} == {(0.0, 0.0)}


def overlapping(techniques: Techniques) -> Body:
    """A body 0.1 m deep in the ground, after a step without gravity."""
    body = falling(0.0)
    step([body], [landing(body, -1j, gap=-0.1)], STILL, techniques, lambda: None)
    return body


def test_relaxing_takes_back_the_speed_of_the_push() -> None:
    still = overlapping(Techniques())
    assert still.velocity == pytest.approx(0j, abs=1e-15)
    assert 0.005 < still.center.imag < 0.1
    assert overlapping(Techniques(relax=False)).velocity.imag > 0.5


def test_baumgarte_takes_back_a_fifth_of_the_overlap_in_a_substep() -> None:
    fast = Numbers(gravity=0j, push_out_speed=1e9)
    body = falling(0.0)
    step([body], [landing(body, -1j, gap=-0.1)], fast, Techniques(soft=False, substeps=1), lambda: None)
    assert body.center.imag == pytest.approx(BAUMGARTE * 0.1)
    body = falling(0.0)
    step([body], [landing(body, -1j, gap=-0.1)], fast, Techniques(soft=False), lambda: None)
    assert body.center.imag == pytest.approx(0.1 - 0.1 * (1 - BAUMGARTE) ** 4)


def test_without_speculation_a_fast_body_goes_through() -> None:
    for speculative, height in ((True, -0.5), (False, -50.0 / 60.0)):
        body = Body(1.0, 1.0, -50j, 0.0)
        contact = landing(body, -1j, gap=0.5)
        step([body], [contact], STILL, Techniques(speculative=speculative, substeps=1), lambda: None)
        assert body.center.imag == pytest.approx(height)


def test_every_pass_is_told() -> None:
    heard: list[int] = []
    step([], [], STILL, Techniques(substeps=3, iterations=2), lambda: heard.append(1))
    assert len(heard) == 3 * (2 + 2)
    heard.clear()
    step([], [], STILL, Techniques(substeps=3, iterations=2, relax=False), lambda: heard.append(1))
    assert len(heard) == 6
