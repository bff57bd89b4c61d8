"""Commands on regions and thrusters: what they change, whom they wake, what they refuse."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

import sandbox
from sandbox import DeleteRegion, SetGravity, SetRegion, SetThruster, SetVelocity
from sandbox.engine.world import World
from sandbox.errors import CommandError, SceneError, UnknownBodyError, UnknownRegionError
from sandbox.world.export.scene_now import scene_of

POOL = {"id": "pool", "water": 1, "surface": 0, "inside": [-5, -5, 5, 2], "drag": 2}
CORK = {"id": "cork", "shapes": [{"box": [1, 1], "density": 0.5}], "position": [0, 0]}
BED = {"id": "bed", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -5.5]}
SHORE = {"id": "stone", "shapes": [{"box": [1, 1]}], "position": [12, -4.5]}
REGIONS = [
    POOL,
    {"id": "moon", "gravity": [0, -1.62], "inside": [20, 0, 30, 10]},
    {"id": "lift", "gravity_scale": 0.5, "inside": [30, 0, 40, 10]},
    {"id": "sun", "attraction": 40, "at": [50, 0], "range": 10},
    {"id": "breeze", "wind": [3, 0], "disc": [60, 0, 5]},
    {"water": 2, "inside": [70, -5, 80, 5]},
    {"id": "full", "water": 2, "inside": [90, -5, 99, 5]},
]


def world(*bodies: dict, regions: list = REGIONS, **fields) -> World:
    """A world with all kinds of regions."""
    return World(sandbox.Scene(bodies=list(bodies), regions=regions, **fields))


def test_water_rises_and_wakes_what_floats():
    w = world(BED, CORK, SHORE)
    w.step(900)
    assert w.awake_count == 0
    w.apply(SetRegion("pool", surface=1.0))
    assert (w.body("cork").awake, w.body("stone").awake) == (True, False)
    w.step(900)
    assert w.body("cork").position[1] == pytest.approx(1.0, abs=0.02)
    w.apply(SetRegion("pool", water=2.0))
    w.step(900)
    assert w.body("cork").position[1] == pytest.approx(1.25, abs=0.02)


def test_nobody_floats_where_the_last_region_has_gone():
    """What floats at rest may sleep, what is only slow may not."""
    w = world(CORK, regions=[POOL])
    while not w.scratch.solver.free_motions.buoyed[0]:
        w.step()
    assert w.awake_count == 1
    for command in (DeleteRegion("pool"), SetGravity((0.0, 0.0)), SetVelocity("cork", (0.01, 0.0), 0.0)):
        w.apply(command)
    restored = World(w.scene)
    restored.restore(w.snapshot())
    w.step(60)
    restored.step(60)
    assert w.awake_count == 1
    assert w.snapshot() == restored.snapshot()


def test_off_and_on_again():
    w = world(BED, CORK)
    w.step(900)
    w.apply(SetRegion("pool", enabled=False))
    w.step(300)
    assert w.body("cork").position[1] == pytest.approx(-4.5, abs=0.01)
    assert w.awake_count == 0
    w.apply(SetRegion("pool", enabled=True))
    w.step(900)
    assert w.body("cork").position[1] == pytest.approx(0.0, abs=0.02)


def test_a_switch_takes_the_place_of_the_schedule():
    zone = {"id": "zone", "gravity": [0, 0], "start": 1, "end": 2}
    ball = {"id": "ball", "shapes": [{"circle": 0.5}]}
    late, early = world(ball, regions=[zone]), world(ball, regions=[zone])
    late.apply(SetRegion("zone", enabled=False))
    early.apply(SetRegion("zone", enabled=True))
    late.step(150)
    early.step(150)
    assert late.body("ball").velocity[1] == pytest.approx(-9.81 * 2.5)
    assert early.body("ball").velocity[1] == 0.0


@pytest.mark.parametrize(
    ("command", "at", "velocity"),
    [
        (SetRegion("moon", gravity=(1.0, 0.0)), (25, 5), (1.0, 0.0)),
        (SetRegion("lift", gravity_scale=-1.0), (35, 5), (0.0, 9.81)),
        (SetRegion("sun", attraction=-16.0, falloff=1), (54, 0), (4.0, -9.81)),
        (SetRegion("sun", at=(50.0, 4.0), attraction=80.0), (50, 0), (0.0, 5.0 - 9.81)),
        (SetRegion("sun", range=3.0), (54, 0), (0.0, -9.81)),
    ],
)
def test_what_a_region_does_is_changed(command, at, velocity):
    ball = {"id": "ball", "shapes": [{"circle": 0.1}], "position": list(at)}
    w = world(ball, settings={"step_rate": 1000})
    w.apply(command)
    w.step()
    assert w.body("ball").velocity == pytest.approx([v / 1000 for v in velocity], rel=1e-3)


def test_wind_turns():
    sail = {"id": "sail", "shapes": [{"box": [0.1, 2], "density": 0.1}], "position": [60, 0], "gravity_scale": 0}
    w = world(sail)
    w.apply(SetRegion("breeze", wind=(-8.0, 0.0), density=0.1))
    w.step(60)
    assert w.body("sail").velocity[0] < -3.0


def test_thrusters_are_throttled_and_switched():
    jets = [{"force": [0, 2], "end": 1}, {"force": [1, 0]}]
    rocket = {"id": "rocket", "shapes": [{"box": [1, 1]}], "thrusters": jets, "fixed_rotation": True}
    w = world(rocket, regions=[], gravity=[0, 0])
    w.apply(SetThruster("rocket", force=(0.0, 5.0), thruster=0))
    w.apply(SetThruster("rocket", enabled=False, thruster=1))
    w.step(30)
    assert w.body("rocket").velocity == pytest.approx((0.0, 2.5))
    w.apply(SetThruster("rocket", enabled=True))
    w.step(120)
    assert w.body("rocket").velocity == pytest.approx((2.0, 12.5))
    w.apply(SetThruster("rocket", enabled=False))
    w.step(5)
    assert w.body("rocket").velocity == pytest.approx((2.0, 12.5))


def test_a_thruster_wakes_its_body():
    rocket = {"id": "rocket", "shapes": [{"box": [1, 1]}], "position": [0, -4.5], "thrusters": [{"force": [0, 1]}]}
    w = world(BED, rocket, regions=[])
    w.step(120)
    assert w.awake_count == 0
    w.apply(SetThruster("rocket", force=(0.0, 30.0)))
    w.step(30)
    assert w.body("rocket").velocity[1] > 5.0


def test_a_changed_region_goes_with_the_snapshot():
    w = world(BED, CORK)
    w.apply(SetRegion("pool", surface=1.0, drag=0.5))
    w.step(10)
    saved = w.snapshot()
    w.apply(SetRegion("pool", enabled=False, outline=((-9.0, -5.0), (9.0, -5.0), (0.0, 2.0))))
    w.step(10)
    w.restore(saved)
    fresh = world(BED, CORK)
    fresh.restore(saved)
    w.step(300)
    fresh.step(300)
    assert w.digest() == fresh.digest()
    assert w.body("cork").position[1] > 0.5


@pytest.mark.parametrize(("name", "area"), [
    ("pool", {"inside": [-4, -6, 7, 3], "surface": 1}),
    ("moon", {"inside": [0, 0, 1, 1]}),
    ("breeze", {"disc": [61, 1, 4]}),
    ("ramp", {"outline": [[0, 0], [4, 0], [3, 4]]}),
    ("#6", {"inside": [71, -5, 81, 6]}),
    ("sun", {"range": None}),
    ("pool", {"outline": [[-5, -5], [5, -5], [0, 2]]}),
    ("pool", {"outline": [[-5, -5], [5, -5], [6, 0], [4, 2], [-5, 2]], "surface": 1}),
    ("#6", {"outline": [[70, -5], [80, -5], [80, 5], [76, 5], [70, -3]]}),
    ("ramp", {"inside": [0, 0, 3, 1]}),
])  # fmt: skip
def test_an_area_elsewhere_is_that_of_a_scene_which_has_it_there(name, area):
    there = [*REGIONS, {"id": "ramp", "wind": [1, 0], "outline": [[0, 0], [2, 0], [1, 1]]}]
    number = next(k for k, region in enumerate(there) if name in (region.get("id"), f"#{k + 1}"))
    elsewhere = list(there)
    sides = area.keys() & {"inside", "outline"}
    kept = {field: value for field, value in there[number].items() if not sides or field not in ("inside", "outline")}
    elsewhere[number] = {**kept, **area}
    w, wanted = world(CORK, regions=there), world(CORK, regions=elsewhere)
    w.apply(SetRegion(name, **{field: math.inf if value is None else value for field, value in area.items()}))
    assert w.digest() == wanted.digest()
    for each in (w, wanted):
        each.step(20)
    assert w.digest() == wanted.digest()
    found, told = scene_of(w).scene.regions[number].flat(), wanted.scene.regions[number].flat()
    assert replace(found, edges=()) == replace(told, edges=())
    assert sum(found.edges, ()) == pytest.approx(sum(told.edges, ()), rel=4e-16, abs=1e-15)


def test_an_area_that_comes_and_goes_wakes_what_sleeps_there():
    w = world(BED, CORK, SHORE)
    w.step(900)
    w.apply(SetRegion("pool", inside=(5.0, -5.0, 15.0, 2.0)))
    assert (w.body("cork").awake, w.body("stone").awake) == (True, True)
    w.step(60)
    assert w.body("cork").position[1] < -2.0


REFUSED = [
    (SetRegion("pol", surface=1.0), "no region 'pol' in this world; did you mean 'pool'?"),
    (SetRegion("", surface=1.0), "no region ''"),
    (SetRegion("breeze", surface=1.0), "a region of wind has no surface; it has wind, density, drag"),
    (SetRegion("moon", attraction=1.0), "a region of gravity has no attraction; it has gravity"),
    (SetRegion("full", surface=1.0), "this water has no surface; give it one in the scene"),
    (SetRegion("pool", water=-1.0), "SetRegion of 'pool': water must"),
    (SetRegion("pool", surface=math.nan), "surface must be a finite number"),
    (SetRegion("pool", flow=(1e300, 0.0)), "flow[0] must"),
    (SetRegion("sun", falloff=7), "falloff must"),
    (SetRegion("pool", inside=(0.0, 0.0, 1.0)), "inside must be 4 numbers, not (0.0, 0.0, 1.0)"),
    (SetRegion("pool", inside=(1.0, 0.0, 0.0, 1.0)), "inside"),
    (SetRegion("pool", outline=((0.0, 0.0), (4.0, 0.0), (1.0, 1.0), (0.0, 4.0))), "not convex"),
    (SetRegion("pool", outline=((0.0, 0.0), 1.0)), "outline must be a list of pairs of numbers"),
    (SetRegion("pool", disc=(0.0, 0.0, 1.0)), "its area is no disc"),
    (SetRegion("breeze", inside=(0.0, 0.0, 1.0, 1.0)), "has no sides"),
    (SetRegion("pool", drag=math.inf), "drag must be a finite number"),
    (SetRegion("#1", drag=1.0), "no region '#1'"),
    (SetRegion("#" + 5000 * "9", drag=1.0), "no region"),
    (SetRegion("sun", falloff=1.5), "falloff must be a whole number"),
    (SetRegion("pool", drag="much"), "drag must be a number, not 'much'"),
    (SetRegion("pool", flow=3.0), "flow must be"),
    (SetThruster("corc", force=(1.0, 0.0)), "did you mean 'cork'?"),
    (SetThruster("cork", force=(1.0, 0.0)), "the body has no thrusters"),
    (SetThruster("rocket", thruster=2, enabled=True), "the body has no thruster 2, but 1"),
    (SetThruster("rocket", force=(math.inf, 0.0)), "force must be a finite number"),
    (SetThruster("rocket", force=(1e300, 0.0)), "force[0] must"),
]


@pytest.mark.parametrize(("command", "told"), REFUSED, ids=[str(k) for k in range(len(REFUSED))])
def test_what_cannot_be_done_is_told_and_changes_nothing(command, told):
    rocket = {"id": "rocket", "shapes": [{"box": [1, 1]}], "position": [15, 0], "thrusters": [{"force": [0, 1]}]}
    w = world(BED, CORK, rocket)
    w.step(5)
    before = w.snapshot()
    with pytest.raises((CommandError, UnknownRegionError, UnknownBodyError)) as caught:
        w.apply(command)
    assert told in str(caught.value)
    assert w.snapshot() == before


def test_no_two_regions_have_one_id():
    with pytest.raises(SceneError, match='the id "pool" is taken by another region'):
        world(regions=[POOL, POOL])
