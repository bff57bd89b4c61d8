"""Boxes thrown flat: without restitution they stop flat, at any speed; friction takes what Coulomb's law says."""

from __future__ import annotations

import pytest

from sandbox.engine.world import World
from tests.flat import body, box, ground, world

SPEEDS = [3.0, 30.0, 100.0, 1000.0]
FRICTIONS = [0.0, 0.5]
G = 9.81


def thrown(target: str, speed: float, along: float, friction: float, fall: float, restitution: float = 0.0) -> World:
    """A unit box on its way towards the target, `along` which it slides (m/s)."""
    surface = {"friction": friction, "restitution": restitution}
    bodies = [ground(1e4, **surface)]
    if target == "heavy box":
        bodies.append(body("heavy", box(60.0, 2.0, **surface), position=(0.0, 1.0), mass=1e4))
    if target == "wall":
        # The box must not come to the ground.
        bodies = [body("wall", box(2.0, 1e4, **surface), type="static", position=(1.0, 0.0))]
        place, velocity = (-1.87 - 0.01 * speed, 0.0), (speed, along)
    else:
        top = 2.0 if target == "heavy box" else 0.0
        place, velocity = (0.0, top + 1.87 + 0.01 * speed), (along, -speed)
    bodies.append(body("box", box(1.0, 1.0, **surface), position=place, velocity=velocity))
    return world(*bodies, gravity=(0.0, -fall))


def fastest_back(w: World, target: str, speed: float, steps: int = 30) -> float:
    """Highest speed (m/s) of the box away from the target, from the start to `steps` after the blow."""
    box, back = w.body("box"), 0.0
    for _ in range(int(60.0 * (1.37 + 0.01 * speed) / speed) + 1 + steps):
        w.step()
        vx, vy = box.velocity
        back = max(back, -vx if target == "wall" else vy)
    return back


@pytest.mark.parametrize("fall", [0.0, G])
@pytest.mark.parametrize("friction", FRICTIONS)
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("target", ["floor", "heavy box", "wall"])
def test_a_flat_box_does_not_rebound(target, speed, friction, fall):
    w = thrown(target, speed, 0.0, friction, fall)
    assert fastest_back(w, target, speed) < 0.001 * speed
    assert w.body("box").angle == pytest.approx(0.0, abs=0.01)


@pytest.mark.parametrize("share", [0.1, 0.3, 1.0, 3.0])
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("target", ["floor", "wall"])
def test_a_flat_box_that_slides_keeps_what_friction_leaves(target, speed, share):
    """The blow of m v brakes by friction * m v and no more; the box neither turns nor leaves."""
    w = thrown(target, speed, share * speed, 0.5, 0.0)
    assert fastest_back(w, target, speed) < 1e-9 * speed
    left = max(0.0, share - 0.5) * speed
    assert w.body("box").velocity[1 if target == "wall" else 0] == pytest.approx(left, abs=1e-3 * speed)
    assert w.body("box").angle == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("friction", FRICTIONS)
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize(("m1", "m2"), [(1.0, 1.0), (1.0, 3.0), (10.0, 1.0)])
def test_flat_boxes_head_on_share_their_momentum_and_stay_together(m1, m2, speed, friction):
    shape = box(1.0, 1.0, friction=friction)
    gap = 0.5 + 0.011 * speed
    w = world(
        body("a", shape, position=(0.0, 0.0), velocity=(speed, 0.0), mass=m1),
        body("b", shape, position=(1.0 + gap, 0.0), velocity=(-0.4 * speed, 0.0), mass=m2),
        gravity=(0.0, 0.0),
    )
    w.step(int(60.0 * gap / (1.4 * speed)) + 30)
    common = speed * (m1 - 0.4 * m2) / (m1 + m2)
    for name in "ab":
        assert w.body(name).velocity == pytest.approx((common, 0.0), abs=1e-9 * speed)
        assert w.body(name).angle == pytest.approx(0.0, abs=1e-9)
    assert w.body("b").position[0] - w.body("a").position[0] == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("e", [0.5, 1.0])
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("target", ["floor", "wall"])
def test_a_flat_box_that_bounces_leaves_flat(target, speed, e):
    w = thrown(target, speed, 0.0, 0.5, 0.0, e)
    assert fastest_back(w, target, speed) == pytest.approx(e * speed, rel=1e-9)
    assert w.body("box").angular_velocity == pytest.approx(0.0, abs=1e-9 * speed)


@pytest.mark.parametrize("speed", SPEEDS)
def test_what_a_hard_blow_falls_on_does_not_yield(speed):
    """A box strikes one of its own mass that stands: neither is driven into the ground, nor thrown up."""
    standing = body("standing", box(1.0, 1.0), position=(0.0, 0.5))
    w = world(ground(), standing, body("box", box(1.0, 1.0), position=(0.0, 2.87), velocity=(0.0, -speed)))
    deepest = fastest = 0.0
    for _ in range(60):
        w.step()
        deepest = max([deepest, *(-min(c.separation1, c.separation2) for c in w.contacts if c.point_count == 2)])
        fastest = max(fastest, w.body("box").velocity[1])
    assert deepest < 0.005
    assert fastest < 0.01 * speed
