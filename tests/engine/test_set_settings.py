"""Settings that are changed while a world runs."""

from __future__ import annotations

from dataclasses import fields

import pytest

from sandbox import CommandError, SetSettings, Settings, StartDrag, record, rerun
from sandbox.engine.world import World
from sandbox.scene.flat import FlatScene, FlatSettings
from tests import flat
from tests.shipped import shipped

OTHERS = {
    "substeps": 7, "contact_hertz": 25.0, "contact_damping_ratio": 4.0, "push_out_speed": 0.5,
    "restitution_threshold": 2.5, "sleeping": False, "warm_starting": False, "accumulate": False, "soft": False,
    "relax": False, "speculative": False,
}  # fmt: skip
"""Another value for each setting than the one that scenes begin with."""


def heap(settings: FlatSettings | None = None) -> FlatScene:
    """Crates that overlap at first, and a ball that bounces."""
    crates = [flat.body(f"crate-{k}", flat.box(1, 1), position=(0.1 * k, 0.45 + 0.95 * k)) for k in range(4)]
    ball = flat.body("ball", flat.circle(0.3, restitution=0.8), position=(20.0, 0.6), velocity=(0.0, -2.0))
    return flat.scene(flat.ground(), *crates, ball, settings=settings or FlatSettings())


def held_tower() -> World:
    """Crates at rest on each other, and one that hangs from a drag; all stay awake."""
    crates = [flat.body(f"crate-{k}", flat.box(1, 1), position=(0.0, 0.5 + k)) for k in range(6)]
    held = flat.body("held", flat.box(1, 1), position=(5.0, 3.0))
    world = World(flat.scene(flat.ground(), *crates, held, settings=FlatSettings(sleeping=False)))
    world.apply(StartDrag("held", (5.0, 3.0)))
    world.step(120)
    return world


def test_all_settings_of_a_scene_but_its_clock_and_unit_can_be_changed() -> None:
    known = {item.name for item in fields(SetSettings)}
    assert known == set(Settings.model_fields) - {"step_rate", "steps", "units_per_meter"} == set(OTHERS)


@pytest.mark.parametrize("name", OTHERS)
def test_before_the_first_step_it_is_as_if_the_scene_had_said_so(name: str) -> None:
    plain, built, told = World(heap()), World(heap(FlatSettings(**{name: OTHERS[name]}))), World(heap())
    told.apply(SetSettings(**{name: OTHERS[name]}))
    assert told.snapshot() == built.snapshot()
    for world in (plain, built, told):
        world.step(120)
    assert told.digest() == built.digest()
    assert plain.digest() != built.digest()


def test_what_is_not_given_stays() -> None:
    world = World(heap(FlatSettings(substeps=3, soft=False)))
    world.apply(SetSettings(contact_hertz=30.0))
    setting = world.state.settings[0]
    assert (setting.substeps, setting.soft, setting.contact_hertz) == (3, 0, 30.0)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"substeps": 0}, "SetSettings: substeps must not be below 1"),
        ({"substeps": 2.5}, "SetSettings: substeps must be a whole number, not 2.5"),
        ({"sleeping": 1}, "SetSettings: sleeping must be True or False, not 1"),
        ({"contact_hertz": 1e6}, "SetSettings: contact_hertz must not be above 10000 Hz"),
        ({"push_out_speed": -1.0}, "SetSettings: push_out_speed must not be"),
        ({"relax": False, "restitution_threshold": float("nan")}, "must be a finite number, not nan"),
    ],
)
def test_what_no_scene_may_have_is_refused_and_changes_nothing(given: dict[str, float], words: str) -> None:
    world = World(heap())
    before = world.snapshot()
    with pytest.raises(CommandError) as caught:
        world.apply(SetSettings(**given))  # type: ignore[arg-type]
    assert words in str(caught.value)
    assert world.snapshot() == before


def test_without_sleep_those_asleep_wake_for_good() -> None:
    world = World(heap())
    world.step(600)
    assert world.awake_count == 0
    world.apply(SetSettings(sleeping=False))
    assert world.awake_count == 5
    world.step(300)
    assert world.awake_count == 5
    world.apply(SetSettings(sleeping=True))
    world.step(300)
    assert world.awake_count == 0


@pytest.mark.parametrize("substeps", [1, 2, 9, 64])
def test_what_rests_is_not_thrown_up_by_other_substeps(substeps: int) -> None:
    """Contacts and drags push with the same forces in the first substep as in the last one before."""
    world = held_tower()
    world.apply(SetSettings(substeps=substeps))
    for _ in range(5):
        world.step()
        assert world.state.bodies.velocity_y.max() < 1e-5


def test_snapshots_and_recordings_hold_them() -> None:
    scene = shipped("three-to-one")
    commands = [(10, SetSettings(substeps=2, soft=False)), (30, SetSettings(sleeping=False, warm_starting=False))]
    recording = record(scene, 60, commands)
    assert rerun(recording).passed
    assert [command for _, command in recording.commands] == [command for _, command in commands]
    world, other = World(scene), World(scene)
    world.step(5)
    world.apply(commands[0][1])
    world.step(5)
    other.restore(world.snapshot())
    world.step(20)
    other.step(20)
    assert world.digest() == other.digest()
