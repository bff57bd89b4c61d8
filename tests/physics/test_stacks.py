"""Resting contacts: stacks stand, piles settle, overlaps resolve, and nothing creeps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.flat import body, box, capsule, circle, ground, polygon, world

G = 9.81


def energy(w) -> float:
    """Kinetic and potential energy of all bodies, J."""
    b = w.state.bodies
    speed = b.velocity_x**2 + b.velocity_y**2
    return float(np.sum(b.mass * (0.5 * speed + G * b.center_y) + 0.5 * b.inertia * b.angular_velocity**2))


ROUNDED = box(0.8, 0.8, radius=0.1)
STANDING = [(box(1.0, 1.0), 12), (box(1.0, 1.0), 20), (ROUNDED, 12), (ROUNDED, 20)]


@pytest.mark.parametrize(("shape", "count"), STANDING)
def test_a_stack_stands_for_600_steps(shape, count):
    boxes = [body(f"{i}", shape, position=(0.0, 0.5 + i)) for i in range(count)]
    w = world(ground(friction=0.5), *boxes)
    start = w.bodies.position.copy()
    w.step(600)
    moved = np.abs(w.bodies.position - start)
    assert moved[:, 0].max() < 0.02
    assert moved[:, 1].max() < 2.5e-3 * count, "contacts give way by a few millimetres"
    assert np.abs(w.bodies.angle).max() < 1e-3
    assert np.abs(w.bodies.velocity).max() < 0.01


def test_an_offset_stack_falls():
    """Leaning past its foot, a stack must fall: standing is not glue."""
    boxes = [body(f"{i}", box(1.0, 1.0), position=(0.3 * i, 0.5 + i)) for i in range(6)]
    w = world(ground(), *boxes)
    w.step(300)
    assert w.bodies.position[-1, 1] < 2.5


def test_a_pyramid_stands():
    boxes = [
        body(f"{row}-{i}", box(1.0, 1.0), position=(1.1 * i - 0.55 * (10 - row), 0.5 + row))
        for row in range(10)
        for i in range(10 - row)
    ]
    w = world(ground(), *boxes)
    start = w.bodies.position.copy()
    w.step(600)
    assert np.abs(w.bodies.position - start).max() < 0.03


def test_a_heavy_box_on_a_light_one():
    w = world(
        ground(),
        body("light", box(1.0, 1.0, density=0.1), position=(0.0, 0.5)),
        body("heavy", box(1.0, 1.0, density=10.0), position=(0.0, 1.5)),
    )
    w.step(600)
    assert w.body("heavy").position == pytest.approx((0.0, 1.5), abs=0.05)
    assert w.body("light").position == pytest.approx((0.0, 0.5), abs=0.05)


@pytest.mark.parametrize(
    "shape",
    [
        circle(0.5),
        box(1.0, 1.0),
        capsule(0.5, 0.3),
        polygon((-0.5, -0.3), (0.5, -0.3), (0.0, 0.6)),
        box(1, 1, radius=0.1),
    ],
    ids=["circle", "box", "capsule", "triangle", "rounded box"],
)
def test_two_bodies_at_the_same_pose_part(shape):
    w = world(body("a", shape), body("b", shape), gravity=(0.0, 0.0))
    w.step(300)
    assert len(w.contacts) == 0 or min(w.contacts.separation1) > -0.01
    gap = w.body("b").center[0] - w.body("a").center[0], w.body("b").center[1] - w.body("a").center[1]
    assert np.hypot(*gap) > 0.5
    assert np.hypot(*gap) < 5.0, "gently"


def test_deep_overlap_is_pushed_out_no_faster_than_the_push_out_speed():
    w = world(body("a", box(1.0, 1.0)), body("b", box(1.0, 1.0), position=(0.3, 0.0)), gravity=(0.0, 0.0))
    gap = w.body("b").position[0] - w.body("a").position[0]
    while gap < 1.0 - 1e-12:
        w.step()
        before, gap = gap, w.body("b").position[0] - w.body("a").position[0]
        assert 0.0 < gap - before <= 3.0 / 60 + 1e-9
    assert w.step_count < 60
    assert w.body("b").velocity[0] - w.body("a").velocity[0] < 0.5, "the push is taken back"


def falling_pile(friction: float, seed: int):
    random = np.random.default_rng(seed)
    shapes = [circle(0.4), box(0.8, 0.5), capsule(0.3, 0.2), polygon((-0.5, -0.3), (0.5, -0.3), (0.0, 0.5))]
    bodies = [
        body(
            f"{i}", replace(shapes[i % 4], friction=friction),
            position=(1.3 * (i % 8) + 0.1 * random.random(), 0.6 + 1.3 * (i // 8)), angle=6.0 * random.random(),
        )
        for i in range(48)
    ]  # fmt: skip
    walls = [body(f"w{x}", box(1.0, 30.0), type="static", position=(x, 14.0)) for x in (-1.5, 11.0)]
    return world(ground(friction=friction), *walls, *bodies)


def reach(w) -> tuple[float, float]:
    """The least and the greatest x of the pile, m."""
    s, ends = w.state, []
    for shape in s.shapes[3:]:
        b = s.bodies[shape.body]
        rows = s.vertices[shape.vertex_start : shape.vertex_start + shape.vertex_count]
        x = b.center_x + b.rotation_cos * rows.x - b.rotation_sin * rows.y
        ends += [x.min() - shape.radius, x.max() + shape.radius]
    return min(ends), max(ends)


@pytest.mark.parametrize("seed", [20, 22, 35, 67, 68])
def test_corners_in_the_nook_of_floor_and_wall_stay_out_of_the_wall(seed):
    """The wall runs on below the floor, where it is hidden: what lies in the nook has sunk in a little."""
    w = falling_pile(0.5, seed)
    w.step(75)
    for _ in range(20):
        w.step(5)
        low, high = reach(w)
        assert low > -1.006
        assert high < 10.506


@pytest.mark.parametrize("friction", [0.0, 0.6])
def test_energy_never_grows_in_a_settling_pile(friction):
    w = falling_pile(friction, 3)
    first = before = energy(w)
    for _ in range(600):
        w.step()
        now = energy(w)
        # Overlap that a blow leaves is pushed out again, which lifts a body by millimetres.
        assert now <= before + 1e-3 * abs(first)
        before = now
    assert now < 0.5 * first


def test_a_pile_comes_to_rest():
    w = falling_pile(0.6, 4)
    w.step(900)
    assert np.abs(w.bodies.velocity).max() < 0.05
    assert min(w.contacts.separation1) > -0.02


def test_a_resting_box_does_not_creep():
    w = world(ground(), body("crate", box(1.0, 1.0), position=(0.0, 0.5), angle=0.0))
    w.step(60)
    x, y = w.body("crate").position
    w.step(3600)
    assert w.body("crate").position == pytest.approx((x, y), abs=1e-9)
    assert abs(w.body("crate").angle) < 1e-9


def test_a_box_does_not_creep_down_a_slope_it_can_hold():
    angle = 0.35
    w = world(
        body("slope", box(100.0, 2.0, (0.0, -1.0)), type="static", angle=angle),
        body("crate", box(1.0, 1.0), position=(-0.5 * np.sin(angle), 0.5 * np.cos(angle)), angle=angle),
    )
    w.step(120)
    x, y = w.body("crate").position
    w.step(3600)
    assert w.body("crate").position == pytest.approx((x, y), abs=1e-4)


def test_a_seesaw_balances_and_tips():
    def seesaw(right: float):
        return world(
            body("pivot", polygon((-0.3, 0.0), (0.3, 0.0), (0.0, 0.5)), type="static"),
            body("plank", box(4.0, 0.1), position=(0.0, 0.55)),
            body("left", box(0.4, 0.4), position=(-1.5, 0.8)),
            body("right", box(0.4, 0.4, density=right), position=(1.5, 0.8)),
        )

    balanced, tipping = seesaw(1.0), seesaw(2.0)
    balanced.step(60)
    tipping.step(60)
    assert abs(balanced.body("plank").angle) < 1e-3
    assert tipping.body("plank").angle < -0.1


@pytest.mark.parametrize("speed", [2.0, -2.0])
def test_a_kinematic_platform_carries_its_rider(speed):
    w = world(
        body("lift", box(4.0, 0.2), type="kinematic", velocity=(0.0, speed)),
        body("crate", box(1.0, 1.0), position=(0.0, 0.6), velocity=(0.0, speed)),
    )
    w.step(120)
    assert w.body("lift").position == pytest.approx((0.0, 2 * speed))
    assert w.body("crate").position[1] == pytest.approx(2 * speed + 0.6, abs=5e-3)
    assert w.body("crate").velocity[1] == pytest.approx(speed, abs=1e-3)


def test_a_turning_kinematic_paddle_pushes():
    w = world(
        body("paddle", box(4.0, 0.2), type="kinematic", angular_velocity=1.0),
        body("ball", circle(0.2), position=(1.5, 0.4)),
        gravity=(0.0, 0.0),
    )
    w.step(60)
    assert w.body("paddle").angle == pytest.approx(1.0)
    assert w.body("ball").position[1] > 0.8


def test_a_body_with_fixed_rotation_does_not_turn():
    w = world(ground(), body("post", box(0.2, 2.0), position=(0.0, 3.0), angle=0.3, fixed_rotation=True))
    w.step(200)
    assert w.body("post").angle == 0.3
    assert w.body("post").velocity == pytest.approx((0.0, 0.0), abs=1e-2)


@pytest.mark.parametrize("count", [20, 49, 50, 51, 70])
def test_a_box_dropped_on_a_tower_does_not_make_it_swing(count):
    """Some of these are at the edge of finer substeps, and as they bounce they weigh more and less."""
    boxes = [body(f"{i}", box(1.0, 1.0), position=(0.0, 0.5 + i)) for i in range(count)]
    w = world(ground(friction=0.5), *boxes, body("dropped", box(1.0, 1.0), position=(0.0, count + 0.52)))
    w.step(5)
    fastest = 0.0
    for _ in range(120):
        w.step()
        fastest = max(fastest, w.body("dropped").velocity[1])
    assert fastest < 0.06 * np.sqrt(2.0 * G * 0.02)
    assert w.body("dropped").position[1] > count + 0.49
