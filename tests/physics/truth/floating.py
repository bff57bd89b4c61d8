"""How deep a box floats: Archimedes' principle."""

from __future__ import annotations

from sandbox.scene.flat import FlatRegion
from tests.flat import body, box, scene
from tests.physics.truth.experiment import RATE, Engine, experiment

HEIGHT = 1.0
"""m, of the box."""


@experiment("box floats on water", "depth to the height of the box, at 0.1 to 0.9 of the water's density", bound=1e-9)
def floating(start: Engine) -> float:
    """Under water is that share of the box which its density is of the water's; drag makes it come to rest there."""
    worst = 0.0
    for share in (0.1, 0.37, 0.5, 0.9):
        water = FlatRegion("water", ((0.0, 1.0, 0.0),), density=2.5, drag=3.0, angular_drag=3.0)
        raft = body("raft", box(4.0, HEIGHT, density=2.5 * share), position=(0.0, 0.4))
        run = start(scene(raft, regions=(water,)))
        run.step(50 * RATE)
        depth = 0.5 * HEIGHT - run.place("raft")[1]
        worst = max(worst, abs(depth - share * HEIGHT) / HEIGHT)
    return worst
