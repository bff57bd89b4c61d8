"""The inspector by real keys and clicks: what it shows, what it changes, and that it can be undone."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sandbox
from sandbox.render.camera import Camera
from sandbox.render.frame import capture
from sandbox.resources import find_scene
from sandbox.window.editor import kept
from sandbox.window.highlight import RING, highlight_joint
from sandbox.window.panels.inspector.finder import Found, everything, kind_of, matching
from sandbox.window.panels.inspector.surfaces import filter_text, size_text
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from sandbox.window.tools.joint_pick import joint_spans
from sandbox.window.widgets import Scale, as_written, places
from tests.window.hands import play

SCENE = sandbox.Scene(
    format=1,
    gravity=[0, 0],
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.499]},
        {"id": "wheel", "shapes": [{"circle": 0.5}], "position": [4, 3]},
        {"id": "jet", "shapes": [{"box": [1, 1]}], "position": [-4, 3], "thrusters": [{"force": [0, 2]}]},
    ],
    joints=[{"id": "hinge", "type": "revolute", "bodies": ["wheel"], "anchor": [4, 3]}],
    regions=[{"id": "pond", "water": 2, "inside": [8, 0, 12, 3]}],
)


SELECT_TWO = "click @0,0.5\nhold Shift\nclick @-4,3\nlet Shift\nwait 2\n"


def commands(screen: PlayScreen) -> list[Any]:
    return [command for _, command in screen.session.timeline.run.commands]


def test_a_dragged_number_is_one_act_in_the_recording_and_can_be_undone(canvas: Canvas, tmp_path: Path) -> None:
    seen: list[tuple[float, int]] = []

    def look(screen: PlayScreen) -> None:
        seen.append((float(screen.session.world.state.shapes.friction[1]), len(commands(screen))))

    lines = "click @0,0.5\nwait 2\ndrag inspector.friction to 1270,300\nwait 2"
    screen = play(canvas, SCENE, tmp_path, lines, look, "key Ctrl+Z\nwait 2", look)
    assert seen[0][0] > 0.6
    assert seen[0][1] == 1  # time stood still, so what was tried on the way is not recorded
    assert seen[1] == (0.5, 0)
    assert screen.workspace.selection.bodies == ("crate",)


def test_what_is_typed_goes_to_all_that_are_selected(canvas: Canvas, tmp_path: Path) -> None:
    lines = SELECT_TWO + "click inspector.restitution\nkey Ctrl+A\ntype 0.75\nkey Enter\nwait 2"
    screen = play(canvas, SCENE, tmp_path, lines)
    world = screen.session.world
    assert world.state.shapes.restitution.tolist() == [0.0, 0.75, 0.0, 0.75]
    assert [type(command).__name__ for command in commands(screen)] == ["SetSurface", "SetSurface"]
    assert screen.session.timeline.undo_label == "Restitution of 2 bodies"


def test_the_coordinate_that_is_not_touched_keeps_its_bits(canvas: Canvas, tmp_path: Path) -> None:
    places: list[tuple[float, float]] = []

    def look(screen: PlayScreen) -> None:
        places.append(screen.session.world.body("crate").position)

    play(canvas, SCENE, tmp_path, look, "click @0,0.5\nwait 2\ndrag inspector.position.x to 1270,420\nwait 2", look)
    assert places[1][0] > places[0][0] + 0.5
    assert places[1][1] == places[0][1]


def test_a_click_on_an_anchor_selects_the_joint_and_its_motor_runs(canvas: Canvas, tmp_path: Path) -> None:
    lines = "click @4,3\nwait 2\nclick inspector.motor.speed.on\nwait 2\nkey Space\nwait 30"
    screen = play(canvas, SCENE, tmp_path, lines)
    assert screen.workspace.selection.joint == "hinge"
    assert screen.session.world.body("wheel").angular_velocity == pytest.approx(math.pi / 2)
    assert type(commands(screen)[0]).__name__ == "SetMotor"


def test_limits_spring_and_what_breaks_it(canvas: Canvas, tmp_path: Path) -> None:
    names = ("inspector.limit.upper.on", "inspector.spring.hertz.on", "inspector.joint.break_force.set")
    lines = "click @4,3\nwait 2\n" + "".join(f"click {name}\nwait 2\n" for name in names)
    joint: Any = play(canvas, SCENE, tmp_path, lines).session.world.state.joints[0]
    assert (joint.limit, joint.upper, joint.lower) == (1, 0.0, -math.inf)
    assert (joint.spring, joint.hertz) == (1, 5.0)
    assert (joint.break_force, joint.break_torque) == (1000.0, math.inf)


def test_a_contact_leads_to_the_other_body(canvas: Canvas, tmp_path: Path) -> None:
    lines = "key .\nclick @0,0.5\nwait 3\nclick inspector.contact.0\nwait 2"
    screen = play(canvas, SCENE, tmp_path, lines)
    assert screen.workspace.selection.bodies == ("ground",)


def test_the_list_finds_a_region_which_is_then_changed(canvas: Canvas, tmp_path: Path) -> None:
    lines = (
        "click inspector.search\ntype pond\nwait 2\nclick inspector.find.pond\nwait 2\nclick inspector.region.enabled"
    )
    screen = play(canvas, SCENE, tmp_path, lines + "\nwait 2\ndrag inspector.region.water to 1270,300\nwait 2")
    region: Any = screen.session.world.state.regions[0]
    assert region.density > 2.0
    assert region.end_step == 1  # the step that had been taken
    assert screen.workspace.selection.region == "pond"


def test_a_thruster_is_switched_off(canvas: Canvas, tmp_path: Path) -> None:
    lines = "click @-4,3\nwait 2\nwheel -10 1100,500\nwait 3\nclick inspector.thruster.0.on\nwait 2\nkey Space\nwait 20"
    screen = play(canvas, SCENE, tmp_path, lines)
    assert screen.session.world.body("jet").velocity == pytest.approx((0.0, 2.0 / 60.0))  # of the first step
    assert type(commands(screen)[0]).__name__ == "SetThruster"


@pytest.mark.parametrize("name", ["gears-and-pulley", "cart", "wrecking-ball"])
def test_joints_of_all_kinds_are_shown(canvas: Canvas, tmp_path: Path, name: str) -> None:
    scene = sandbox.load_scene(find_scene(Path(name)))
    kinds: set[str] = set()

    def select(joint: str) -> Any:
        def run(screen: PlayScreen) -> None:
            kinds.add(screen.session.world.joint(joint).type)
            screen.workspace.selection.pick_joint(joint)

        return run

    names = sandbox.World(scene).joint_names[:8]
    shown: list[bool] = []
    acts = [act for one in names for act in (select(one), "wait 1", lambda _: shown.append(_joint_shown()))]
    play(canvas, scene, tmp_path, *acts)
    assert all(shown)
    assert kinds


def _joint_shown() -> bool:
    return "inspector.joint.enabled" in places


def test_several_bodies_move_by_the_same_way(canvas: Canvas, tmp_path: Path) -> None:
    lines = SELECT_TWO + "click inspector.position.x\nkey Ctrl+A\ntype 1\nkey Enter\nwait 2"
    world = play(canvas, SCENE, tmp_path, lines).session.world
    assert world.body("crate").position == pytest.approx((3.0, 0.5), abs=1e-3)
    assert world.body("jet").position == pytest.approx((-1.0, 3.0), abs=1e-3)


@pytest.mark.slow
def test_ten_thousand_bodies_are_listed_without_drawing_them_all(canvas: Canvas, tmp_path: Path) -> None:
    bodies = [{"id": f"b{k}", "shapes": [{"circle": 0.1}], "position": [k, 0]} for k in range(10000)]
    scene = sandbox.Scene(format=1, gravity=[0, 0], bodies=bodies)
    counts: list[int] = []
    play(canvas, scene, tmp_path, "wait 2", lambda _: counts.append(sum("inspector.find." in name for name in places)))
    assert 5 < counts[0] < 100


def test_the_list_is_filtered_by_every_word() -> None:
    found = [Found("body", "crate-1", 0), Found("body", "ball", 1), Found("joint", "crate-pin", 0)]
    assert matching(found, "Crate") == [found[0], found[2]]
    assert matching(found, "joint cra") == [found[2]]
    assert matching(found, "") == found
    world = sandbox.World(SCENE)
    assert [kind_of(world, one) for one in everything(world)] == [
        "static", "dynamic", "dynamic", "dynamic", "revolute", "water",
    ]  # fmt: skip


def test_shapes_in_words() -> None:
    shapes = [
        {"box": [2, 1]}, {"circle": 0.5}, {"segment": [[0, 0], [3, 4]]}, {"capsule": [[0, 0], [1, 0]], "radius": 0.2},
        {"polygon": [[0, 0], [1, 0], [0, 1]], "mask": 0}, {"chain": [[0, 0], [2, 0], [2, 1]]},
    ]  # fmt: skip
    world = sandbox.World(sandbox.Scene(format=1, bodies=[{"id": "a", "shapes": shapes}]))
    texts = [size_text(world.state, number) for number in range(7)]
    assert texts[:3] == ["box, 2 × 1 m", "circle, radius 0.5 m", "segment, 5 m long"]
    assert texts[3:5] == ["capsule, 1 m long, radius 0.2 m", "polygon, 3 corners"]
    assert texts[5:] == ["segment, 2 m long, link 1 of a chain", "segment, 1 m long, link 2 of a chain"]
    assert filter_text(world.state.shapes[:1]) == "with all"
    assert filter_text(world.state.shapes[4:5]) == "with nothing"


def test_numbers_of_widgets_are_told_apart_from_rounding() -> None:
    assert as_written(1.0, float(np.float32(0.3))) == 0.3
    assert as_written(1.0, float(np.float32(100010.25))) == 100010.25
    assert as_written(0.1234567890123, float(np.float32(0.1234567890123))) == 0.1234567890123
    assert kept(0.1234567890123, 0.1235, as_written(0.1235, float(np.float32(0.1235)))) == 0.1234567890123
    assert kept(1e-12, 0.0, 0.0) == 1e-12
    assert kept(2.0, 2.0, 2.1) == 2.1


@pytest.mark.parametrize(
    ("unit", "value", "shown"),
    [("°", -0.000561524, 0.0), ("°", -230.1291, -230.13), ("m/s", -0.00393, -0.004), ("m", 0.5823461, 0.5823),
     ("kg/m²", 0.00012, 0.00012), ("N", math.inf, math.inf)],
)  # fmt: skip
def test_numbers_have_the_decimals_that_a_person_makes_something_of(unit: str, value: float, shown: float) -> None:
    assert str(Scale(unit).shown(value)) == str(shown)  # no -0 either


def test_spans_of_joints_are_where_their_anchors_are() -> None:
    world = sandbox.World(sandbox.load_scene(find_scene(Path("gears-and-pulley"))))
    world.step(30)
    rows, starts, ends = joint_spans(world.state, capture(world.state))
    first = {int(row): k for k, row in reversed(list(enumerate(rows)))}
    plain = [row for row in first if world.joint(world.joint_names[row]).type not in ("pulley", "target")]
    assert plain
    for row in plain:
        a, b = world.joint(world.joint_names[row]).anchors
        assert np.allclose(starts[first[row]], a)
        assert np.allclose(ends[first[row]], b)
    assert len(rows) > len(first)  # a pulley's rope has three pieces


def test_a_selected_joint_is_ringed_where_the_picture_shows_it() -> None:
    world = sandbox.World(SCENE)
    frame, camera = capture(world.state), Camera((0.0, 0.0), 50.0, (800, 600))
    marks = highlight_joint(world.state, frame, camera, "hinge", (1.0, 0.0, 0.0))
    middle = camera.to_screen([(4.0, 3.0)])[0]
    points = marks.strokes.start
    assert np.allclose(np.hypot(*(points[1:] - middle).T), RING, atol=1e-9)
    assert len(highlight_joint(world.state, frame, camera, "gone", (1.0, 0.0, 0.0)).strokes.start) == 0


@pytest.mark.slow
def test_ten_thousand_joints_are_picked_from_in_no_time() -> None:
    count = 10_000
    bodies = [{"id": f"b{k}", "shapes": [{"circle": 0.1}], "position": [k, 0]} for k in range(count)]
    joints = [{"id": f"j{k}", "type": "weld", "bodies": [f"b{k}"], "anchor": [k, 0]} for k in range(count)]
    world = sandbox.World(sandbox.Scene(gravity=[0, 0], bodies=bodies, joints=joints))
    frame = capture(world.state)
    begin = time.process_time()
    rows, starts, _ = joint_spans(world.state, frame)
    assert time.process_time() - begin < 0.05
    assert len(rows) == count
    assert starts[1234].tolist() == [1234.0, 0.0]
