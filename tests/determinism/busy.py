"""A small scene with a bit of everything, and the commands that stir it. Run as a script, prints a digest a step."""

from __future__ import annotations

from sandbox import ApplyForce, EndDrag, MoveDrag, SetPose, SetVelocity, StartDrag
from sandbox.engine.world import World
from sandbox.scene.flat import FlatScene, FlatSettings
from tests.flat import body, box, capsule, circle, ground, polygon, segment

STEPS = 56

COMMANDS = {
    5: StartDrag("box", (0.3, 2.2), 400.0),
    9: MoveDrag("box", (2.0, 3.0)),
    14: ApplyForce("wedge", (30.0, 80.0), 5.0),
    18: SetVelocity("paddle", (0.5, 0.0), -3.0),
    22: EndDrag("box"),
    26: SetPose("pill", (-1.0, 4.0), 1.25),
    50: SetVelocity("bullet", (3.0, -300.0), 40.0),
}
"""Commands by the step they come before."""


def scene() -> FlatScene:
    """Every kind of shape and surface, filters, three body types, a sleeper and the bullet that wakes it."""
    return FlatScene(
        (
            ground(20.0, friction=0.6),
            body("belt", box(3.0, 0.4, surface_speed=1.5), type="static", position=(-3.0, 0.2)),
            body("line", segment((2.0, 0.5), (6.0, 1.5)), type="static"),
            body("paddle", box(2.0, 0.2), type="kinematic", position=(2.5, 2.0), angular_velocity=2.0),
            body("box", box(1.0, 1.0), position=(0.0, 2.0), angle=0.3),
            body("round", box(0.6, 0.6, radius=0.1, friction=0.2), position=(0.4, 3.4), angle=-0.2),
            body("ball", circle(0.4, restitution=0.8), position=(-0.6, 3.2), velocity=(0.0, -4.0)),
            body("wheel", circle(0.3, rolling_resistance=0.05), position=(1.2, 0.4), angular_velocity=-9.0),
            body("pill", capsule(0.4, 0.2, restitution=0.3), position=(-3.0, 0.7), linear_damping=0.2),
            body("wedge", polygon((-0.5, -0.3), (0.5, -0.3), (0.1, 0.5)), position=(2.4, 2.6), angular_damping=0.5),
            body("club", box(0.2, 1.2), circle(0.3, at=(0.0, 0.7)), position=(-1.6, 2.0), angle=1.0),
            body("sleeper", box(1.0, 1.0), position=(8.5, 0.5)),
            body("bullet", circle(0.1), position=(8.3, 9.0), gravity_scale=0.0),
            body("ghost", circle(0.5, category=2, mask=1, group=-3), position=(0.0, 2.5), gravity_scale=0.5),
            body("shade", circle(0.5, category=2, mask=3, group=-3), position=(0.1, 2.9), fixed_rotation=True),
        ),
        settings=FlatSettings(sleeping=True),
    )


def digests(world: World, first: int = 0, last: int = STEPS) -> list[str]:
    """The digest after each of the steps `first`..`last - 1`, with the commands that come before them."""
    found = []
    for step in range(first, last):
        if step in COMMANDS:
            world.apply(COMMANDS[step])
        world.step()
        found.append(world.digest())
    return found


if __name__ == "__main__":
    print("\n".join(digests(World(scene()))))
