"""Pendulums against the elliptic integral, and a double one against its energy."""

from __future__ import annotations

import math

import mpmath
import pytest

from sandbox.engine.joints.fine_substeps import FEW, FINE
from sandbox.engine.world import World
from tests.flat import body, box, circle
from tests.joints.jointed import G, energy, gap, joint, jointed


def pendulum(angle: float, kind: str = "revolute") -> World:
    """A disc of 0.1 m, 1 m below its pivot when it hangs, let go at `angle` (rad)."""
    at = (math.sin(angle), -math.cos(angle))
    if kind == "revolute":
        tie = joint("pin", kind, None, "bob", (0.0, 0.0))
    else:
        tie = joint("pin", kind, None, "bob", anchor_a=(0.0, 0.0), anchor_b=at)
    return jointed((body("bob", circle(0.1), position=at, fixed_rotation=kind == "distance"),), (tie,))


def swings(world: World, steps: int) -> tuple[list[float], list[float]]:
    """Amplitudes (rad) and the times (s) at which it goes through the lowest point to the right.

    Both lie between steps: the amplitude follows from the energy, the crossing from a cubic through both ends.
    """
    bob = world.body("bob")
    amplitudes, crossings = [], []

    def now() -> tuple[float, float]:
        x, y = bob.position
        vx, vy = bob.velocity
        return math.atan2(x, -y), (vy * x - vx * y) / (x * x + y * y)

    inertia_by_mass = 1.0 + (0.5 * 0.01 if bob.angular_velocity or world.joint("pin").type == "revolute" else 0.0)
    for step in range(steps):
        before, speed_before = now()
        world.step()
        after, speed = now()
        if speed_before * speed < 0.0:
            amplitudes.append(math.acos(math.cos(after) - 0.5 * inertia_by_mass * speed * speed / G))
        if before < 0.0 <= after:
            crossings.append((step + crossing(before, speed_before / 60, after, speed / 60)) / 60)
    return amplitudes, crossings


def crossing(x0: float, v0: float, x1: float, v1: float) -> float:
    """Root in 0..1 of the cubic with these values and slopes at 0 and 1."""
    low, high = 0.0, 1.0
    for _ in range(60):
        s = 0.5 * (low + high)
        value = (
            (1 + 2 * s) * (1 - s) ** 2 * x0 + s * (1 - s) ** 2 * v0 + s * s * (3 - 2 * s) * x1 + s * s * (s - 1) * v1
        )
        low, high = (s, high) if value < 0.0 else (low, s)
    return low


@pytest.mark.parametrize("kind", ["revolute", "distance"])
@pytest.mark.parametrize("angle", [0.2, 1.0, 2.5])
def test_a_pendulum_keeps_amplitude_and_period_for_30_seconds(angle, kind):
    world = pendulum(angle, kind)
    amplitudes, crossings = swings(world, 1800)
    assert amplitudes == pytest.approx([angle] * len(amplitudes), rel=1e-3)
    inertia = 1.005 if kind == "revolute" else 1.0
    period = float(4 * mpmath.sqrt(inertia / G) * mpmath.ellipk(mpmath.sin(angle / 2) ** 2))
    assert len(crossings) == int(30.0 / period + 0.25)
    found = (crossings[-1] - crossings[0]) / (len(crossings) - 1)
    assert found == pytest.approx(period, abs=1e-3)
    assert gap(world) < 1e-4 or kind == "distance"


def test_its_pin_reports_the_force_of_statics():
    world = pendulum(0.0)
    world.step(10)
    weight = float(world.state.bodies.mass[0]) * G
    assert world.joint("pin").force == pytest.approx((0.0, weight), abs=1e-6 * weight)
    assert world.joint("pin").torque == pytest.approx(0.0, abs=1e-6 * weight)


def test_a_swinging_pin_carries_weight_and_centripetal_force():
    """At the lowest point after release at 1 rad: m g (1 + 2 (1 - cos 1) / 1.005)."""
    world = pendulum(1.0)
    strongest = 0.0
    for _ in range(120):
        world.step()
        strongest = max(strongest, world.joint("pin").force[1])
    weight = float(world.state.bodies.mass[0]) * G
    assert strongest == pytest.approx(weight * (1 + 2 * (1 - math.cos(1.0)) / 1.005), rel=2e-3)


@pytest.mark.parametrize("shape", ["discs", "rods"])
@pytest.mark.parametrize("lift", [0.1, 1.0, 1.9])
def test_a_double_pendulum_keeps_its_energy(lift, shape):
    """Less than 1 % in 10 s, of the energy between hanging down and where it starts."""
    part = circle(0.1) if shape == "discs" else box(1.0, 0.1, at=(-0.5, 0.0))
    first = body("a", part, position=(1.0, 0.0))
    second = body("b", part, position=(1.0 + math.cos(lift), math.sin(lift)), angle=lift)
    pins = (joint("p", "revolute", None, "a", (0.0, 0.0)), joint("q", "revolute", "a", "b", (1.0, 0.0)))
    world = jointed((first, second), pins)
    b = world.state.bodies
    start = energy(world)
    arms = (1.0, 2.0) if shape == "discs" else (0.5, 1.5)
    lowest = -sum(float(m) * G * arm for m, arm in zip(b.mass, arms, strict=True))
    for _ in range(60):
        world.step(10)
        assert energy(world) == pytest.approx(start, abs=0.01 * (start - lowest))
    assert gap(world) < 2e-3


def test_small_parts_that_touch_nothing_take_finer_substeps():
    at = (1.0, 0.0)
    bob = body("bob", circle(0.1), position=at)
    tie = joint("pin", "revolute", None, "bob", (0.0, 0.0))
    free = jointed((bob,), (tie,))
    leaning = jointed((bob, body("shelf", box(1.0, 1.0), type="static", position=(1.0, -0.6))), (tie,))
    dust = [body(f"dust-{k}", circle(0.1), position=(10.0 + k, 0.0)) for k in range(FEW)]
    crowded = jointed((bob, *dust), (tie,))
    levels_in_use = []
    for world in (free, leaning, crowded):
        world.step()
        levels_in_use.append(int(world.scratch.solver.free_motions.substep_level[0]))
    assert levels_in_use == [FINE, 0, 0]


PINS: dict[str, tuple[str, dict[str, object], bool]] = {
    "wheel": ("revolute", {"at": (0.0, 0.0), "motor_speed": 2.0, "max_motor": 0.5}, False),
    "pendulum": ("revolute", {"at": (0.5, 0.0)}, True),
    "torsion": ("revolute", {"at": (0.0, 0.0), "hertz": 2.0}, True),
    "lift": ("prismatic", {"at": (0.5, 0.0), "axis": (0.0, 1.0), "motor_speed": 2.0}, False),
    "sprung lift": ("prismatic", {"at": (0.5, 0.0), "axis": (0.0, 1.0), "hertz": 2.0}, True),
    "bracket": ("weld", {"at": (0.5, 0.0)}, False),
    "puck": ("friction", {"at": (0.0, 0.0), "max_force": 1.0, "max_torque": 0.1}, False),
    "puck by its rim": ("friction", {"at": (0.3, 0.0), "max_force": 1.0}, False),
    "soft bracket": ("weld", {"at": (0.5, 0.0), "angular_hertz": 2.0}, True),
}


@pytest.mark.parametrize("name", PINS)
@pytest.mark.parametrize("first", [True, False], ids=["to the world", "from the world"])
def test_what_turns_about_its_centre_slides_or_rubs_takes_the_usual_substeps(name: str, first: bool):
    kind, fields, finer = PINS[name]
    pin = joint("pin", kind, *((None, "a") if first else ("a", None)), **fields)
    world = jointed((body("a", box(0.8, 0.5)),), (pin,))
    world.step()
    assert int(world.scratch.solver.free_motions.substep_level[0]) == (FINE if finer else 0)


@pytest.mark.parametrize(
    ("fields", "finer"),
    [
        ({"length": 1.5}, True),
        ({"lower": 0.0, "upper": 1.5}, True),
        ({"lower": 0.0, "upper": 2.0}, False),
        ({"lower": 1.5, "upper": 2.0}, True),
        ({"length": 1.5, "hertz": 1.0}, True),
    ],
    ids=["rod", "taut", "slack", "strut", "spring"],
)
@pytest.mark.parametrize("first", [True, False], ids=["to the world", "from the world"])
def test_what_flies_on_a_slack_rope_takes_the_usual_substeps(fields: dict[str, object], finer: bool, first: bool):
    world_end, own_end = (1.0, 3.5), (1.0, 2.0)
    ends = {"anchor_a": world_end, "anchor_b": own_end} if first else {"anchor_a": own_end, "anchor_b": world_end}
    rope = joint("rope", "distance", *((None, "a") if first else ("a", None)), **ends, **fields)
    world = jointed((body("a", box(0.8, 0.5), position=(1.0, 1.9), angle=0.3),), (rope,))
    world.step()
    assert int(world.scratch.solver.free_motions.substep_level[0]) == (FINE if finer else 0)


def test_a_wheel_gains_speed_by_its_torque_over_its_inertia():
    drive = joint("pin", "revolute", None, "a", (0.0, 0.0), motor_speed=50.0, max_motor=0.25)
    world = jointed((body("a", box(0.8, 0.5)),), (drive,))
    wheel = world.body("a")
    world.step(60)
    assert wheel.angular_velocity == pytest.approx(0.25 / wheel.inertia, rel=1e-9)
    assert wheel.position == pytest.approx((0.0, 0.0), abs=1e-12)
