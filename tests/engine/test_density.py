"""A new density at run time: the body is as if it had been built with it, and its points move on as they did."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sandbox
from sandbox import SetSurface, StartDrag
from sandbox.errors import CommandError
from sandbox.render.frame import capture
from sandbox.world.patterns import KnownPatterns
from tests.flat import circle

COMB = [[0, 0], [4, 0], [4, 2], [3, 2], [3, 1], [1, 1], [1, 2], [0, 2]]
SHAPES = {
    "hammer": [{"box": [2, 0.2]}, {"box": [0.4, 1], "at": [1, 0], "density": 5}],
    "comb": [{"polygon": COMB}, {"circle": 0.5, "at": [2, 3], "density": 2}],
}
EXACT = {"position": [3, 4], "angle": 35, "velocity": [1, -2], "angular_velocity": 60}


def world(name="hammer", densities=(1, 5), joints=(), **body):
    """A body of two shapes in space, with a thruster, beside a sleeping crate."""
    shapes = [{**shape, "density": density} for shape, density in zip(SHAPES[name], densities, strict=True)]
    thrusters = [{"force": [0, 3], "at": [0.5, 0]}]
    bodies = [
        {"id": "far", "position": [90, 0], "shapes": [{"box": [1, 1]}]},
        {"id": "x", "shapes": shapes, "thrusters": thrusters, **EXACT, **body},
    ]
    return sandbox.World(sandbox.Scene(bodies=bodies, joints=list(joints), gravity=(0, 0)))


HINGE = {"id": "hinge", "type": "revolute", "bodies": ["far", "x"], "anchor": [4, 4], "enabled": False}


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("shape", [0, None])
@pytest.mark.parametrize("extra", [{}, {"mass": 7.0}, {"center": [0.1, 0.2]}, {"fixed_rotation": True}])
def test_it_is_as_if_it_had_been_built_so(name, shape, extra):
    w = world(name, joints=[HINGE], **extra)
    first = 3.0
    parts = int((w.state.shapes.body == 1).sum())
    for k in [None] if shape is None else range(parts - 1):  # all parts of the comb
        w.apply(SetSurface("x", density=first, shape=k))
    built = world(name, (first, first if shape is None else 5), joints=[HINGE], **extra)
    spin, (vx, vy) = built.body("x").angular_velocity, EXACT["velocity"]
    (cx, cy), (ox, oy) = built.body("x").center, world(name, **extra).body("x").center
    if name == "comb" and shape == 0:
        assert parts > 2
    for table in ("bodies", "shapes", "vertices", "outlines", "joints", "thrusters"):
        got, expected = getattr(w.state, table), getattr(built.state, table)
        for column in got.dtype.names:
            if column not in ("velocity_x", "velocity_y"):
                assert got[column] == pytest.approx(expected[column], abs=1e-13), (table, column)
    assert w.body("x").velocity == pytest.approx((vx - spin * (cy - oy), vy + spin * (cx - ox)), abs=1e-12)
    assert w.body("x").position == world(name, **extra).body("x").position


def test_every_point_goes_on_as_it_moved():
    w, other = world(), world()
    w.apply(SetSurface("x", density=40.0, shape=0))

    def velocity(of, point):
        body = of.body("x")
        (cx, cy), (vx, vy), spin = body.center, body.velocity, body.angular_velocity
        return vx - spin * (point[1] - cy), vy + spin * (point[0] - cx)

    for point in ((3.0, 4.0), (0.0, 0.0), (10.0, -7.0)):
        assert velocity(w, point) == pytest.approx(velocity(other, point), abs=1e-12)
    seen, before = capture(w.state), capture(other.state)
    for a, b in zip(seen.shape_poses(), before.shape_poses(), strict=True):
        assert a == pytest.approx(b, abs=1e-12)


def test_a_crate_that_grows_heavier_sinks():
    pool = {"water": 1, "surface": 0, "inside": [-5, -5, 5, 5]}
    cork = {"id": "cork", "shapes": [{"box": [1, 1], "density": 0.5}]}
    bed = {"id": "bed", "type": "static", "position": [0, -5], "shapes": [{"box": [10, 1]}]}
    w = sandbox.World(sandbox.Scene(bodies=[bed, cork], regions=[pool]))
    w.step(600)
    assert w.body("cork").position[1] == pytest.approx(0.0, abs=1e-3)
    assert not w.body("cork").awake
    w.apply(SetSurface("cork", density=3.0))
    w.step(600)
    assert w.body("cork").position[1] == pytest.approx(-4.0, abs=1e-2)
    assert w.body("cork").mass == pytest.approx(3.0)


def test_a_joint_and_a_drag_hold_the_same_points():
    hinge = {"id": "hinge", "type": "revolute", "bodies": ["x"], "anchor": [3.5, 4.2]}
    w = world(joints=[hinge], velocity=[0, 0], angular_velocity=0)
    w.apply(StartDrag("x", (3.3, 4.1)))
    before = w.joint("hinge").anchors
    w.apply(SetSurface("x", density=40.0, shape=0))
    assert np.ravel(w.joint("hinge").anchors) == pytest.approx(np.ravel(before), abs=1e-12)
    body, drag = w.state.bodies[1], w.state.drags[0]
    c, s = body.rotation_cos, body.rotation_sin
    held = body.center_x + c * drag.local_x - s * drag.local_y, body.center_y + s * drag.local_x + c * drag.local_y
    assert held == pytest.approx((3.3, 4.1), abs=1e-12)


def test_it_goes_with_snapshots_and_recordings(tmp_path):
    heavier = [(5, SetSurface("x", density=40.0, shape=0)), (9, SetSurface("x", density=0.5, shape=1))]
    scene = world().scene
    recording = sandbox.record(scene, 20, heavier)
    recording.save(tmp_path / "x.replay.json")
    assert sandbox.rerun(sandbox.Recording.load(tmp_path / "x.replay.json")).passed
    w, fresh = world(), world()
    w.step(5)
    early = w.snapshot()
    w.apply(heavier[0][1])
    w.step(4)
    saved = w.snapshot()
    end = []
    for each in (w, fresh):
        each.restore(early)
        assert each.body("x").mass == pytest.approx(world().body("x").mass)
        each.restore(saved)
        each.apply(heavier[1][1])
        each.step(11)
        end.append(each.digest())
    assert end == [recording.digest] * 2


def test_pictures_and_queries_see_the_shapes_where_they_are():
    w = world(velocity=[0, 0], angular_velocity=0)
    point = (3.0 + math.cos(math.radians(35.0)), 4.0 + math.sin(math.radians(35.0)))
    assert "x" in {hit.body for hit in w.query.point(point)}
    mesh, saved = capture(w.state).mesh, w.snapshot()
    w.apply(SetSurface("x", density=400.0, shape=0))
    assert "x" in {hit.body for hit in w.query.point(point)}
    assert w.query.point((0.0, 0.0)) == ()
    moved = capture(w.state, mesh)
    assert moved.mesh is not mesh
    w.restore(saved)
    back = capture(w.state, moved.mesh)
    assert back.shape_poses()[0] == pytest.approx(moved.shape_poses()[0], abs=1e-12)


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (SetSurface("x", density=-1.0), "density must not be negative"),
        (SetSurface("x", density=1e-9), "density must be 0 or at least 1e-06"),
        (SetSurface("x", density=math.nan), "density must be a finite number"),
        (SetSurface("x", density="lead"), "density must be a number"),
        (SetSurface("x", density=0.0), "a dynamic body without mass: give its shapes a density"),
        (SetSurface("x", density=1.0, shape=2), "no shape 2"),
        (SetSurface("x", friction=-1.0, density=2.0), "friction must"),
    ],
)
def test_what_cannot_be_is_told_and_changes_nothing(command, words):
    w = world()
    before = w.snapshot()
    with pytest.raises(CommandError, match=words):
        w.apply(command)
    assert w.snapshot() == before


def test_a_density_that_another_one_was_given_is_not_worked_out_again(monkeypatch):
    bodies = [{"id": name, "position": [3 * k, 0], "shapes": [{"box": [1, 2]}]} for k, name in enumerate("xy")]
    w = sandbox.World(sandbox.Scene(bodies=bodies))
    w.apply(SetSurface("x", density=2.5))
    for place in ("patterns", "body_rows"):
        monkeypatch.setattr(f"sandbox.world.{place}.build_patterns", lambda *_: pytest.fail("worked out again"))
    w.apply(SetSurface("y", density=2.5))
    assert w.body("x").mass == w.body("y").mass == 5.0


def test_shapes_that_differ_in_the_sign_of_a_zero_are_not_taken_for_each_other():
    patterns = KnownPatterns()
    one, two = ((circle(0.5, (x, 0.0)),) for x in (0.0, -0.0))
    found = [patterns.weighed(shapes, (2.0,)) for shapes in (one, two, one)]
    assert [math.copysign(1.0, shapes[0].vertices[0][0]) for shapes in found] == [1.0, -1.0, 1.0]
    assert found[0] is found[2]
