"""What rolls on evenly, slow enough to sleep, is no faster than it was but for rounding, and sleeps."""

from __future__ import annotations

from sandbox.scene.flat import FlatSettings
from tests.flat import body, circle, ground, world


def test_discs_that_roll_on_evenly_sleep_at_the_same_time() -> None:
    """Whatever digits their speeds end in."""
    radii = [0.2 + 0.01 * k for k in range(40)]
    discs = [
        body(
            f"d{k}",
            circle(r, friction=0.5),
            position=(3.0 * k - 60.0, r),
            velocity=(0.01, 0.0),
            angular_velocity=-0.01 / r,
        )
        for k, r in enumerate(radii)
    ]
    w = world(ground(friction=0.5), *discs, settings=FlatSettings())
    w.step(60)
    assert {w.body(f"d{k}").awake for k in range(len(radii))} == {False}
