"""A machine with all ten kinds of joint, and commands that stir it. Run as a script, prints a digest a step."""

from __future__ import annotations

import math
from typing import Any

from sandbox import ApplyForce, BreakJoint, SetJoint, SetLimits, SetMotor, SetTarget, SetVelocity
from sandbox.engine.world import World
from sandbox.scene.flat import FlatJoint, FlatScene
from tests.flat import body, box, circle, ground

STEPS = 20
COMMANDS: dict[int, Any] = {
    1: ApplyForce("bob", (30.0, 5.0)),
    3: SetMotor("axle", -3.0, 20.0),
    5: BreakJoint("chain-2"),
    7: SetTarget("mouse", (9.0, 3.0)),
    9: SetJoint("weld", False),
    11: SetJoint("weld", True),
    13: SetLimits("hinge", -0.2, 0.2),
    15: SetJoint("drive", max_force=6.0, offset=(0.3, 0.2), angle=math.radians(20.0), angular_hertz=2.0),
    17: SetVelocity("puck", (4.0, 2.0), 5.0),
}
"""Commands by the step they come before."""


def scene() -> FlatScene:
    """All kinds, with limits, motors, springs and breakage; in contact and in the air."""

    def at(x: float, y: float) -> dict[str, Any]:
        return {"anchor_a": (x, y), "anchor_b": (x, y)}

    links = [body(f"link-{k}", box(0.5, 0.1), position=(-5.0 + 0.5 * k, 6.0)) for k in range(5)]
    hinges = [
        FlatJoint(f"chain-{k}", "revolute", f"link-{k - 1}" if k else None, f"link-{k}", **at(-5.25 + 0.5 * k, 6.0))
        for k in range(5)
    ]
    bodies = (
        ground(40.0),
        body("bob", circle(0.3), position=(-2.0, 4.0)),
        body("car", box(2.0, 0.4), position=(2.0, 0.9)),
        body("wheel", circle(0.4), position=(2.6, 0.5)),
        body("sled", box(0.6, 0.3), position=(5.0, 4.0), angle=0.2),
        body("gear", circle(0.5), position=(7.0, 5.0), angular_velocity=2.0),
        body("crate", box(0.5, 0.5), position=(8.0, 2.0), angle=0.4),
        body("lamp", box(0.4, 0.6), position=(10.0, 4.0)),
        body("puck", circle(0.3), position=(12.0, 4.0), gravity_scale=0.0, velocity=(1.0, 0.0)),
        body("left", box(0.5, 0.5), position=(14.0, 3.0)),
        body("right", box(0.5, 0.6), position=(16.0, 3.0)),
        *links,
    )
    joints = (
        FlatJoint("rod", "distance", None, "bob", anchor_a=(-2.0, 6.0), anchor_b=(-2.0, 4.0), upper=2.2, lower=1.0),
        FlatJoint("skid", "revolute", "car", "gear", joints=None, enabled=False, **at(1.0, 0.9)),
        FlatJoint("axle", "wheel", "car", "wheel", axis=(0.0, 1.0), hertz=4.0, damping_ratio=0.5, **at(2.6, 0.5)),
        FlatJoint("slide", "prismatic", None, "sled", axis=(0.8, 0.6), lower=-0.3, upper=2.0, **at(5.0, 4.0)),
        FlatJoint("pin", "revolute", None, "gear", motor_speed=3.0, max_motor=2.0, **at(7.0, 5.0)),
        FlatJoint("cogs", "gear", None, None, joints=("slide", "pin"), ratio=-0.5),
        FlatJoint("mouse", "target", None, "crate", points=((8.0, 4.0),), hertz=3.0, max_force=20.0, **at(8.2, 2.1)),
        FlatJoint("weld", "weld", None, "lamp", angular_hertz=2.0, angular_damping_ratio=0.3, **at(10.0, 4.4)),
        FlatJoint("hinge", "revolute", "lamp", "left", hertz=1.0, damping_ratio=0.1, enabled=False, **at(11.0, 4.0)),
        FlatJoint("rub", "friction", None, "puck", max_force=0.2, max_torque=0.01, **at(12.0, 4.0)),
        FlatJoint(
            "rope", "pulley", "left", "right", anchor_a=(14.0, 3.3), anchor_b=(16.0, 3.3),
            points=((14.0, 6.0), (16.0, 6.0)), ratio=1.5,
        ),
        FlatJoint("drive", "motor", "left", "right", points=((16.0, 3.5),), hertz=1.0, max_force=3.0, **at(16.0, 3.0)),
        *hinges,
    )  # fmt: skip
    return FlatScene(bodies, joints=joints)


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
