from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import sandbox
from sandbox import Delete, SetVelocity, Spawn
from sandbox.render.body_colors import body_colors_of
from sandbox.render.camera import Camera
from sandbox.render.trails import Trails
from sandbox.window.session import MOST_STEPS, Session

SCENE = sandbox.Scene(
    title="Two crates",
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.5]},
        {"id": "other", "shapes": [{"box": [1, 1]}], "position": [4, 3]},
    ],
)


@pytest.fixture
def session() -> Session:
    return Session(SCENE)


def test_a_scene_without_a_title_is_called_as_its_file_is(session: Session, tmp_path: Path) -> None:
    """Also where another file was asked for first, and this one was dropped onto the window."""
    path = tmp_path / "yard.scene.json"
    path.write_text('{"bodies": [{"id": "ball", "shapes": [{"circle": 1}]}]}', encoding="utf-8")
    titles = [session.title, Session(sandbox.load_scene(path)).title, Session(sandbox.Scene()).title]
    assert titles == ["Two crates", "yard.scene.json", ""]


def test_a_session_is_the_world_stepped(session: Session) -> None:
    for _ in range(50):
        session.step_once()
    world = sandbox.World(SCENE)
    world.step(50)
    assert session.world.digest() == world.digest()


def test_slow_motion_and_uneven_frames_do_not_change_the_physics(session: Session) -> None:
    session.clock.speed = 0.25
    for k in range(400):
        session.update(0.001 * (k % 37))
    world = sandbox.World(SCENE)
    world.step(session.world.step_count)
    assert session.world.step_count > 20
    assert session.world.digest() == world.digest()


def test_the_picture_lies_between_the_last_two_steps(session: Session) -> None:
    step = session.clock.step_seconds
    session.update(10.25 * step / 1.0)
    session.update(0.0)
    session.clock.snap_to_step()
    session.update(0.25 * step)
    before, after = session.previous.center[2, 1], session.current.center[2, 1]
    assert session.frame().center[2, 1] == pytest.approx(before + 0.25 * (after - before))


def test_a_long_wait_is_not_caught_up_with(session: Session) -> None:
    assert session.update(100.0) <= MOST_STEPS


def test_pause_and_single_steps(session: Session) -> None:
    session.clock.paused = True
    assert session.update(1.0) == 0
    session.step_once()
    assert session.world.step_count == 1
    assert session.frame().step == 1
    assert session.frame() is session.current


def test_restart_begins_again(session: Session) -> None:
    start = session.world.digest()
    session.grab((4.0, 3.0), 0.0)
    session.update(0.1)
    session.restart()
    assert session.world.digest() == start
    assert session.grip.body is None
    assert np.array_equal(session.frame().center, session.current.center)


def test_dragging_pulls_the_body_towards_the_hand_and_release_lets_it_fall(session: Session) -> None:
    assert session.grab((0.2, 0.6), 0.0)
    session.grip.pull((0.2, 4.0))
    for _ in range(120):
        session.step_once()
    grip = session.grip.place(session.current)
    assert np.hypot(grip[0] - 0.2, grip[1] - 4.0) < 0.1
    session.grip.let_go()
    assert session.grip.body is None
    for _ in range(120):
        session.step_once()
    assert session.world.body("crate").position[1] < 0.8


def test_the_grip_is_the_point_that_was_caught(session: Session) -> None:
    session.update(0.05)
    session.grab((4.3, 3.1), 0.0)
    assert session.grip.place(session.frame()) == pytest.approx((4.3, 3.1), abs=1e-9)


def test_nothing_is_grabbed_where_nothing_moves(session: Session) -> None:
    assert not session.grab((-5.0, -0.5), 0.0)
    assert not session.grab((10.0, 10.0), 0.1)
    session.grip.pull((1.0, 1.0))
    session.grip.let_go()
    assert session.grip.body is None


def test_bodies_that_come_and_go_are_seen_at_once(session: Session) -> None:
    body_colors = body_colors_of(session.world.state)
    before = session.frame()
    session.step_once()
    session.world.apply(Spawn({"id": "ball", "shapes": [{"circle": 0.5}], "position": [9, 9], "color": "#ff0000"}))
    frame = session.frame()
    assert len(frame.center) == len(frame.mesh.body) == 4
    assert tuple(frame.center[3]) == (9.0, 9.0)
    colors = body_colors.for_frame(frame)
    assert colors.base[3].tolist() == [1.0, 0.0, 0.0]
    assert (colors.base[:3] == body_colors.base).all()
    session.world.apply(Delete("crate"))
    after = session.frame()
    assert after.roster.names == ("ground", "other", "ball")
    assert colors.for_frame(after).base.tolist() == colors.base[[0, 2, 3]].tolist()
    assert colors.for_frame(after).for_frame(before).base.shape == (3, 3)
    session.update(0.1)
    assert session.frame().mesh is after.mesh


def test_the_hand_keeps_its_body_and_lets_go_of_one_that_is_gone(session: Session) -> None:
    assert session.grab((4.0, 3.0), 0.1)
    session.world.apply(Delete("crate"))
    assert session.grip.body == 1
    assert session.grip.place(session.frame()) == pytest.approx((4.0, 3.0), abs=1e-9)
    session.grip.pull((5.0, 5.0))
    session.world.apply(Delete("other"))
    assert session.grip.body is None
    session.grip.pull((6.0, 6.0))
    session.grip.let_go()
    session.step_once()


def test_trails_are_those_of_the_future_that_is_shown(session: Session) -> None:
    def furthest() -> float:
        assert session.trails is not None
        return float(np.nanmax(session.trails.lines(session.current, Camera())[0], initial=-np.inf))

    session.do("Throw crate", SetVelocity("crate", (0.0, 3.0), 0.0))
    session.skip(40)
    session.seek(0)
    session.do("Throw other", SetVelocity("other", (50.0, 0.0), 0.0))
    session.trails = Trails()
    for _ in range(40):
        session.step_once()
    assert furthest() > 800.0
    session.switch(0)
    session.seek(40)
    assert furthest() == -np.inf  # nobody has seen its steps since there are trails
