"""Forces, impulses, explosions, gravity and surfaces by command, against Newton."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import ApplyForce, ApplyImpulse, Explode, SetGravity, SetSurface
from sandbox.errors import CommandError
from sandbox.scene.flat import FlatSettings
from tests.examples import examples
from tests.flat import body, box, capsule, circle, ground, polygon, segment, world
from tests.naive.explosion import impulses

WEIGHTLESS = {"gravity": (0.0, 0.0)}
DT = 1 / 60


def refused(w, command) -> str:
    before = w.snapshot()
    with pytest.raises(CommandError) as caught:
        w.apply(command)
    assert w.snapshot() == before
    return str(caught.value)


def test_a_force_at_a_point_pushes_and_turns():
    w = world(body("rod", box(4.0, 0.2), position=(3.0, 1.0), angle=0.3), **WEIGHTLESS)
    rod = w.body("rod")
    w.apply(ApplyForce("rod", (2.0, -1.0), 0.25, (4.0, 3.0)))
    w.step()
    assert rod.velocity == pytest.approx((2.0 / rod.mass * DT, -1.0 / rod.mass * DT), rel=1e-12)
    moment = 0.25 + (4.0 - 3.0) * -1.0 - (3.0 - 1.0) * 2.0
    assert rod.angular_velocity == pytest.approx(moment / rod.inertia * DT, rel=1e-9)
    w.step()
    assert rod.velocity == pytest.approx((2.0 / rod.mass * DT, -1.0 / rod.mass * DT), rel=1e-12)


def test_an_impulse_acts_at_once_and_keeps_the_angular_momentum_of_its_line():
    w = world(body("puck", circle(0.5), position=(1.0, 1.0)), **WEIGHTLESS)
    puck = w.body("puck")
    puck.apply_impulse((0.0, 3.0), 0.5, (1.4, 1.0))
    assert puck.velocity == pytest.approx((0.0, 3.0 / puck.mass))
    assert puck.angular_velocity == pytest.approx((0.4 * 3.0 + 0.5) / puck.inertia)


def test_pushes_wake_and_only_dynamic_bodies_take_them():
    w = world(ground(), body("crate", box(1.0, 1.0), position=(0.0, 0.5)), settings=FlatSettings())
    w.step(120)
    assert not w.body("crate").awake
    w.body("crate").apply_impulse((0.0, 0.0))
    assert w.body("crate").awake
    assert "dynamic" in refused(w, ApplyImpulse("ground", (1.0, 0.0)))
    assert "faster than the limit" in refused(w, ApplyImpulse("crate", (1e9, 0.0)))
    assert "finite" in refused(w, ApplyImpulse("crate", (0.0, 0.0), point=(math.nan, 0.0)))


def test_an_explosion_pushes_all_around_alike():
    around = [(math.cos(k * math.pi / 3), math.sin(k * math.pi / 3)) for k in range(6)]
    balls = [body(f"b{k}", circle(0.25), position=(2.0 * x, 2.0 * y)) for k, (x, y) in enumerate(around)]
    w = world(*balls, body("far", circle(0.25), position=(9.0, 0.0)), **WEIGHTLESS)
    w.apply(Explode((0.0, 0.0), 4.0, 10.0))
    size = 10.0 * 0.5 * (1.0 - 1.75 / 4.0) / w.body("b0").mass
    for k, (x, y) in enumerate(around):
        assert w.body(f"b{k}").velocity == pytest.approx((size * x, size * y), abs=1e-12)
        assert w.body(f"b{k}").angular_velocity == pytest.approx(0.0, abs=1e-12)
    assert w.body("far").velocity == (0.0, 0.0)


def test_an_explosion_beside_a_plank_turns_it_and_one_inside_a_body_leaves_from_its_centre():
    w = world(body("plank", box(0.2, 2.0), position=(1.0, 0.0)), body("disc", circle(1.0), position=(20.0, 0.0)),
              **WEIGHTLESS)  # fmt: skip
    w.apply(Explode((0.0, 0.8), 2.0, 1.0))
    assert w.body("plank").velocity[0] > 0.0
    assert w.body("plank").angular_velocity < 0.0
    w.apply(Explode((19.5, 0.0), 2.0, 1.0))
    assert w.body("disc").velocity == pytest.approx((2.0 / w.body("disc").mass, 0.0))
    assert w.body("disc").angular_velocity == 0.0


def test_an_explosion_pushes_all_or_nobody():
    heavy = body("near", circle(0.5, density=1e4), position=(1.0, 0.0))
    w = world(heavy, body("dust", capsule(1e-4, 1e-4), position=(-1.0, 0.0)), **WEIGHTLESS)
    assert "dust" in refused(w, Explode((0.0, 0.0), 3.0, 1e4))
    assert "radius" in refused(w, Explode((0.0, 0.0), 0.0, 1.0))
    assert "finite" in refused(w, Explode((0.0, math.inf), 1.0, 1.0))
    assert "Explode: its push on 'dust' would make it faster" in refused(w, Explode((0.0, 0.0), 3.0, 1e4))
    for radius in (1e9, 1.1e7, 1e-7):
        message = refused(w, Explode((0.0, 0.0), radius, 1.0))
        assert message.startswith(f"Explode: radius must be from 1e-06 to 1e+07 m, not {radius:g}")


SHAPES = st.sampled_from([
    (circle(0.5),), (box(1.0, 0.6),), (capsule(0.4, 0.2),), (box(0.5, 0.5, radius=0.1), circle(0.2, (0.4, 0.1))),
    (segment((-0.5, 0.0), (0.5, 0.2)), circle(0.1)), (polygon((-0.5, -0.3), (0.6, -0.3), (0.1, 0.5)),),
])  # fmt: skip
PLACES = st.tuples(st.sampled_from([0.0, 0.5, 1.0, 1e4]) | st.floats(-2, 2), st.sampled_from([0.0, 1.0]))


@given(st.lists(st.tuples(SHAPES, PLACES, st.sampled_from([0.0, 0.5, math.pi / 2])), min_size=1, max_size=6), st.data())
@examples(60)
def test_an_explosion_gives_the_bits_of_its_impulses_one_by_one(bodies, data):
    made = [body(f"b{k}", *own, position=at, angle=turn) for k, (own, at, turn) in enumerate(bodies)]
    w, one_by_one = (world(*made, **WEIGHTLESS) for _ in range(2))
    outline = [corner for name in w.bodies.ids for shape in w.body(name).shapes for corner in shape.vertices]
    x, y = data.draw(st.sampled_from(outline) | PLACES)
    point = x + data.draw(st.sampled_from([0.0, 0.5, -0.2, 1e-13])), y  # on outlines and as good as on them
    command = Explode(point, data.draw(st.sampled_from([0.3, 2.0, 5.0])), data.draw(st.sampled_from([1.0, -0.3])))
    w.apply(command)
    for impulse in impulses(one_by_one, command, [each.id for each in made]):
        one_by_one.apply(impulse)
    assert w.state.bodies.tobytes() == one_by_one.state.bodies.tobytes()


def test_an_explosion_wakes_what_lies_on_whom_it_pushes_and_no_others():
    row = [body(f"{name}{k}", box(1.0, 1.0), position=(x + 5.0 * k, 0.5 + y))
           for name, x, y in (("low", 0.0, 0.0), ("high", 0.0, 1.0)) for k in range(4)]  # fmt: skip
    w = world(ground(), *row, settings=FlatSettings())
    w.step(240)
    assert not any(w.body(each.id).awake for each in row)
    w.apply(Explode((2.5, 0.2), 2.5, 0.1))
    assert [w.body(each.id).awake for each in row] == [True, True, False, False] * 2


def test_gravity_turns_over():
    w = world(body("ball", circle(0.5)), ground(), settings=FlatSettings())
    w.step(240)
    assert not w.body("ball").awake
    w.apply(SetGravity((1.5, 0.0)))
    start = w.body("ball").position
    w.apply(SetSurface("ball", friction=0.0))
    w.step(60)
    assert w.body("ball").position[0] - start[0] == pytest.approx(0.75, rel=1e-3)
    assert "limit" in refused(w, SetGravity((0.0, 1e7)))


def test_a_new_surface_holds_from_the_next_step():
    w = world(ground(friction=1.0), body("box", box(1.0, 1.0, friction=1.0), position=(0.0, 0.5), velocity=(3.0, 0.0)))
    w.apply(SetSurface("box", friction=0.0))
    w.step(60)
    assert w.body("box").velocity[0] == pytest.approx(3.0, rel=1e-9)
    w.apply(SetSurface("box", friction=0.25, shape=0))
    w.step(30)
    assert w.body("box").velocity[0] == pytest.approx(3.0 - 0.5 * 9.81 * 0.5, rel=2e-3)


@pytest.mark.parametrize(
    ("command", "word"),
    [
        (SetSurface("ball", friction=-1.0), "friction"), (SetSurface("ball", restitution=1.5), "restitution"),
        (SetSurface("ball", friction=math.nan), "friction"), (SetSurface("ball", friction=0.1, shape=1), "no shape 1"),
    ],
)  # fmt: skip
def test_surfaces_that_no_scene_may_have_are_refused(command, word):
    assert word in refused(world(body("ball", circle(0.5))), command)


def test_commands_come_back_with_a_snapshot():
    w = world(ground(), body("ball", circle(0.5), position=(0.0, 2.0)))
    w.apply(SetGravity((0.0, -3.0)))
    w.apply(SetSurface("ball", restitution=0.9))
    kept = w.snapshot()
    w.step(90)
    end = w.digest()
    w.apply(SetGravity((0.0, 9.0)))
    w.restore(kept)
    w.step(90)
    assert w.digest() == end
