"""Restitution: heights of bounce and the velocities after a collision."""

from __future__ import annotations

import math
import random

import pytest

from sandbox.scene.flat import FlatShape
from tests.flat import body, box, capsule, circle, ground, polygon, world

G = 9.81
SHAPES = {
    "ball": circle(0.5, restitution=1.0),
    "box": box(1.0, 1.0, restitution=1.0),
    "rounded box": box(0.8, 0.8, radius=0.1, restitution=1.0),
    "capsule": capsule(0.5, 0.5, restitution=1.0),
    "pebble": circle(0.02, restitution=1.0),
}


def apexes(shape, drop: float, count: int, radius: float, steps: int = 20_000) -> list[float]:
    """Heights of the next `count` highest points of a body dropped from `drop` metres above the ground.

    A highest point lies between two steps: the energy of the flight gives it.
    """
    w = world(ground(), body("ball", shape, position=(0.0, radius + drop)))
    ball, found, before = w.body("ball"), [], 0.0
    for _ in range(steps):
        w.step()
        speed = ball.velocity[1]
        if before > 0.0 >= speed:
            found.append(ball.position[1] - radius + speed * speed / (2 * G))
            if len(found) == count:
                break
        before = speed
    return found


@pytest.mark.parametrize("drop", [0.31, 1.0, 5.0])
@pytest.mark.parametrize(("name", "shape"), SHAPES.items(), ids=SHAPES)
def test_restitution_1_keeps_the_height_for_20_bounces(name, shape, drop):
    heights = apexes(shape, drop, 20, 0.02 if name == "pebble" else 0.5)
    assert heights == pytest.approx([drop] * 20, rel=1e-6)


@pytest.mark.parametrize("drop", [1.0, 7.3])
@pytest.mark.parametrize("e", [0.25, 0.5, 0.8])
def test_each_bounce_keeps_e_squared_of_the_height(e, drop):
    heights = apexes(circle(0.5, restitution=e), drop, 3, 0.5)
    expected = [drop * e**2, drop * e**4, drop * e**6]
    # Impacts slower than the threshold of 0.2 m/s do not bounce.
    expected = [h for h in expected if 2 * G * h > 0.25]
    assert heights[: len(expected)] == pytest.approx(expected, rel=1e-6)


def test_without_restitution_nothing_bounces():
    assert all(height < 2e-3 for height in apexes(box(1.0, 1.0), 5.0, 1, 0.5, 300))


def test_a_pair_takes_the_larger_restitution():
    w = world(ground(restitution=0.5), body("ball", circle(0.5, restitution=0.2), position=(0.0, 1.5)))
    w.step(30)
    heights = []
    for _ in range(40):
        w.step()
        heights.append(w.body("ball").position[1])
    assert max(heights) == pytest.approx(0.5 + 0.25, abs=2e-3)


@pytest.mark.parametrize("speed", [0.5, 3.0, 20.0])
@pytest.mark.parametrize(("m1", "m2"), [(1.0, 1.0), (1.0, 3.0), (10.0, 1.0), (1.0, 1000.0)])
@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_head_on_collision_of_discs(m1, m2, e, speed):
    disc = circle(0.5, restitution=e, friction=0.0)
    w = world(
        body("a", disc, position=(-2.0, 0.0), velocity=(speed, 0.0), mass=m1),
        body("b", disc, position=(2.0, 0.0), velocity=(-0.5 * speed, 0.0), mass=m2),
        gravity=(0.0, 0.0),
    )
    w.step(int(60 * 5 / speed))
    v, closing = (m1 * speed - m2 * 0.5 * speed) / (m1 + m2), 1.5 * speed
    va, vb = v - m2 * e * closing / (m1 + m2), v + m1 * e * closing / (m1 + m2)
    assert w.body("a").velocity == pytest.approx((va, 0.0), abs=1e-9 * speed)
    assert w.body("b").velocity == pytest.approx((vb, 0.0), abs=1e-9 * speed)


def test_an_elastic_off_centre_hit_keeps_energy_and_momentum():
    disc = circle(0.5, restitution=1.0, friction=0.0)
    w = world(
        body("a", disc, position=(-2.0, 0.0), velocity=(4.0, 0.0)),
        body("b", disc, position=(2.0, 0.4)),
        gravity=(0.0, 0.0),
    )
    w.step(120)
    va, vb = w.bodies.velocity[0], w.bodies.velocity[1]
    assert va[0] + vb[0] == pytest.approx(4.0)
    assert va[1] + vb[1] == pytest.approx(0.0, abs=1e-12)
    assert va @ va + vb @ vb == pytest.approx(16.0, rel=1e-9)
    assert va @ vb == pytest.approx(0.0, abs=1e-9), "equal discs part at a right angle"


@pytest.mark.parametrize("shape", [circle(0.5, restitution=1.0, friction=0.0), box(1.0, 1.0, restitution=1.0)])
def test_a_ball_between_walls_keeps_its_speed(shape):
    wall = box(1.0, 10.0, friction=0.0)
    w = world(
        body("left", wall, type="static", position=(-3.0, 0.0)),
        body("right", wall, type="static", position=(3.0, 0.0)),
        body("ball", shape, velocity=(5.0, 0.0)),
        gravity=(0.0, 0.0),
    )
    for _ in range(3000):
        w.step()
        assert abs(w.body("ball").velocity[0]) == pytest.approx(5.0, rel=1e-9)


@pytest.mark.parametrize("angle", [30.0, 60.0])
def test_a_frictionless_slanted_bounce_is_a_reflection(angle):
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    w = world(
        ground(restitution=1.0, friction=0.0),
        body("ball", circle(0.5, friction=0.0), position=(-4.0 * c / s, 4.5), velocity=(8.0 * c, -8.0 * s)),
        gravity=(0.0, 0.0),
    )
    w.step(90)
    assert w.body("ball").velocity == pytest.approx((8.0 * c, 8.0 * s), rel=1e-9)
    assert w.body("ball").angular_velocity == 0.0


@pytest.mark.parametrize("incoming", [1, 2, 3])
@pytest.mark.parametrize("gap", [0.0, 0.001])
def test_newtons_cradle_without_strings(incoming, gap):
    """As many balls leave as came, with the speed they came with."""
    ball = circle(0.5, restitution=1.0, friction=0.0)
    pitch = 1.0 + gap
    bodies = [body(f"{i}", ball, position=(pitch * i, 0.0)) for i in range(5 - incoming)]
    bodies += [body(f"in{i}", ball, position=(-2.0 - pitch * i, 0.0), velocity=(3.0, 0.0)) for i in range(incoming)]
    w = world(*bodies, gravity=(0.0, 0.0))
    w.step(120)
    speeds = sorted(w.bodies.velocity[:, 0])
    assert speeds == pytest.approx([0.0] * (5 - incoming) + [3.0] * incoming, abs=1e-6)


@pytest.mark.parametrize("order", ["as they lie", "reversed", "shuffled"])
@pytest.mark.parametrize("count", [40, 150])
def test_a_long_row_passes_an_impact_on_in_any_order_of_its_balls(count, order):
    """Whichever is written down first, and so has the first contact."""
    ball = circle(0.5, restitution=1.0, friction=0.0)
    bodies = [body("in", ball, position=(-2.5, 0.0), velocity=(2.0, 0.0))]
    bodies += [body(f"{i}", ball, position=(float(i), 0.0)) for i in range(count)]
    if order == "reversed":
        bodies.reverse()
    elif order == "shuffled":
        random.Random(count).shuffle(bodies)
    w = world(*bodies, gravity=(0.0, 0.0))
    w.step(120)
    assert w.body(f"{count - 1}").velocity[0] == pytest.approx(2.0, abs=1e-9)
    assert sorted(w.bodies.velocity[:, 0])[:-1] == pytest.approx([0.0] * count, abs=1e-9)


@pytest.mark.parametrize("mass", [1.0, 3.0, 10.0, 30.0, 100.0])
def test_a_heavy_ball_pushes_a_light_one_against_a_wall_as_often_as_billiards_do(mass):
    """G. Galperin, Playing pool with pi (2003): with 100 times the mass they collide 31 times in all."""
    ball = circle(0.5, friction=0.0, restitution=1.0)
    wall = ground(restitution=1.0, friction=0.0)
    light = body("light", ball, position=(0.0, 0.5), mass=1.0)
    heavy = body("heavy", ball, position=(0.0, 2.5), velocity=(0.0, -5.0), mass=mass)
    w = world(wall, light, heavy, gravity=(0.0, 0.0))
    w.step(60)
    fast, slow = 0.0, -5.0  # of the light one and the heavy one
    while slow < fast or fast < 0.0:
        if slow < fast:
            change = 2.0 * (fast - slow) / (1.0 + mass)
            fast, slow = fast - change * mass, slow + change
        else:
            fast = -fast
    assert w.body("heavy").velocity[1] == pytest.approx(slow, rel=1e-9)
    assert w.body("light").velocity[1] == pytest.approx(fast, abs=1e-8)


def test_a_polygon_bounces_without_gaining_energy():
    wedge = polygon((-0.6, -0.3), (0.6, -0.3), (0.0, 0.6), restitution=1.0, friction=0.3)
    w = world(ground(), body("wedge", wedge, position=(0.0, 3.0), angle=0.4))
    record = w.state.bodies[1]
    energy = record.mass * G * record.center_y
    for _ in range(1200):
        w.step()
        speed = record.velocity_x**2 + record.velocity_y**2
        now = record.mass * (G * record.center_y + 0.5 * speed) + 0.5 * record.inertia * record.angular_velocity**2
        assert now <= energy * (1.0 + 1e-3)


BOUNCERS = {"balls": circle(0.3), "capsules": capsule(0.2, 0.1), "boxes": box(0.5, 0.5)}


@pytest.mark.parametrize("kind", sorted(BOUNCERS))
def test_a_closed_box_keeps_the_energy_of_what_bounces_in_it(kind):
    """Without friction and with restitution 1, spins and gravity and all: nine bodies for ten seconds."""
    surface = {"restitution": 1.0, "friction": 0.0}
    sides = [(1.0, 12.0, -5.5, 0.0), (1.0, 12.0, 5.5, 0.0), (12.0, 1.0, 0.0, 5.5), (12.0, 1.0, 0.0, -5.5)]
    walls = [body(f"w{x}{y}", box(a, b, **surface), type="static", position=(x, y)) for a, b, x, y in sides]
    shape = BOUNCERS[kind]
    shape = FlatShape(shape.kind, shape.vertices, shape.radius, **surface)
    spins = [4.0, -3.0, 2.0, 5.0, -1.0, 3.5, -4.5, 0.5, 1.5]
    bouncers = [
        body(f"{i}", shape, position=(3.0 * (i % 3 - 1), 3.0 * (i // 3 - 1)), velocity=(spin, 5.0 - spin),
             angular_velocity=2.0 * spin)
        for i, spin in enumerate(spins)
    ]  # fmt: skip
    w = world(*walls, *bouncers)
    rows = w.state.bodies

    def energy() -> float:
        speeds = rows.velocity_x**2 + rows.velocity_y**2
        height = rows.center_y + 5.0
        return float(
            (rows.mass * (0.5 * speeds + G * height) + 0.5 * rows.inertia * rows.angular_velocity**2)[4:].sum()
        )

    before = energy()
    w.step(600)
    assert energy() == pytest.approx(before, rel=1e-3)


@pytest.mark.parametrize("angle", [0.3, 0.7, 1.1])
def test_a_spinning_box_bounces_off_the_floor_with_all_of_its_energy(angle):
    """Its next corner comes in while it turns: that one bounces too."""
    spinner = box(0.5, 0.5, restitution=1.0, friction=0.0)
    w = world(
        ground(friction=0.0),
        body("box", spinner, position=(0.0, 1.0), velocity=(0.0, -9.65), angular_velocity=24.5, angle=angle),
        gravity=(0.0, 0.0),
    )
    row = w.state.bodies[1]
    before = row.mass * row.velocity_y**2 + row.inertia * row.angular_velocity**2
    w.step(30)
    after = row.mass * row.velocity_y**2 + row.inertia * row.angular_velocity**2
    assert row.velocity_y > 0.0
    assert after == pytest.approx(before, rel=1e-6)
