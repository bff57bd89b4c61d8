"""How often impacts without restitution are solved in a step, printed: run without compiling, where kernels are Python.

A plank of 500 times the mass of the box that it lies on takes several times the scene's substeps, in each of which
another box lands on it.
"""

from __future__ import annotations

from typing import Any

from sandbox import SetPose, SetVelocity
from sandbox.engine.restitution import inelastic
from sandbox.engine.world import World
from tests.flat import body, box, ground, scene

SUBSTEPS = 4
LANDINGS = 12
SPEED = 20.0


def landings() -> World:
    """They are on their way: each is there when the one before has just landed."""
    boxes = [body(f"b{k}", box(0.5, 0.5), position=(float(k), 50.0), gravity_scale=0.0) for k in range(LANDINGS)]
    light = body("light", box(1.0, 1.0), position=(0.0, 0.5))
    plank = body("plank", box(20.0, 1.0, density=25.0), position=(0.0, 1.5))
    world = World(scene(ground(), light, plank, *boxes))
    world.step(2)
    level = int(world.scratch.solver.free_motions["substep_level"].max())
    assert level > 0
    way = SPEED / (60.0 * SUBSTEPS * 2**level)
    for k in range(LANDINGS):
        top = world.body("plank").position[1] + 0.5
        world.apply(SetPose(f"b{k}", (1.5 * (k - 0.5 * LANDINGS), top + 0.25 + (k + 0.5) * way), 0.0))
        world.apply(SetVelocity(f"b{k}", (0.0, -SPEED), 0.0))
    return world


def times_solved(world: World) -> int:
    """How many times they are solved in the next step."""
    found = 0
    solve: Any = inelastic.solve_until_agreed

    def counted(*arguments: Any) -> None:
        nonlocal found
        found += 1
        solve(*arguments)

    inelastic.solve_until_agreed = counted  # type: ignore[assignment]
    world.step()
    inelastic.solve_until_agreed = solve
    return found


if __name__ == "__main__":
    print(times_solved(landings()))
