"""Bodies and joints that come and go: the others do not notice, and what comes is as if it had always been there."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import sandbox
from sandbox import Delete, DeleteJoint, SetPose, Spawn, StartDrag
from sandbox.engine.queries.filter import Filter
from sandbox.engine.world import World
from sandbox.errors import CommandError, UnknownBodyError, UnknownJointError
from sandbox.geometry.shapes import Circle
from sandbox.world.records import TABLES
from tests.flat import body, box, ground, scene

GROUND: dict[str, Any] = {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]}
CONCAVE = [[0, 0], [2, 0], [2, 2], [1, 0.5], [0, 2]]
ZOO: list[dict[str, Any]] = [
    GROUND,
    {"id": "tile", "type": "static", "shapes": [{"box": [4, 1]}], "position": [22, -0.5]},
    {"id": "hills", "type": "static", "shapes": [{"chain": [[-30, 0], [-25, 1], [-20, 0]]}]},
    {"id": "dent", "shapes": [{"polygon": CONCAVE}], "position": [-4, 3], "velocity": [1, 0]},
    {"id": "crate", "prefab": "crate", "position": [0, 2], "angle": 20},
    {"id": "goal", "type": "static", "shapes": [{"box": [2, 2], "sensor": True}], "position": [0, 1]},
    {"id": "paddle", "type": "kinematic", "shapes": [{"box": [3, 0.2]}], "position": [5, 2], "angular_velocity": 90},
    {"id": "rocket", "prefab": "crate", "position": [9, 1], "thrusters": [{"force": [0, 30], "end": 1}]},
    {"id": "bob", "shapes": [{"circle": 0.3}], "position": [13, 3]},
    {"id": "weight", "shapes": [{"circle": 0.4}], "position": [16, 3]},
]
JOINTS: list[dict[str, Any]] = [
    {"id": "rod", "type": "distance", "bodies": [None, "bob"], "anchors": [[12, 5], [13, 3]]},
    {"id": "hinge", "type": "revolute", "bodies": ["ground", "weight"], "anchor": [15, 3], "motor_speed": 60},
    {"id": "pin", "type": "revolute", "bodies": ["bob"], "anchor": [13, 3]},
    {"id": "cogs", "type": "gear", "joints": ["hinge", "pin"], "ratio": 2},
]
PREFABS = {"crate": {"shapes": [{"box": [1, 1], "friction": 0.4}], "color": "#c08040"}}


def make(bodies: list[dict[str, Any]], joints: list[dict[str, Any]]) -> World:
    """A world of those bodies and joints."""
    return World(sandbox.Scene(prefabs=PREFABS, bodies=bodies, joints=joints))


def tables(world: World) -> dict[str, Any]:
    """Every table in use, as plain arrays."""
    arrays = zip(TABLES, world.state.arrays, strict=True)
    found = {table.name: np.asarray(array).copy() for table, array in arrays}
    found["contact"] = found["contact"][: len(world.contacts)]
    return found


def same(one: World, two: World) -> None:
    """Both worlds have the same rows, whatever way led there."""
    first, second = tables(one), tables(two)
    for name in first:
        assert first[name].tobytes() == second[name].tobytes(), name
    assert (one.names, one.joint_names) == (two.names, two.joint_names)
    assert [body.shapes for body in one.flat.bodies] == [body.shapes for body in two.flat.bodies]


@pytest.mark.parametrize("asked_before", [True, False])
def test_those_with_a_number_are_counted_as_they_come_and_go(asked_before):
    world = make([GROUND], [])
    if asked_before:
        assert world.state.census.bodies.numbered("a") == 0
    names = ["a-1", "a-2", "a-b-1", "a-b", "a", "a-x", "a-1-3", "b-2"]
    world.apply(Spawn([{"id": name, "prefab": "crate", "position": [3 * k, 9]} for k, name in enumerate(names)]))
    world.apply(Delete(["a-2", "a", "a-b"]))
    world.apply(Spawn({"id": "a-007", "prefab": "crate", "position": [0, 19]}))
    assert [world.state.census.bodies.numbered(name) for name in ("a", "a-b", "a-1", "b", "ground")] == [2, 1, 1, 1, 0]


def test_a_world_that_is_spawned_is_the_world_of_the_scene():
    spawned = make([], [])
    spawned.apply(Spawn(ZOO, JOINTS))
    written = make(ZOO, JOINTS)
    same(spawned, written)
    for _ in range(90):
        spawned.step()
        written.step()
        assert spawned.digest() == written.digest()
    same(spawned, written)
    assert [*spawned.events] == [*written.events]
    assert spawned.sensed == written.sensed


def test_one_by_one_is_all_at_once():
    spawned = make([], [])
    for each in ZOO:
        spawned.apply(Spawn(each))
    for each in JOINTS:
        spawned.apply(Spawn(joints=each))
    same(spawned, make(ZOO, JOINTS))


@pytest.mark.parametrize("name", [each["id"] for each in ZOO])
def test_a_world_without_a_body_is_one_that_never_had_it(name):
    world = make(ZOO, JOINTS)
    world.apply(Delete(name))
    left = [each for each in JOINTS if name not in each.get("bodies", ())]
    left = [each for each in left if set(each.get("joints", ())) <= {other["id"] for other in left}]
    never = make([each for each in ZOO if each["id"] != name], left)
    same(world, never)
    world.step(60)
    never.step(60)
    assert world.digest() == never.digest()


def test_what_comes_and_goes_leaves_nothing_behind():
    world, quiet = make(ZOO, JOINTS), make(ZOO, JOINTS)
    for step in range(40):
        extra = [{"id": "extra", "prefab": "crate", "position": [30, 30]}, {**GROUND, "id": "far", "position": [90, 0]}]
        world.apply(Spawn(extra, {"id": "tie", "type": "weld", "bodies": ["extra", "far"], "anchor": [50, 0]}))
        world.apply(Delete(("far", "extra")))
        world.step()
        quiet.step()
        # Rows are the same; only commands make the engine look at piles anew.
        world.state.counters["substep_watch"] = quiet.state.counters["substep_watch"]
        assert world.digest() == quiet.digest(), step


def test_the_others_keep_every_bit():
    world = make(ZOO, JOINTS)
    world.step(50)
    before = tables(world)
    gone = world.names.index("goal")
    world.apply(Delete("goal"))
    after = tables(world)
    assert np.delete(before["body"], gone).tobytes() == after["body"].tobytes()
    # What touched the sensor's body is nothing, so all contacts are there, with their impulses.
    for name in ("normal_impulse1", "tangent_impulse1", "feature1", "separation1", "touching"):
        assert (before["contact"][name] == after["contact"][name]).all()
    assert (before["joint"]["impulse_0"] == after["joint"]["impulse_0"]).all()
    assert sorted(zip(world.contacts.shape_a, world.contacts.shape_b, strict=True)) == [
        *zip(world.contacts.shape_a, world.contacts.shape_b, strict=True)
    ]


def test_a_spawn_does_not_disturb_what_is_there():
    world = make(ZOO, JOINTS)
    world.step(50)
    before = tables(world)
    world.apply(Spawn({"id": "late", "prefab": "crate", "position": [0, 9]}))
    after = tables(world)
    assert after["body"][:-1].tobytes() == before["body"].tobytes()
    for name in ("contact", "joint", "drag", "thruster", "settings"):
        assert after[name].tobytes() == before[name].tobytes()


def tower(count: int = 4) -> World:
    """Crates one on another, asleep."""
    crates = [body(f"crate-{k}", box(1.0, 1.0), position=(0.0, 0.5 + k)) for k in range(count)]
    world = World(scene(ground(), *crates, settings=sandbox.Scene().flatten().settings))
    world.step(200)
    assert world.awake_count == 0
    return world


def test_what_rested_on_a_deleted_body_wakes_and_falls():
    world = tower()
    world.apply(Delete("crate-1"))
    assert world.awake_count == 3
    world.step(120)
    assert world.body("crate-2").position[1] == pytest.approx(1.5, abs=0.01)
    world.apply(Delete("ground"))
    world.step(30)
    assert all(world.body(name).position[1] < -0.5 + k for k, name in enumerate(world.names))


def test_what_rests_stays_where_it_is_when_a_body_without_shapes_goes():
    boxes = [body(f"b{k}", box(1.0, 1.0), position=(0.0, 0.5 + k)) for k in range(2)]
    w = World(scene(body("nothing", type="static"), ground(), *boxes))
    w.step(5)
    w.apply(Delete("nothing"))
    assert w.contacts.body_a.tolist() == [0, 1]
    assert w.contacts.body_b.tolist() == [1, 2]
    w.step(60)
    assert w.body("b1").position == pytest.approx((0.0, 1.5), abs=1e-6)


def test_only_the_island_of_a_deleted_body_wakes():
    crates = [body(f"crate-{k}", box(1.0, 1.0), position=(3.0 * k, 0.5)) for k in range(4)]
    world = World(scene(ground(), *crates, settings=sandbox.Scene().flatten().settings))
    world.step(200)
    world.apply(Delete("crate-1"))
    assert world.awake_count == 0
    world.step(5)
    assert world.awake_count == 0
    # Islands are known by rows, and rows have moved.
    world.apply(SetPose("crate-2", (6.0, 3.0), 0.0))
    assert [world.body(f"crate-{k}").awake for k in (0, 2, 3)] == [False, True, False]


@pytest.mark.parametrize("kind", ["static", "kinematic", "dynamic"])
def test_sleepers_notice_what_appears_among_them(kind):
    world = tower()
    wedge = {"id": "wedge", "type": kind, "shapes": [{"box": [0.5, 0.5]}], "position": [0.6, 1.4]}
    world.apply(Spawn(wedge))
    world.step()
    assert world.awake_count >= 4


def test_what_hung_from_a_deleted_body_or_joint_wakes_and_falls():
    sign = {"id": "sign", "shapes": [{"box": [1, 1]}], "position": [0, 5]}
    post = {"id": "post", "type": "static", "shapes": [{"box": [1, 1]}], "position": [0, 8]}
    weld = {"id": "weld", "type": "weld", "bodies": ["post", "sign"], "anchor": [0, 6]}
    for command in (Delete("post"), DeleteJoint("weld")):
        world = make([post, sign], [weld])
        world.step(120)
        assert world.awake_count == 0
        world.apply(command)
        assert world.joint_names == ()
        world.step(30)
        assert world.body("sign").position[1] < 4.0


def test_a_gear_goes_with_a_joint_that_it_couples():
    world = make(ZOO, JOINTS)
    world.step(20)
    world.apply(DeleteJoint("pin"))
    assert world.joint_names == ("rod", "hinge")
    world.apply(Delete("weight"))
    assert world.joint_names == ("rod",)
    world.step(20)


def test_a_gear_that_comes_late_keeps_what_it_finds():
    world = make(ZOO, JOINTS[:3])
    world.step(47)
    angles = [world.joint(name).angle for name in ("hinge", "pin")]
    assert abs(angles[0]) > 0.5
    world.apply(Spawn(joints=JOINTS[3]))
    world.step(60)
    now = [world.joint(name).angle for name in ("hinge", "pin")]
    assert now[0] + 2 * now[1] == pytest.approx(angles[0] + 2 * angles[1], abs=1e-3)


def test_joints_hold_where_things_are_now():
    world = make([GROUND, {"id": "crate", "prefab": "crate", "position": [0, 9]}], [])
    world.step(30)
    x, y = world.body("crate").position
    world.apply(Spawn(joints={"id": "hook", "type": "revolute", "bodies": ["crate"], "anchor": [x + 0.5, y + 0.5]}))
    world.step(30)
    anchors = world.joint("hook").anchors
    assert np.hypot(*np.subtract(*anchors)) < 1e-3
    assert abs(world.joint("hook").angle) > 0.05


def test_thrusters_of_what_is_spawned_count_from_then():
    world = make([], [])
    world.step(100)
    world.apply(Spawn({"id": "r", "prefab": "crate", "thrusters": [{"force": [0, 30], "start": 0.5, "end": 1}]}))
    speeds = []
    for _ in range(70):
        world.step()
        speeds.append(world.body("r").velocity[1])
    assert np.flatnonzero(np.diff(speeds) > 0)[[0, -1]].tolist() == [29, 58]


def test_a_drag_ends_with_its_body_and_stays_with_others():
    world = make(ZOO, JOINTS)
    for name in ("dent", "crate"):
        world.apply(StartDrag(name, world.body(name).position))
    world.apply(Delete("dent"))
    assert [world.names[row] for row in world.state.drags.body if row >= 0] == ["crate"]


def test_a_held_body_stays_that_body():
    world = make(ZOO, JOINTS)
    crate, dent, hinge, rod = world.body("crate"), world.body("dent"), world.joint("hinge"), world.joint("rod")
    bodies, saved = world.bodies, world.snapshot()
    place = crate.position
    world.apply(Delete(["dent", "bob"]))
    assert crate.position == place
    assert tuple(bodies.position[bodies.ids.index("crate")]) == place
    assert len(bodies) == len(ZOO) - 2
    assert hinge.motor_speed == pytest.approx(np.pi / 3)
    world.apply(Spawn({"id": "dent", "prefab": "crate"}))
    for ask in (lambda: dent.position, lambda: dent.apply_force((1.0, 0.0)), lambda: setattr(dent, "angle", 1.0)):
        with pytest.raises(UnknownBodyError, match="the body 'dent' has been deleted"):
            ask()
    with pytest.raises(UnknownJointError, match="the joint 'rod' has been deleted"):
        _ = rod.force
    crate.velocity = (1.0, 2.0)
    world.step()
    assert crate.velocity != (0.0, 0.0)
    world.restore(saved)
    assert dent.position == (-4.0, 3.0)
    assert rod.enabled


def test_queries_and_sensors_follow():
    world = make(ZOO, JOINTS)
    assert world.query.ray((0, 9), (0, -20)).body == "crate"
    world.step(40)
    assert world.sensed == (("goal", "crate"),)
    world.apply(Delete("dent"))
    assert world.sensed == (("goal", "crate"),)
    assert world.query.ray((0, 9), (0, -20)).body in ("crate", "goal")
    world.apply(Spawn({"id": "lid", "type": "static", "shapes": [{"box": [2, 0.1]}], "position": [0, 7]}))
    assert world.query.ray((0, 9), (0, -20)).body == "lid"
    assert world.query.ray((0, 9), (0, -20), Filter(exclude=("lid",))).body != "lid"
    assert [hit.body for hit in world.query.overlap_shape(Circle((0, 7), 0.2))] == ["lid"]
    world.apply(Delete(["goal", "lid"]))
    assert world.sensed == ()
    world.step()
    world.apply(Spawn({"id": "net", "type": "static", "shapes": [{"box": [40, 9], "sensor": True}]}))
    world.step()
    assert ("net", "crate") in world.sensed
    assert {event["sensor"] for event in world.events if event["event"] == "enter"} == {"net"}


def test_the_events_of_the_last_step_stay():
    world = make([GROUND, {"id": "ball", "shapes": [{"circle": 0.5}], "position": [0, 0.6], "velocity": [0, -5]}], [])
    while not len(world.events.hit):
        world.step()
    told = [*world.events]
    count, impulses = len(world.contacts), world.contact_impulses
    world.apply(Spawn({"id": "late", "shapes": [{"circle": 1}], "position": [9, 9]}))
    assert [*world.events] == told
    assert (len(world.contacts), world.contact_impulses.tolist()) == (count, impulses.tolist())
    world.apply(Delete("ground"))
    assert [*world.events] == told
    assert len(world.contacts) == len(world.contact_impulses) == 0
    world.step()
    assert [(event["event"], event["a"], event["b"]) for event in world.events] == [("end", "ground", "ball")]
    world.step()
    assert [*world.events] == []


def test_what_a_deleted_body_touched_ends_in_the_next_step():
    crate = {"shapes": [{"box": [1, 1]}]}
    area = {"id": "area", "type": "static", "shapes": [{"circle": 0.1}, {"box": [6, 9], "sensor": True}]}
    world = make([GROUND, area, *({**crate, "id": f"c{k}", "position": [0, 0.5 + k]} for k in range(3))], [])
    world.apply(SetPose("area", (-2.9, 5.0), 0.0))
    world.step(30)
    before = list(world.events)
    world.apply(Delete("c1"))
    world.apply(Spawn({**crate, "id": "c1", "position": [9, 0.4]}))
    world.apply(Delete("c2"))
    assert list(world.events) == before
    world.step()
    told = [
        (event["event"], event.get("a", event.get("sensor")), event.get("b", event.get("body")))
        for event in world.events if event["event"] not in ("wake", "sleep")
    ]  # fmt: skip
    assert told == [
        ("begin", "ground", "c1"), ("end", "c0", "c1"), ("end", "c1", "c2"), ("leave", "area", "c1"),
        ("leave", "area", "c2"),
    ]  # fmt: skip
    first, second = world.events.end
    assert world.events.names == (*world.names, "c1", "c2")
    assert (first.body_a, first.shape_a, first.shape_b) == (2, 3, -1)
    assert (first.x, first.y, first.normal_y) == pytest.approx((0.0, 1.0, 1.0), abs=1e-3)
    assert (second.body_a, second.body_b, second.shape_a, second.shape_b) == (4, 5, -1, -1)
    assert [(row.sensor, row.shape_index) for row in world.events.leave] == [(2, -1)] * 2
    world.apply(Delete("area"))
    world.step()
    assert [(event["event"], event["sensor"], event["body"]) for event in world.events] == [("leave", "area", "c0")]
    world.step()
    assert len(world.events) == 0


def test_a_restore_forgets_what_was_deleted():
    world = make([GROUND, {"id": "ball", "shapes": [{"circle": 0.5}], "position": [0, 0.5]}], [])
    world.step(2)
    saved = world.snapshot()
    world.apply(Delete("ball"))
    world.restore(saved)
    world.step()
    assert len(world.events) == 0


def test_tiles_are_joined_anew():
    tile = {"type": "static", "shapes": [{"box": [1, 1]}]}
    tiles = [{**tile, "id": f"t{k}", "position": [k, -0.5]} for k in range(20)]
    puck = {"id": "puck", "shapes": [{"box": [0.5, 0.2], "friction": 0}], "position": [1, 0.1], "velocity": [6, 0]}
    world = make([*tiles[:8], *tiles[9:], puck], [])
    world.apply(Spawn(tiles[8]))
    world.step(120)
    assert world.body("puck").velocity == pytest.approx((6.0, 0.0), abs=1e-3)
    world.apply(Delete("t19"))
    assert world.names[-1] == "t8"


REFUSED = [
    (Spawn({"id": "crate", "prefab": "crate"}), 'the id "crate" is taken by a body of the world (at /bodies/0/id)'),
    (Spawn([{"id": "a", "prefab": "crate"}] * 2), 'the id "a" is taken by bodies[0] (at /bodies/1/id)'),
    (Spawn({"id": "a", "prefab": "crat"}), 'no prefab is named "crat" (at /bodies/0/prefab) did you mean "crate"?'),
    (Spawn({"id": "a", "shpaes": []}), 'unknown field "shpaes" (at /bodies/0/shpaes) did you mean "shapes"?'),
    (
        Spawn({"id": "a", "shapes": [{"box": [1, -1]}]}),
        "box[1] must not be below 1e-06 m (at /bodies/0/shapes/0/box/1)",
    ),
    (Spawn({"id": "a", "prefab": "crate", "position": [float("nan"), 0]}), "position[0] must be a finite number"),
    (Spawn({"id": "a", "prefab": "crate", "mass": "heavy"}), "mass must be a number, not text (at /bodies/0/mass)"),
    (Spawn({"id": "a", "shapes": [{"segment": [[0, 0], [1, 0]]}]}), "a dynamic body without mass"),
    (Spawn({1: 2}), "Keys should be strings (at /bodies/0/1)"),
    (Spawn([3]), "bodies[0] must be an object"),
    (Spawn("crate"), "bodies must be a list of bodies, not text"),
    (Spawn(), "there is nothing to spawn"),
    (Spawn(joints={"id": "j", "type": "weld", "bodies": ["crat"], "anchor": [0, 0]}), 'did you mean "crate"?'),
    (Spawn(joints={"id": "rod", "type": "weld", "bodies": ["crate"], "anchor": [0, 0]}), 'the id "rod" is taken'),
    (Spawn(joints={"id": "j", "type": "weld", "bodies": ["goal"], "anchor": [0, 0]}), "joins nothing that can move"),
    (Spawn(joints={"id": "j", "type": "gear", "joints": ["rod", "pin"]}), 'a gear cannot couple "rod"'),
    (Delete("crat"), "did you mean 'crate'?"),
    (Delete(["crate", "nobody"]), "no body 'nobody'"),
    (Delete([]), "there is nothing to delete"),
    (Delete(5), "one id or a list of ids, not 5"),
    (Delete([["crate"]]), "one id or a list of ids"),
    (DeleteJoint("hing"), "did you mean 'hinge'?"),
]


@pytest.mark.parametrize(("command", "told"), REFUSED, ids=[str(k) for k in range(len(REFUSED))])
def test_what_cannot_be_done_is_told_and_changes_nothing(command, told):
    world = make(ZOO, JOINTS)
    world.step(10)
    before, layout = world.snapshot(), world.layout
    with pytest.raises((CommandError, UnknownBodyError, UnknownJointError)) as caught:
        world.apply(command)
    assert told in str(caught.value)
    assert world.snapshot() == before
    assert (world.layout, world.names) == (layout, tuple(each["id"] for each in ZOO))


def test_a_world_of_flat_bodies_takes_them_as_well():
    world = World(scene(ground()))
    world.apply(Spawn({"id": "ball", "shapes": [{"circle": 0.5}], "position": [0, 3]}))
    world.step(60)
    assert world.body("ball").position[1] == pytest.approx(0.5, abs=0.01)


def test_commands_are_plain_data():
    command = Spawn(ZOO, JOINTS)
    again = Spawn(**json.loads(json.dumps({"bodies": command.bodies, "joints": command.joints})))
    one, two = make([], []), make([], [])
    one.apply(command)
    two.apply(again)
    same(one, two)


def test_views_of_what_is_gone_say_so():
    """A debugger shows them, and asks for no more."""
    bodies = [{"id": name, "shapes": [{"circle": 0.2}], "position": [x, 0]} for name, x in (("a", 0), ("b", 1))]
    world = World(
        sandbox.Scene(bodies=bodies, joints=[{"id": "pin", "type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0]}])
    )
    body, joint = world.body("a"), world.joint("pin")
    assert (repr(body)[:17], repr(joint)[:22]) == ("<Body 'a' dynamic", "<Joint 'pin' revolute:")
    world.apply(Delete("a"))
    assert (repr(body), repr(joint)) == ("<Body 'a', deleted>", "<Joint 'pin', deleted>")
