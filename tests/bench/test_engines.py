"""The same scene means the same in every engine, and the same code judges them."""

from __future__ import annotations

import gc
import math
from pathlib import Path
from typing import Any

import pytest

import sandbox
from sandbox.bench.contestants import ENGINES, Ours
from sandbox.bench.course import Course
from sandbox.bench.memory import table_bytes
from sandbox.bench.quality import Judge
from sandbox.bench.race import run_race
from sandbox.reference.box2d_run import Box2dRun
from sandbox.reference.pymunk_run import PymunkRun
from sandbox.reference.run import Pose
from sandbox.resources import find_scene

BOX2D = "box2d"
every_engine = pytest.mark.parametrize("engine", list(ENGINES))
DISC = [{"circle": 0.5}]


@pytest.fixture(autouse=True)
def _without_box2d(request: pytest.FixtureRequest) -> None:
    if BOX2D in getattr(getattr(request.node, "callspec", None), "params", {}).values():
        pytest.importorskip("pyb2d3")


def after(engine: str, steps: int, *names: str, **fields: Any) -> list[Pose]:
    """Where bodies of a scene are after so many steps."""
    contestant = ENGINES[engine](Course(sandbox.Scene(**fields), ""), False)
    for _ in range(steps):
        contestant.step()
    return contestant.poses(names)


def angle(pose: Pose) -> float:
    return math.atan2(pose.sin, pose.cos)


@every_engine
def test_a_throw(engine: str) -> None:
    bodies = [{"id": "ball", "shapes": DISC, "velocity": [3, 4], "angular_velocity": 90}]
    (ball,) = after(engine, 60, "ball", bodies=bodies, gravity=[0, -10])
    assert ball[:2] == pytest.approx((3.0, -1.0), abs=0.1)
    assert (ball.velocity_x, ball.velocity_y) == pytest.approx((3.0, -6.0), abs=1e-3)
    assert ball.spin == pytest.approx(math.pi / 2)
    assert angle(ball) == pytest.approx(math.pi / 2, abs=2e-3)


@every_engine
def test_every_kind_of_shape_lands_on_ground_and_chain(engine: str) -> None:
    shapes: list[dict[str, Any]] = [
        {"circle": 0.5},
        {"box": [1, 1], "radius": 0.1},
        {"capsule": [[-1, 0], [1, 0]], "radius": 0.5},
        {"polygon": [[-1, -0.5], [1, -0.5], [0, 1]]},
        {"polygon": [[0.5 * math.cos(0.1 * k * math.pi), 0.5 * math.sin(0.1 * k * math.pi)] for k in range(20)]},
    ]
    bodies: list[dict[str, Any]] = [
        {"id": "ground", "type": "static", "shapes": [{"box": [20, 1]}], "position": [0, -0.5]},
        {"id": "hills", "type": "static", "shapes": [{"chain": [[20, 0], [30, 0], [40, 0]], "one_sided": True}]},
    ]
    names = [f"body-{place}-{k}" for place in (0, 30) for k in range(len(shapes))]
    for name in names:
        place, k = map(int, name.split("-")[1:])
        bodies.append({"id": name, "position": [place - 8 + 4 * k, 1.2], "shapes": [shapes[k]]})
    for pose in after(engine, 120, *names, bodies=bodies):
        assert 0.3 < pose.y < 0.75
        assert abs(pose.velocity_y) < 0.2


@every_engine
def test_a_pendulum_with_its_bodies_turned(engine: str) -> None:
    bodies = [
        {"id": "post", "type": "static", "shapes": DISC, "position": [1, 1], "angle": 30},
        {"id": "bob", "shapes": DISC, "position": [3, 1], "angle": 50},
    ]
    hinge = {"id": "hinge", "type": "revolute", "bodies": ["post", "bob"], "anchor": [1, 1]}
    (bob,) = after(engine, 40, "bob", bodies=bodies, joints=[hinge], gravity=[0, -10])
    assert math.hypot(bob.x - 1.0, bob.y - 1.0) == pytest.approx(2.0, abs=0.02)
    (ours,) = after("sandbox", 40, "bob", bodies=bodies, joints=[hinge], gravity=[0, -10])
    assert bob[:4] == pytest.approx(ours[:4], abs=0.06)


@every_engine
@pytest.mark.parametrize(
    ("fields", "low", "high"),
    [
        ({"motor_speed": 90}, 88, 92),
        ({"motor_speed": 90, "max_torque": 1, "upper": 30}, 29, 32),
        ({"hertz": 4, "damping_ratio": 1, "rest": -20}, -21, -19),
    ],
)
def test_motor_limit_and_spring_of_a_hinge_count_from_the_start(
    engine: str, fields: dict[str, float], low: float, high: float
) -> None:
    bodies = [{"id": "wheel", "shapes": [{"box": [2, 1]}], "angle": 20, "sleep_speed": 0}]
    hinge = {"id": "hinge", "type": "revolute", "bodies": [None, "wheel"], "anchor": [0, 0], **fields}
    (wheel,) = after(engine, 60, "wheel", bodies=bodies, joints=[hinge], gravity=[0, 0])
    assert low < math.degrees(angle(wheel)) - 20.0 < high


@every_engine
def test_rods_ropes_and_welds(engine: str) -> None:
    bodies = [{"id": name, "shapes": DISC, "position": [x, 0]} for name, x in (("rod", 2), ("rope", 12), ("weld", 22))]
    joints = [
        {"id": "rod", "type": "distance", "bodies": [None, "rod"], "anchors": [[0, 0], [2, 0]]},
        {"id": "rope", "type": "distance", "bodies": [None, "rope"], "anchors": [[10, 0], [12, 0]], "max": 3},
        {"id": "weld", "type": "weld", "bodies": [None, "weld"], "anchor": [20, 0]},
    ]
    rod, rope, weld = after(engine, 45, "rod", "rope", "weld", bodies=bodies, joints=joints)
    assert math.hypot(rod.x, rod.y) == pytest.approx(2.0, abs=0.02)
    assert math.hypot(rope.x - 10.0, rope.y) < 3.1
    assert rope.y < -1.0
    assert weld[:2] == pytest.approx((22.0, 0.0), abs=0.05)


def pose_after(engine: str, steps: int, name: str, done: dict[int, list[sandbox.Command]], scene: sandbox.Scene) -> Any:
    """The pose of a body after so many steps, before which commands are done."""
    from sandbox.bench.drivers import DRIVERS, Driver

    DRIVERS["a test"] = Driver(commands=lambda step: done.get(step, ()))
    try:
        course = Course(scene, "a test")
        contestant = ENGINES[engine](course, False)
        for step in range(steps):
            change = course.change(step)
            if change is not None:
                contestant.apply(change)
            contestant.step()
    finally:
        del DRIVERS["a test"]
    (pose,) = contestant.poses([name])
    return pose


@every_engine
def test_who_goes_and_comes(engine: str) -> None:
    done = {1: [sandbox.Delete("old"), sandbox.Spawn({"id": "new", "shapes": DISC, "position": [5, 5]})],
            2: [sandbox.SetVelocity("new", (7.0, 0.0), 1.0)]}  # fmt: skip
    scene = sandbox.Scene(bodies=[{"id": "old", "shapes": DISC}], gravity=[0, 0], settings={"sleeping": False})
    new = pose_after(engine, 3, "new", done, scene)
    assert (new.x, new.y, new.velocity_x, new.spin) == pytest.approx((5.0 + 7.0 / 60.0, 5.0, 7.0, 1.0))


@every_engine
def test_what_is_on_a_path_is_where_the_path_says(engine: str) -> None:
    """A lift that goes up and down and takes a crate along, a door that turns and stays, one that waits, and one that
    comes as it is under way."""
    ways: dict[str, dict[str, Any]] = {
        "lift": {"to": [[0, 2]], "speed": 2, "mode": "ping-pong", "easing": "smooth"},
        "door": {"to": [[0, 0]], "turn": [270], "times": [0.5]},
        "gate": {"to": [[5, 0]], "times": [1], "enabled": False},
        "late": {"to": [[3, 0], [0, 3]], "times": [1, 2, 3], "mode": "loop", "time": 1.75},
    }
    bodies: list[dict[str, Any]] = [
        {"id": name, "type": "kinematic", "position": [10 * k, 0], "angle": 30 * (k == 1), "path": way,
         "shapes": [{"box": [2, 0.5]}]}
        for k, (name, way) in enumerate(ways.items())
    ]  # fmt: skip
    crate = {"id": "crate", "position": [0, 0.75], "shapes": [{"box": [1, 1]}]}
    for steps in (1, 30, 85):
        here, ours = (after(each, steps, *ways, "crate", bodies=[*bodies, crate]) for each in (engine, "sandbox"))
        for one, other in zip(here[:-1], ours[:-1], strict=True):
            assert one[:4] == pytest.approx(other[:4], abs=1e-3)
            assert one[4:] == pytest.approx(other[4:], abs=0.02)
        assert here[-1][:2] == pytest.approx(ours[-1][:2], abs=0.05)


@every_engine
def test_who_is_on_a_path_may_go_and_come(engine: str) -> None:
    cart = {"type": "kinematic", "shapes": DISC, "path": {"to": [[4, 0]], "times": [1]}}
    done = {10: [sandbox.Delete("old"), sandbox.Spawn({"id": "new", **cart, "position": [0, 5]})]}
    new = pose_after(engine, 40, "new", done, sandbox.Scene(bodies=[{"id": "old", **cart}]))
    assert new[:2] == pytest.approx((2.0, 5.0), abs=1e-5)


@pytest.mark.parametrize(("engine", "count"), [("sandbox", 0), ("pymunk", 5), ("box2d", 6)])
def test_what_an_engine_leaves_out_is_told(engine: str, count: int) -> None:
    fields: dict[str, Any] = {
        "bodies": [
            {"id": "a", "shapes": DISC, "mass": 3, "thrusters": [{"force": [0, 1]}]},
            {"id": "shelf", "type": "static", "shapes": [{"box": [2, 1], "one_way": [0, 1]}], "position": [9, 9]},
        ],
        "joints": [
            {"id": "push", "type": "target", "bodies": ["a"], "anchor": [0, 0], "target": [1, 0]},
            {"id": "bent", "type": "revolute", "bodies": [None, "a"], "anchor": [0, 0], "hertz": 2, "rest": 30},
        ],
        "regions": [{"wind": [1, 0]}],
        "rules": [{"when": {"time": 9}, "do": [{"delete": "a"}]}],
    }
    notes = ENGINES[engine](Course(sandbox.Scene(**fields), ""), False).notes
    assert len(notes) == count
    assert ("joints of the kind target are left out" in notes) == (count > 0)


@every_engine
def test_bodies_have_the_masses_that_the_scene_gives_them(engine: str) -> None:
    """Discs of 1 and 3 kg meet and stay together; a bar of twice the moment of inertia is turned half as fast."""
    discs = [
        {"id": "light", "shapes": DISC, "position": [-1, 0], "velocity": [4, 0], "mass": 1, "inertia": 7},
        {"id": "heavy", "shapes": DISC, "position": [1, 0], "mass": 3, "center": [0.1, 0]},
    ]
    light, heavy = after(engine, 60, "light", "heavy", bodies=discs, gravity=[0, 0])
    assert (light.velocity_x, heavy.velocity_x) == pytest.approx((1.0, 1.0), abs=0.02)
    bar = {"shapes": [{"box": [2, 0.2]}], "angle": 20, "position": [0, 0]}
    spins = []
    for inertia in (1.0, 2.0):
        motor = {
            "id": "m",
            "type": "revolute",
            "bodies": ["bar"],
            "anchor": [0, 0],
            "motor_speed": 1e4,
            "max_torque": 1,
        }
        bodies = [{"id": "bar", **bar, "mass": 1, "inertia": inertia}]
        (turned,) = after(engine, 6, "bar", bodies=bodies, joints=[motor], gravity=[0, 0])
        spins.append(turned.spin)
    assert spins == pytest.approx([0.1, 0.05], rel=0.02)


def two_discs(joined: bool) -> sandbox.World:
    bodies = [{"id": name, "shapes": DISC, "position": [x, 0]} for name, x in (("a", 0), ("b", 0.75), ("c", 9))]
    rod = {"id": "rod", "type": "distance", "bodies": ["a", "b"], "anchors": [[0, 0], [0.75, 0]]}
    return sandbox.World(sandbox.Scene(bodies=bodies, joints=[rod] if joined else []))


@pytest.mark.parametrize(("joined", "depth", "pairs"), [(False, 0.25, 1), (True, 0.0, 0)])
def test_the_judge_sees_overlap_energy_and_who_has_escaped(joined: bool, depth: float, pairs: int) -> None:
    world = two_discs(joined)
    poses = [Pose(x, 0.0, 1.0, 0.0, speed, 0.0, 0.0) for x, speed in ((0.0, 2.0), (0.75, 0.0), (9.0, 0.0))]
    seen = Judge(world.state, (-1.0, -1.0, 5.0, 1.0)).judge(poses)
    assert seen.deepest == pytest.approx(depth)
    assert seen.overlapping == pairs
    assert seen.kinetic == pytest.approx(0.5 * world.body("a").mass * 4.0)
    assert (seen.escaped, seen.lost) == (1, 0)


def test_the_judge_survives_numbers_that_are_none() -> None:
    poses = [Pose(math.nan, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0)] * 2 + [Pose(9.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0)]
    seen = Judge(two_discs(False).state, (-1.0, -1.0, 50.0, 1.0)).judge(poses)
    assert (seen.lost, seen.escaped, seen.overlapping) == (2, 2, 0)
    assert math.isfinite(seen.kinetic)


def test_a_profile_changes_no_bit_and_times_every_part() -> None:
    scene = two_discs(True).scene
    plain, timed = Ours(Course(scene, "")), Ours(Course(scene, ""), profile=True)
    for _ in range(5):
        plain.step()
        timed.step()
    assert plain.world.digest() == timed.world.digest()
    assert timed.stages is not None
    assert plain.stages is None
    assert timed.stages.counts == dict.fromkeys(("collide", "begin", "solve", "finish"), 5)


def test_pymunk_lets_go_of_all_contacts_when_it_is_closed() -> None:
    bodies = [{"id": f"disc-{k}", "shapes": DISC, "position": [0.01 * k, 0]} for k in range(20)]
    run = PymunkRun(sandbox.Scene(bodies=bodies).flatten())
    touching: list[object] = []
    run.step()
    for close in (False, True):
        if close:
            run.close()
        for body in run._space.bodies:
            body.each_arbiter(touching.append)
        assert (len(touching) > 100) != close
        touching.clear()


def test_bodies_that_hold_each_other_leave_pymunk_one_after_the_other() -> None:
    """Also while garbage collection waits, as in a race: then a body knows constraints that have gone."""
    bodies = [{"id": f"disc-{k}", "shapes": DISC, "position": [2 * k, 0]} for k in range(3)]
    joints = [
        {"id": f"weld-{k}", "type": "weld", "bodies": [f"disc-{k}", f"disc-{k + 1}"], "anchor": [2 * k + 1, 0]}
        for k in range(2)
    ]
    run = PymunkRun(sandbox.Scene(bodies=bodies, joints=joints).flatten())
    gc.disable()
    try:
        run.remove(["disc-1"])
        run.remove(["disc-0", "disc-2"])
    finally:
        gc.enable()
    assert (len(run._space.bodies), len(run._space.constraints)) == (0, 0)
    run.step()


def test_what_is_changed_between_steps_is_timed_beside_the_turns() -> None:
    scene = sandbox.load_scene(find_scene(Path("pymunk-tumbler")))
    driven, left = (run_race(Course(scene, name), ["sandbox"], 6, True) for name in ("pymunk-tumbler", "another"))
    assert (driven.bodies, left.bodies) == (6, 1)
    (one,), (other,) = driven.results, left.results
    assert 0.0 < one.changes * 5.0 <= sum(one.turns) * 1.001
    assert other.changes == 0.0
    assert one.own is not None
    assert one.own.stages.keys() >= {"collide", "solve"}


def test_tables_are_counted_once() -> None:
    world = two_discs(False)
    own = sum(table.nbytes for table in world.state.arrays)
    assert own < table_bytes(world) < 50 * own + 2**24


def test_a_race_of_many_turns_ends_as_a_run_of_our_own() -> None:
    scene = two_discs(True).scene
    heard: list[int] = []
    race = run_race(Course(scene, ""), ["pymunk", "sandbox"], 24, False, heard.append)
    world = sandbox.World(scene)
    world.step(24)
    pymunk, ours = race.results
    assert ours.own is not None
    assert ours.own.digest == world.digest()
    assert [len(each.turns) for each in race.results] == [10, 10]
    assert heard[-1] == 24
    assert (race.steps, race.bodies, race.shapes, race.joints) == (24, 3, 3, 1)
    assert ours.ratio == 1.0
    assert pymunk.own is None


def test_a_race_in_which_rules_bring_and_take_bodies() -> None:
    """Those are judged of whom every engine knows."""
    bodies = [{"id": name, "shapes": DISC, "position": [3.0 * k, 0]} for k, name in enumerate("abc")]
    rules = [
        {"when": {"every": 0.1}, "do": [{"spawn": {"id": "new", "shapes": DISC, "position": [0, 9]}}]},
        {"when": {"time": 0.05}, "do": [{"delete": "b"}]},
    ]
    race = run_race(Course(sandbox.Scene(bodies=bodies, rules=rules), ""), ["sandbox", "pymunk"], 12, False)
    ours, pymunk = race.results
    assert race.bodies > 2
    assert ours.quality.kinetic == pytest.approx(pymunk.quality.kinetic, rel=0.2)
    assert "rules are left out" in pymunk.notes


def test_sensors_of_box2d_feel_what_is_in_them() -> None:
    pytest.importorskip("pyb2d3")
    eye = {"id": "eye", "type": "static", "shapes": [{"circle": 1.0, "sensor": True}]}
    run = Box2dRun(sandbox.Scene(bodies=[eye, {"id": "it", "position": [0.5, 0.0], "shapes": DISC}]).flatten())
    run.step()
    assert run._world.get_sensor_events().begin_count == 1
