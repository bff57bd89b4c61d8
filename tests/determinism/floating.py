"""A small scene with every kind of field and shape in them. Run as a script, prints a digest a step."""

from __future__ import annotations

from sandbox.engine.world import World
from sandbox.scene.flat import FlatRegion, FlatScene, FlatSettings, FlatThruster
from tests.fields.pools import inside, water
from tests.flat import body, box, capsule, circle, ground, polygon

STEPS = 40


def scene() -> FlatScene:
    """A pool in a gale, a moon, a rocket, and a sleeper that a gust wakes."""
    pool = FlatRegion("water", water(1.0, 1.0).edges, (0.0, 0.0, 4.0), density=1.0, drag=1.0, angular_drag=0.5)
    gale = FlatRegion("wind", inside(-3.0, 0.5, 9.0, 3.0), flow=(6.0, -2.0), density=0.3, drag=2.0, start=0.2, end=0.6)
    moon = FlatRegion("attraction", center=(8.0, 6.0), strength=20.0, falloff=1, range=5.0)
    zones = FlatRegion("gravity", disc=(-6.0, 3.0, 2.0), gravity=(1.0, 0.0)), FlatRegion("gravity_scale", scale=0.9)
    jets = FlatThruster((1.0, 9.0), (0.2, -0.5), 0.1, 0.4), FlatThruster((-0.5, 0.0), (0.0, 0.5))
    return FlatScene(
        (
            ground(30.0),
            body("raft", box(1.5, 0.4, radius=0.1, density=0.5), position=(0.0, 1.1), angle=0.4),
            body("ball", circle(0.4, density=0.4), position=(1.5, 1.2), velocity=(-1.0, -2.0)),
            body("pill", capsule(0.4, 0.2, density=0.7), position=(-1.6, 1.0), angular_velocity=3.0),
            body("wedge", polygon((-0.5, -0.3), (0.5, -0.3), (0.1, 0.5), density=0.6), position=(0.3, 2.2)),
            body("moon", circle(0.2), position=(8.0, 4.0), velocity=(3.0, 0.0)),
            body("drifter", circle(0.3), position=(-6.0, 3.0)),
            body("rocket", box(0.4, 1.0), position=(5.0, 1.0), thrusters=jets),
            body("crate", box(1.0, 1.0), position=(7.0, 0.5)),
        ),
        settings=FlatSettings(),
        regions=(pool, gale, moon, *zones),
    )


def digests(world: World) -> list[str]:
    """The digest after each step."""
    found = []
    for _ in range(STEPS):
        world.step()
        found.append(world.digest())
    return found


if __name__ == "__main__":
    print("\n".join(digests(World(scene()))))
