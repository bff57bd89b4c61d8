"""Expectations with teeth: break the physics of a shipped scene, and one of its expectations has to fail."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest

from sandbox.engine.world import World
from sandbox.replay.expectations import Judge
from sandbox.scene import Scene
from sandbox.scene.duration import planned_steps
from tests.shipped import FILES, shipped

pytestmark = pytest.mark.slow

Data = dict[str, Any]
Change = Callable[[Data], None]

CONTACTLESS = {
    "cart-pole", "corners", "flag", "peaucellier", "pendulums", "planets", "pool", "pumpjack", "without-speculation",
}  # fmt: skip
"""Only joints or fields hold these together, or they show what does not touch, or nothing moves before it is played:
then `tests/rules/test_shipped_games.py` judges the recording."""
WEIGHTLESS = {
    "air-hockey", "billiards", "bowling", "breakout", "bullets", "fast-ball", "fast-spinner", "geneva-drive",
    "mini-golf", "peaucellier", "planets", "pool", "turnstile", "without-speculation",
    *(name for name, file in FILES.items() if file.parent.name == "sat"),
}  # fmt: skip
WITH_GRAVITY = sorted(FILES.keys() - WEIGHTLESS)


def broken(name: str, change: Change) -> bool:
    """Whether the scene fails an expectation after `change` was made to its data; the first that fails is enough."""
    data = shipped(name).to_data()
    change(data)
    scene = Scene(**data)
    world = World(scene)
    judge = Judge(scene, world)
    for _ in range(planned_steps(scene)):
        world.step()
        judge.observe()
        if judge.failed:
            return True
    return not all(verdict.holds for verdict in judge.verdicts())


def _shapes(data: Data) -> Iterator[Data]:
    for owner in (*data.get("bodies", ()), *data.get("prefabs", {}).values()):
        yield from owner.get("shapes", ())


def _surfaces(data: Data) -> Iterator[Data]:
    yield from data.get("materials", {}).values()
    yield from _shapes(data)


def everywhere(**fields: Any) -> Change:
    """Give all shapes these fields."""

    def change(data: Data) -> None:
        for shape in _shapes(data):
            shape.update(fields)

    return change


def scaled(field: str, factor: float) -> Change:
    """Multiply a field wherever a material or a shape gives it."""

    def change(data: Data) -> None:
        for surface in _surfaces(data):
            if field in surface:
                surface[field] *= factor

    return change


def gravity(factor: float) -> Change:
    """Multiply the scene's gravity."""

    def change(data: Data) -> None:
        data["gravity"] = [factor * g for g in data.get("gravity", (0.0, -9.81))]

    return change


def of_bodies(field: str, factor: float) -> Change:
    """Multiply a number or a vector wherever a body or a prefab gives it."""

    def change(data: Data) -> None:
        for owner in (*data["bodies"], *data.get("prefabs", {}).values()):
            if field in owner:
                value = owner[field]
                owner[field] = [factor * v for v in value] if isinstance(value, list) else factor * value

    return change


def stones_of(other: str) -> Change:
    """Build with the wedges of another arch."""
    return lambda data: data["prefabs"].update(wedge=shipped(other).to_data()["prefabs"]["wedge"])


def slopes_at(factor: float) -> Change:
    """Scale the height of every triangular slope, but not what stands on it."""

    def change(data: Data) -> None:
        for shape in _shapes(data):
            if len(shape.get("polygon", ())) == 3:
                shape["polygon"] = [[x, factor * y] for x, y in shape["polygon"]]

    return change


@pytest.mark.parametrize("name", WITH_GRAVITY)
def test_every_scene_notices_gravity_upside_down(name: str) -> None:
    assert broken(name, gravity(-1.0))


@pytest.mark.parametrize("name", sorted(FILES.keys() - CONTACTLESS))
def test_every_scene_notices_that_nothing_collides(name: str) -> None:
    assert broken(name, everywhere(mask=0))


MUTATIONS: dict[str, tuple[Change, tuple[str, ...]]] = {
    "no-friction": (
        everywhere(friction=0.0),
        (
            "ramp",
            "braking",
            "arch",
            "card-house",
            "conveyor",
            "rolling-race",
            "polygon-slope",
            "projectiles",
        ),
    ),
    "friction-up-2-percent": (scaled("friction", 1.02), ("ramp",)),
    "friction-down-2-percent": (scaled("friction", 0.98), ("ramp",)),
    "friction-up-5-percent": (scaled("friction", 1.05), ("braking",)),
    "no-bounce": (
        everywhere(restitution=0.0),
        ("bouncing-balls", "newtons-cradle", "newtons-cradle-two", "three-to-one", "far-away"),
    ),
    "bounce-down-2-percent": (
        scaled("restitution", 0.98),
        ("bouncing-balls", "newtons-cradle", "newtons-cradle-two", "three-to-one"),
    ),
    "bounce-everywhere": (
        everywhere(restitution=0.9),
        ("bouncing-balls", "three-to-one", "far-away", "projectiles", "gravity-scale", "wrecking-ball"),
    ),
    "gravity-tripled": (
        gravity(3.0),
        ("projectiles", "parachutes", "gravity-scale", "bouncing-balls", "ramp", "seesaw", "far-away"),
    ),
    "gravity-up-2-percent": (
        gravity(1.02),
        ("projectiles", "parachutes", "gravity-scale", "bouncing-balls", "ramp", "rolling-race"),
    ),
    "no-rolling-resistance": (everywhere(rolling_resistance=0.0), ("rolling-resistance",)),
    "rolling-resistance-up-5-percent": (scaled("rolling_resistance", 1.05), ("rolling-resistance",)),
    "belts-reversed": (scaled("surface_speed", -1.0), ("conveyor",)),
    "belts-slow": (scaled("surface_speed", 0.9), ("conveyor",)),
    "kinematic-slow": (of_bodies("angular_velocity", 0.99), ("mixer", "drum")),
    "less-damping": (of_bodies("linear_damping", 0.95), ("parachutes", "billiards")),
    "launch-slower": (
        of_bodies("velocity", 0.97),
        ("newtons-cradle", "newtons-cradle-two", "projectiles", "billiards", "braking"),
    ),
    "other-inertia": (of_bodies("inertia", 0.5), ("rolling-race",)),
    "other-mass": (lambda data: data["bodies"][1].update(mass=2), ("three-to-one",)),
    "no-filters": (everywhere(mask="default", category="default"), ("filters",)),
    "thin-stones": (stones_of("arch-too-thin"), ("arch",)),
    "thick-stones": (stones_of("arch"), ("arch-too-thin",)),
    "steeper-slope": (slopes_at(1.1), ("ramp", "rolling-race")),
}
"""What is broken, and which scenes have to notice."""


@pytest.mark.parametrize(
    ("mutation", "name"), [(mutation, name) for mutation, (_, names) in MUTATIONS.items() for name in names]
)
def test_broken_physics_breaks_a_promise(mutation: str, name: str) -> None:
    assert broken(name, MUTATIONS[mutation][0])
