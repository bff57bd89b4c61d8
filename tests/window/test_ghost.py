"""The ghost of another run."""

from __future__ import annotations

import threading

import numpy as np
import pytest

import sandbox
from sandbox.render.camera import Camera
from sandbox.render.frame import capture
from sandbox.replay.golden.run import Run
from sandbox.window.ghost import Ghost, GhostMoment, frame_at_poses, ghost_marks
from tests.window.test_session import SCENE

CAMERA = Camera((0.0, 2.0), 40.0, (800, 600))
WHITE = (1.0, 1.0, 1.0)


def moment(ghost: Ghost, step: int) -> GhostMoment:
    found = ghost.wait(step)
    assert found is not None
    return found


def test_any_step_has_the_bits_of_a_straight_run() -> None:
    world = sandbox.World(SCENE)
    ghost = Ghost(Run(SCENE, 120))
    poses = [world.state.bodies.copy()]
    for _ in range(120):
        world.step()
        poses.append(world.state.bodies.copy())
    for step in (0, 5, 120, 3, 60, 59):
        found = moment(ghost, step)
        assert found.frame.step == step
        for name in world.names:
            assert found.record(name) == poses[step][world.names.index(name)]
    assert found.record("nobody") is None
    assert ghost.wait(121) is None
    ghost.close()


def test_a_run_that_is_refused_says_so() -> None:
    ghost = Ghost(Run(SCENE, 50, ((10, sandbox.Delete("nobody")),)))
    moment(ghost, 10)
    assert ghost.wait(11) is None
    assert "nobody" in ghost.trouble


def test_a_mistake_of_this_program_ends_the_run_with_its_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    def capture(*given: object) -> None:
        raise IndexError("beyond the end")

    told: list[object] = []
    monkeypatch.setattr("sandbox.window.ghost.capture", capture)
    monkeypatch.setattr(threading, "excepthook", lambda args: told.append(args.exc_value))
    ghost = Ghost(Run(SCENE, 50))
    assert ghost.wait(0) is None
    assert ghost.trouble == "beyond the end"
    ghost._thread.join()
    assert [str(error) for error in told] == ["beyond the end"]


def test_only_what_is_elsewhere_is_outlined() -> None:
    world = sandbox.World(SCENE)
    before = capture(world.state)
    assert len(ghost_marks(before, before, CAMERA, WHITE).strokes) == 0
    name = next(name for name, body in zip(world.names, world.state.bodies, strict=True) if body.type == 2)
    view = world.body(name)
    world.apply(sandbox.SetPose(name, (view.position[0] + 1.0, view.position[1]), view.angle))
    marks = ghost_marks(before, capture(world.state), CAMERA, WHITE)
    assert len(marks.strokes) >= 4
    x, y = CAMERA.to_screen(before.center[world.names.index(name)])
    assert np.hypot(*(marks.strokes.start.mean(axis=0) - (x, y))) < 2.0
    world.apply(sandbox.Delete(name))
    assert len(ghost_marks(before, capture(world.state), CAMERA, WHITE).strokes) >= 4


def test_poses_of_origins_become_a_frame() -> None:
    scene = sandbox.Scene(
        bodies=[{"id": "wedge", "shapes": [{"polygon": [[0, 0], [2, 0], [0, 1]]}], "position": [1, 5], "angle": 30}]
    )
    world = sandbox.World(scene)
    start, records = capture(world.state), world.state.bodies.copy()
    for _ in range(20):
        world.step()
    row = world.state.bodies[0]
    pose = {"wedge": (float(row.position_x), float(row.position_y), float(row.angle))}
    found, wanted = frame_at_poses(start, records, pose), capture(world.state)
    assert np.allclose(found.center, wanted.center, atol=1e-12)
    assert np.allclose(found.rotation, wanted.rotation, atol=1e-12)
