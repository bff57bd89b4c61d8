"""No dynamic body comes through a static one, whatever its speed, spin and shape; nothing else hinders it.

The truth about what only passes by is sampled: the free way of every corner, finely.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import SetVelocity
from sandbox.engine.world import World
from sandbox.scene.flat import FlatSettings, FlatShape
from tests.examples import examples
from tests.flat import body, box, capsule, circle, ground, polygon, segment, world

THIN = 0.01
LET_PASS = 0.006
"""5 mm of overlap are let pass; what is caught in several steps on end may creep a little deeper, m."""
MISSILES: dict[str, FlatShape] = {
    "circle": circle(0.1),
    "pellet": circle(0.02),
    "box": box(0.3, 0.2),
    "capsule": capsule(0.3, 0.05),
    "rod": box(2.0, 0.02),
    "needle": capsule(0.8, 0.005),
    "wedge": polygon((0.0, 0.0), (0.3, 0.0), (0.1, 0.25)),
}
WALLS = {"box": box(THIN, 2000.0), "line": segment((0.0, -1000.0), (0.0, 1000.0))}

missiles = st.sampled_from(sorted(MISSILES))
speeds = st.floats(0.0, 3.0).map(lambda power: float(10.0**power))
spins = st.tuples(st.sampled_from([-1.0, 0.0, 1.0]), st.floats(0.0, 3.0)).map(lambda s: s[0] * 10.0 ** s[1])
angles = st.floats(0.0, 2.0 * math.pi)
many = examples(300)


def surfaced(shape: FlatShape, **surface: Any) -> FlatShape:
    """The shape with another surface."""
    return FlatShape(shape.kind, shape.vertices, shape.radius, **surface)


def shot(kind: str, wall: str, start: float, speed: float, heading: float, spin: float, angle: float, **surface: Any):
    """A missile on its way to a wall at x = 0, without gravity."""
    velocity = (speed * math.cos(heading), speed * math.sin(heading))
    missile = surfaced(MISSILES[kind], **surface)
    return world(
        body("wall", surfaced(WALLS[wall], **surface), type="static"),
        body("missile", missile, position=(start, 0.0), velocity=velocity, angular_velocity=spin, angle=angle),
        gravity=(0.0, 0.0),
    )


@many
@given(
    missiles, st.sampled_from(sorted(WALLS)), st.floats(1.2, 9.0), speeds, st.floats(-1.3, 1.3), spins, angles,
    st.sampled_from([0.0, 0.5, 1.0]), st.sampled_from([0.0, 0.5]),
)  # fmt: skip
def test_no_wall_is_passed(kind, wall, away, speed, heading, spin, angle, restitution, friction):
    w = shot(kind, wall, -away, speed, heading, spin, angle, restitution=restitution, friction=friction)
    steps = min(40, 2 + int(60 * 3.0 * away / (speed * math.cos(heading))))
    for _ in range(steps):
        w.step()
        assert w.body("missile").center[0] < 0.0
        assert -overlap(w) > -LET_PASS


def overlap(w: World) -> float:
    """How far the missile's outline reaches past the near side of the wall, in metres."""
    face = min(w.state.vertices.x[: w.state.shapes[0].vertex_count])
    b, shape = w.state.bodies[1], w.state.shapes[1]
    core = w.state.vertices[shape.vertex_start : shape.vertex_start + shape.vertex_count]
    x = b.center_x + b.rotation_cos * core.x - b.rotation_sin * core.y
    return float(x.max() + shape.radius - face)


@examples(100)
@given(st.sampled_from(["rod", "needle", "wedge"]), st.floats(0.13, 1.1), st.floats(0.5, 3.0), st.booleans())
def test_what_only_spins_stays_on_its_side(kind, away, power, back):
    spin = 10.0**power * (-1.0 if back else 1.0)
    w = shot(kind, "box", -away, 0.0, 0.0, spin, 0.5 * math.pi)
    for _ in range(60):
        w.step()
        assert w.body("missile").center[0] < 0.0
        assert overlap(w) < 0.006


@many
@given(missiles, st.floats(0.1, 1.5), st.floats(-3.0, 3.0), st.floats(-900.0, 900.0), spins, angles)
def test_what_passes_by_is_let_by_and_what_hits_keeps_its_energy(kind, away, vx, vy, spin, angle):
    steps = 10
    w = shot(kind, "box", -away, 0.0, 0.0, 0.0, angle, restitution=1.0, friction=0.0)
    if overlap(w) > -0.002:
        return
    w.apply(SetVelocity("missile", (vx, vy), spin))
    nearest = nearest_approach(w, vx, spin, steps / 60)
    start, before = np.array(w.body("missile").center), energy(w)
    w.step(steps)
    missile = w.body("missile")
    free = start + np.array([vx, vy]) * (steps / 60)
    if nearest < -0.002:
        assert missile.angular_velocity == spin
        assert missile.velocity == (vx, vy)
        assert missile.center == pytest.approx(tuple(free), abs=1e-9)
    elif nearest > 0.01:
        assert missile.center != pytest.approx(tuple(free), abs=1e-9)
        assert energy(w) == pytest.approx(before, rel=1e-9)


def nearest_approach(w: World, vx: float, spin: float, seconds: float) -> float:
    """Largest overlap with the wall on the free way, sampled; negative if it passes by."""
    b, shape = w.state.bodies[1], w.state.shapes[1]
    core = w.state.vertices[shape.vertex_start : shape.vertex_start + shape.vertex_count]
    t = np.linspace(0.0, seconds, 40_000)[:, None]
    turned = b.angle + spin * t
    x = b.center_x + vx * t + np.cos(turned) * core.x - np.sin(turned) * core.y
    return float(x.max() + shape.radius + 0.5 * THIN)


def energy(w: World) -> float:
    """Of motion, in joules."""
    b = w.state.bodies[1]
    return float(0.5 * b.mass * (b.velocity_x**2 + b.velocity_y**2) + 0.5 * b.inertia * b.angular_velocity**2)


def room(missiles: list[str], seed: int, **surface: Any) -> World:
    """Missiles that dash about in a closed room of thin walls."""
    rng = np.random.default_rng(seed)
    half, thick = 3.0, THIN
    sides = [((thick, 2 * half), (-half, 0.0)), ((thick, 2 * half), (half, 0.0))]
    sides += [((2 * half, thick), (0.0, -half)), ((2 * half, thick), (0.0, half))]
    walls = [body(f"wall-{i}", box(*s, **surface), type="static", position=p) for i, (s, p) in enumerate(sides)]
    inside = []
    for i, kind in enumerate(missiles):
        speed, heading = 10 ** rng.uniform(0, 3), rng.uniform(0, 2 * math.pi)
        inside.append(
            body(
                f"missile-{i}", surfaced(MISSILES[kind], **surface), position=(1.3 * (i % 4 - 1.5), 1.8 * (i // 4 - 1)),
                velocity=(float(speed * math.cos(heading)), float(speed * math.sin(heading))),
                angular_velocity=float(rng.uniform(-300, 300)), angle=float(rng.uniform(0, 2 * math.pi)),
            )
        )  # fmt: skip
    return world(*walls, *inside)


@examples(40)
@given(
    st.lists(missiles, min_size=1, max_size=12), st.integers(0, 10_000), st.sampled_from([0.0, 0.5, 1.0]), angles,
)  # fmt: skip
def test_nothing_leaves_a_room_of_thin_walls(kinds, seed, restitution, heading):
    """Corners, pushes, gravity, and a command in between."""
    w = room(kinds, seed, restitution=restitution)
    for step in range(60):
        w.step()
        if step == 30:
            w.apply(SetVelocity("missile-0", (1000 * math.cos(heading), 1000 * math.sin(heading)), 200.0))
        assert np.abs(w.bodies.center[4:]).max() < 3.0


@pytest.mark.parametrize("speed", [100.0, 1000.0])
@pytest.mark.parametrize("kinds", [["rod", "rod"], ["rod", "needle", "box"], ["rod", "needle"] * 4])
def test_rods_that_press_each_other_stay_in_the_room(kinds, speed):
    """Rods that others turn, stop and pin, in corners by two walls at once, and wake in mid-step."""
    for seed in range(12):
        w = room(kinds, seed, friction=0.5 * (seed % 2), restitution=float(seed // 2 % 2))
        w.state.settings.sleeping[0] = 1
        shots = w.state.bodies[4:]
        faster = speed / np.sqrt(shots.velocity_x**2 + shots.velocity_y**2)
        w.state.bodies.velocity_x[4:] *= faster
        w.state.bodies.velocity_y[4:] *= faster
        w.state.bodies.angular_velocity[4:] *= 5.0
        for _ in range(150):
            w.step()
            assert np.abs(w.bodies.center[4:]).max() < 3.0, seed


@pytest.mark.parametrize("along", [-0.95, -0.5, 0.3, 0.9])
@pytest.mark.parametrize("speed", [30.0, 300.0, 1000.0])
def test_a_rod_that_is_woken_in_mid_step_is_held(along, speed):
    """The grid asks for no pairs of sleepers with what does not move: their way is looked at all the same."""
    start = (along - 2.0 * speed, 0.02 + 1.0 * speed)
    w = world(
        body("floor", box(4000.0, THIN), type="static", position=(0.0, -0.5 * THIN)),
        body("rod", box(2.0, 0.02), position=(0.0, 0.01)),
        body("ball", circle(0.1, density=1e4), position=start, velocity=(speed, -0.5 * speed), gravity_scale=0.0),
        settings=FlatSettings(),
    )
    w.step(110)
    assert not w.body("rod").awake
    for _ in range(60):
        w.step()
        assert lowest(w, 1) > -LET_PASS


def lowest(w: World, row: int) -> float:
    """The lowest point of a body, in metres."""
    b, shape = w.state.bodies[row], w.state.shapes[row]
    core = w.state.vertices[shape.vertex_start : shape.vertex_start + shape.vertex_count]
    return float((b.center_y + b.rotation_sin * core.x + b.rotation_cos * core.y).min() - shape.radius)


@pytest.mark.parametrize("restitution", [0.0, 1.0])
@pytest.mark.parametrize("spin", [1000.0, -700.0, 300.0])
def test_a_spinner_that_is_held_where_it_touches_gets_off_again(spin, restitution):
    """So fast that it has swung away from where it touches before the solver is done: it must not be held for ever."""
    for away in np.linspace(0.45, 0.95, 11):
        w = shot("rod", "box", -float(away), 0.0, 0.0, spin, 0.5 * math.pi, restitution=restitution, friction=0.0)
        before = energy(w)
        w.step(60)
        assert w.body("missile").center[0] < -away - 0.1
        assert energy(w) < before * (1.0 + 1e-9)
        if restitution == 1.0:
            assert energy(w) == pytest.approx(before, rel=1e-9)


@pytest.mark.parametrize("push", [1.0, 30.0])
def test_a_press_does_not_push_anything_through(push):
    w = world(
        body("wall", box(THIN, 4.0), type="static"),
        body("press", box(1.0, 3.0), type="kinematic", position=(-2.5, 0.0), velocity=(push, 0.0)),
        *(body(f"box-{i}", box(0.4, 0.4), position=(-0.7, 0.5 * (i - 1.5))) for i in range(4)),
        gravity=(0.0, 0.0),
    )
    for _ in range(120):
        w.step()
        assert w.bodies.center[2:, 0].max() < 0.0


def test_a_held_body_goes_on_in_the_next_step():
    """A spinning rod that comes to a wall loses at most a step: it has bounced two steps after it touches."""
    w = shot("rod", "box", -3.0, 100.0, 0.0, 40.0, 0.3, restitution=1.0)
    touch = next(step for step in range(1, 20) if w.step() or overlap(w) > -1.0 / 60 * 140)
    w.step(3)
    assert w.body("missile").velocity[0] < 100.0 - 1e-6, touch


@pytest.mark.parametrize("kind", sorted(MISSILES))
def test_what_lies_on_thin_ground_is_not_held(kind):
    """A body at rest may slide off: the catch hinders only what goes deeper."""
    shape = surfaced(MISSILES[kind], friction=0.0, rolling_resistance=0.0)
    w = world(body("floor", box(400.0, THIN, friction=0.0), type="static"), body("missile", shape, position=(0.0, 0.4)))
    w.step(120)
    w.apply(SetVelocity("missile", (50.0, 0.0), 0.0))
    w.step(60)
    assert w.body("missile").velocity[0] == pytest.approx(50.0, abs=0.1)


PLATES = [("dynamic", -40.0, 0.0), ("dynamic", 0.0, 20.0), ("kinematic", -60.0, 0.0), ("kinematic", 5.0, -25.0)]


@pytest.mark.parametrize(("kind", "speed", "spin"), PLATES)
@pytest.mark.parametrize("missile", sorted(MISSILES))
def test_bullets_do_not_pass_moving_plates(missile, kind, speed, spin):
    for share in np.linspace(0.0, 0.9, 7):
        for shot_speed, turn in ((1000.0, 0.0), (300.0, 100.0), (1.0, 0.0)):
            start = -5.0 - float(share) * shot_speed / 60
            w = world(
                body("plate", box(THIN, 400.0 if spin == 0.0 else 8.0, density=1e4), type=kind, velocity=(speed, 0.0),
                     angular_velocity=spin),
                body("missile", MISSILES[missile], bullet=True, position=(start, 0.0), velocity=(shot_speed, 0.0),
                     angular_velocity=turn),
                gravity=(0.0, 0.0),
            )  # fmt: skip
            before = seen_from_plate(w)
            for _ in range(20):
                w.step()
                after = seen_from_plate(w)
                if max(abs(before[1]), abs(after[1])) < 3.0:
                    assert before[0] * after[0] > 0.0
                before = after


def seen_from_plate(w: World) -> tuple[float, float]:
    """Place of the missile in the plate's frame: across and along."""
    plate, missile = w.state.bodies[0], w.state.bodies[1]
    dx, dy = missile.center_x - plate.center_x, missile.center_y - plate.center_y
    c, s = plate.rotation_cos, plate.rotation_sin
    return float(c * dx + s * dy), float(c * dy - s * dx)


def test_what_is_shot_off_in_mid_step_is_held_too():
    """The grid has not foreseen its way: a fast ball hits one at rest, and that is far beyond the wall in one step."""
    for share in np.linspace(0.0, 0.95, 12):
        w = world(
            body("wall", box(THIN, 40.0), type="static", position=(3.0, 0.0)),
            body("target", circle(0.1, restitution=1.0)),
            body("ball", circle(0.1), position=(-5.0 - 16.0 * float(share), 0.0), velocity=(1000.0, 0.0)),
            gravity=(0.0, 0.0),
        )
        for _ in range(8):
            w.step()
            assert w.body("target").position[0] < 3.0
        assert w.body("target").velocity[0] < 0.0


def test_a_resting_pile_is_not_looked_at():
    """Slow bodies cost nothing: the catch is not even called."""
    w = world(ground(), *(body(f"box-{i}", box(1.0, 1.0), position=(0.0, 0.5 + i)) for i in range(5)))
    w.step(60)
    assert (w.scratch.solver.ccd.fast == 0).all()
