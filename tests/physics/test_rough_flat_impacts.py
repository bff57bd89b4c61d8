"""What lands flat and slides, with restitution and friction: loads take up what friction turns, it leaves flat."""

from __future__ import annotations

import math
import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.engine.world import World
from sandbox.scene.flat import FlatBody, FlatShape
from tests.examples import examples
from tests.flat import body, box, capsule, circle, ground, polygon, segment, world
from tests.joints.jointed import joint, jointed

FALL = 4.0
KINDS = ["box", "rounded box", "capsule", "dumbbell", "table", "box on two tiles"]


def shapes_of(kind: str, **surface: float) -> list[FlatShape]:
    """Shapes of one body, whose lowest points are 0.2 m below its centre."""
    if kind == "rounded box":
        return [box(0.9, 0.3, radius=0.05, **surface)]
    if kind == "capsule":
        return [capsule(0.4, 0.2, **surface)]
    if kind == "dumbbell":
        return [circle(0.2, (x, 0.0), **surface) for x in (-0.4, 0.4)]
    if kind == "table":
        return [box(1.2, 0.1, (0.0, 0.05), **surface), *(box(0.1, 0.4, (x, 0.0), **surface) for x in (-0.5, 0.5))]
    return [box(1.0, 0.4, **surface)]


def floor_of(kind: str, **surface: float) -> FlatBody:
    """Flat ground, in two tiles that abut beside the middle or in one."""
    if kind != "box on two tiles":
        return ground(**surface)
    tiles = [box(50.0, 2.0, (x, -1.0), **surface) for x in (-24.55, 25.45)]
    return body("ground", *tiles, type="static")


def motion_after(w: World, name: str = "thrown") -> tuple[float, float, float]:
    """(vx, vy, w) of a body after its blow."""
    w.step(12)
    thrown = w.body(name)
    return (*thrown.velocity, thrown.angular_velocity)


def after_blow(along: float, friction: float, e: float) -> tuple[float, float, float]:
    """What Newton and Coulomb say of a body that both its points bear: it slides throughout, or stops sliding."""
    slowed = friction * (1.0 + e) * FALL
    return max(0.0, along - slowed), e * FALL, 0.0


@pytest.mark.parametrize("along", [1.0, 5.0])
@pytest.mark.parametrize("friction", [0.1, 0.3])
@pytest.mark.parametrize("e", [0.1, 0.5, 1.0])
@pytest.mark.parametrize("kind", KINDS)
def test_what_lands_flat_leaves_flat(kind, e, friction, along):
    surface = {"restitution": e, "friction": friction}
    thrown = body("thrown", *shapes_of(kind, **surface), position=(0.0, 0.4), velocity=(along, -FALL))
    found = motion_after(world(floor_of(kind, **surface), thrown, gravity=(0.0, 0.0)))
    assert found == pytest.approx(after_blow(along, friction, e), abs=2e-3)


@pytest.mark.parametrize("e", [0.1, 0.5, 1.0])
def test_welded_boxes_that_land_flat_leave_flat(e):
    surface = {"restitution": e, "friction": 0.3}
    boxes = [body(f"{x}", box(0.5, 0.4, **surface), position=(x, 0.4), velocity=(5.0, -FALL)) for x in (-0.25, 0.25)]
    weld = joint("weld", "weld", "-0.25", "0.25", (0.0, 0.4))
    w = jointed((ground(**surface), *boxes), (weld,), gravity=(0.0, 0.0))
    assert motion_after(w, "0.25") == pytest.approx(after_blow(5.0, 0.3, e), abs=5e-3)


@pytest.mark.parametrize("moves", [{"surface_speed": 4.0}, {}])
def test_a_crate_that_falls_on_what_moves_stays_flat(moves):
    surface = {"restitution": 0.5, "friction": 0.3}
    floor = body("floor", box(200.0, 2.0, (0.0, -1.0), **surface, **moves), type="static" if moves else "kinematic",
                 velocity=(0.0 if moves else 4.0, 0.0))  # fmt: skip
    w = world(floor, body("crate", box(1.0, 0.5, **surface), position=(0.0, 1.25)))
    turned = 0.0
    for _ in range(180):
        w.step()
        turned = max(turned, abs(w.body("crate").angle))
    assert turned < math.radians(0.1)
    assert abs(w.body("crate").velocity[0]) == pytest.approx(4.0, abs=0.01)


def test_friction_that_tips_a_column_over_is_borne_by_its_edge():
    """As high as it is for its foot, friction turns it faster than the other edge could hold: that lifts off."""
    surface = {"restitution": 0.5, "friction": 1.0}
    column = body("thrown", box(0.4, 1.0, **surface), position=(0.0, 0.6), velocity=(20.0, -FALL))
    w = world(ground(**surface), column, gravity=(0.0, 0.0))
    vx, vy, spin = motion_after(w)
    assert spin < -1.0  # clockwise, over the leading edge
    energy = 0.5 * (vx * vx + vy * vy) + 0.5 * spin * spin * (0.4**2 + 1.0) / 12.0
    assert energy < 0.5 * (20.0**2 + FALL**2)


@pytest.mark.parametrize("along", [1e-12, -1e-9, 1e-6, -1e-3])
@pytest.mark.parametrize("friction", [0.5, 0.8, 1.2])
@pytest.mark.parametrize("e", [0.3, 1.0])
def test_a_column_that_hardly_slides_leaves_as_one_that_does_not(e, friction, along):
    """Friction would tip it over an edge while it slides, which is over at once: then both edges bear. It is continuous
    in the slip, so it does not matter what rounding leaves of that."""
    surface = {"restitution": e, "friction": friction}
    column = body("thrown", box(1.0, 2.0, **surface), position=(0.0, 1.2), velocity=(along, -FALL))
    found = motion_after(world(ground(**surface), column, gravity=(0.0, 0.0)))
    assert found == pytest.approx((0.0, e * FALL, 0.0), abs=2.0 * abs(along) + 1e-12)


@pytest.mark.parametrize("degrees", [17.0, -48.0, 138.6, 200.0])
def test_a_column_that_falls_flat_on_a_slope_leaves_flat(degrees):
    surface = {"restitution": 0.8, "friction": 1.0}
    angle = math.radians(degrees)
    up = (-math.sin(angle), math.cos(angle))
    floor = body("floor", box(50.0, 2.0, (0.0, -1.0), **surface), type="static", angle=angle)
    column = body("thrown", box(1.0, 1.5, **surface), position=(0.95 * up[0], 0.95 * up[1]), angle=angle,
                  velocity=(-FALL * up[0], -FALL * up[1]))  # fmt: skip
    vx, vy, spin = motion_after(world(floor, column, gravity=(0.0, 0.0)))
    assert (vx, vy, spin) == pytest.approx((0.8 * FALL * up[0], 0.8 * FALL * up[1], 0.0), abs=1e-9)


@given(
    st.floats(0.0, 1.0), st.floats(0.01, 1.5), st.floats(0.1, 3.0), st.floats(-10.0, 10.0), st.floats(-0.02, 0.02),
    st.floats(-2.0, 2.0),
)  # fmt: skip
@examples(60)
def test_no_blow_at_two_points_gains_energy(e, friction, height, along, angle, spin):
    surface = {"restitution": e, "friction": friction}
    thrown = body("thrown", box(1.0, height, **surface), position=(0.0, 0.5 * height + 0.05), angle=angle,
                  velocity=(along, -FALL), angular_velocity=spin)  # fmt: skip
    w = world(ground(**surface), thrown, gravity=(0.0, 0.0))
    crate = w.body("thrown")

    def energy() -> float:
        return 0.5 * crate.mass * math.hypot(*crate.velocity) ** 2 + 0.5 * crate.inertia * crate.angular_velocity**2

    before = energy()
    for _ in range(6):
        w.step()
        assert energy() <= before * (1.0 + 1e-6)


CORNERS = [(-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)]


def closed_box(crowd: list[FlatBody], **surface: float) -> World:
    """A crowd in a closed box, without gravity."""
    ends = zip(CORNERS, CORNERS[1:] + CORNERS[:1], strict=True)
    walls = body("box", *(segment(a, b, **surface) for a, b in ends), type="static")
    return world(walls, *crowd, gravity=(0.0, 0.0))


def highest_gain(w: World, steps: int) -> float:
    """The most energy that a step adds, as a share of what there was at the beginning."""
    b = w.state.bodies[1:]

    def energy() -> float:
        return float(0.5 * (b.mass * (b.velocity_x**2 + b.velocity_y**2) + b.inertia * b.angular_velocity**2).sum())

    first = before = energy()
    gain = 0.0
    for _ in range(steps):
        w.step()
        now = energy()
        gain = max(gain, (now - before) / first)
        before = now
    return gain


@pytest.mark.parametrize(("seed", "count"), [(89, 1), (0, 6), (17, 6), (28, 6), (45, 6), (1, 16)])
def test_a_crowd_that_rubs_as_it_bounces_gains_no_energy(seed, count):
    """Whatever spins, and however it lands."""
    r = random.Random(seed)
    surface = {"restitution": 1.0, "friction": 0.5}
    shapes = (
        box(0.6, 0.3, **surface),
        box(1.2, 0.2, **surface),
        polygon((-0.4, -0.3), (0.5, -0.2), (0.0, 0.5), **surface),
        capsule(0.4, 0.1, **surface),
    )
    crowd = []
    for k in range(count):
        shape = r.choice(shapes)
        speed = r.uniform(-6.0, 6.0), r.uniform(-6.0, 6.0)
        place = -3.0 + 2.0 * (k % 4), -2.0 + 1.5 * (k // 4)
        spin = math.radians(r.uniform(-900.0, 900.0))
        crowd.append(body(f"b{k}", shape, position=place, velocity=speed, angular_velocity=spin))
    assert highest_gain(closed_box(crowd, **surface), 300) < 1e-12


@pytest.mark.parametrize("seed", [11, 24, 27, 68, 136, 160, 170])
def test_crowds_of_light_and_heavy_that_strike_together_hardly_gain_energy(seed):
    """What friction does on the way to where it was found to hold is work, too; heaps are solved to thousandths."""
    r = random.Random(seed)
    count, friction, restitution = r.randrange(5, 60), r.choice([0.0, 0.2, 0.5, 0.8]), r.choice([0.5, 0.9, 1.0])
    surface = {"restitution": restitution, "friction": friction}
    crowd = []
    for k in range(count):
        kind = r.randrange(4)
        speed, spin = (r.uniform(-6.0, 6.0), r.uniform(-6.0, 6.0)), math.radians(r.uniform(-600.0, 600.0))
        weighed = {"density": r.choice([0.1, 1.0, 10.0]), **surface}
        shape = (
            box(0.6, 0.3, **weighed),
            circle(0.3, **weighed),
            polygon((-0.4, -0.3), (0.4, -0.2), (0.0, 0.4), **weighed),
            capsule(0.3, 0.1, **weighed),
        )[kind]
        place = -3.5 + 0.99 * (k % 8), -3.5 + 0.99 * (k // 8)
        crowd.append(body(f"b{k}", shape, position=place, velocity=speed, angular_velocity=spin))
    assert highest_gain(closed_box(crowd, **surface), 120) < 2.5e-3
