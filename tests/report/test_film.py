"""Films show what worlds do."""

from __future__ import annotations

import numpy as np
import pytest

import sandbox
from sandbox import ApplyImpulse, Delete, Spawn
from sandbox.render.frame import capture
from sandbox.replay.golden.run import Run
from sandbox.report import film_recorder
from sandbox.report.film_data import film_data
from sandbox.report.filming import film_ahead, film_run
from sandbox.report.player_page import player_page
from tests.replay import played


def centers(world: sandbox.World) -> np.ndarray:
    return np.column_stack([world.state.bodies.center_x, world.state.bodies.center_y, world.state.bodies.angle])


def test_every_step_of_a_recording() -> None:
    recording = played.recording()
    film = film_run(recording)
    assert film.poses.shape == (8, played.STEPS + 1, 3)
    player = sandbox.Player(recording)
    for step in (0, 1, 40, 90, played.STEPS):
        player.seek(step)
        np.testing.assert_array_equal(film.poses[:, step], centers(player.world))
    by_step = {row.step: row for row in film.figures}
    assert [by_step[row.step] for row in recording.checkpoints] == list(recording.checkpoints)
    assert film.commands[1] == (10, "StartDrag crate")


def test_it_begins_where_it_is_told_to() -> None:
    whole, late = film_run(played.recording()), film_run(played.recording(), skip=37)
    assert (late.start, late.end) == (37, played.STEPS)
    np.testing.assert_array_equal(late.poses[:, 1:], whole.poses[:, 38:])


def test_a_long_run_is_thinned_and_keeps_its_end() -> None:
    whole, thin = film_run(played.recording()), film_run(played.recording(), most=200)
    assert thin.every == 6
    assert [row.step for row in thin.figures] == [*range(0, 150, 6), 150]
    np.testing.assert_array_equal(thin.poses, whole.poses[:, ::6])


def test_bodies_that_come_and_go() -> None:
    ball = {"id": "late", "shapes": [{"circle": 0.3}], "position": [8, 5]}
    commands = ((5, Spawn(ball)), (9, Delete("stone")))
    film = film_run(Run(played.scene(), 20, commands))
    data = {body["id"]: body for body in film_data(film)["bodies"]}
    assert data["late"]["there"] == [6]
    assert data["late"]["from"][0] == 8.0
    assert data["stone"]["there"] == [0, 10]
    assert data["crate"]["there"] == [0]


def test_who_is_there_already_is_not_looked_at_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a body that came in each step, all the others were written down anew in each."""
    asked = []
    real = film_recorder.film_bodies
    monkeypatch.setattr(film_recorder, "film_bodies", lambda *given: (asked.append(len(given[2])), real(*given))[1])
    balls = [{"id": f"late-{k}", "shapes": [{"circle": 0.3}], "position": [8, 5 + k]} for k in range(6)]
    film = film_run(Run(played.scene(), 20, tuple((k, Spawn(ball)) for k, ball in enumerate(balls))))
    assert asked == [len(played.scene().bodies), *[1] * len(balls)]
    assert [body.id for body in film.bodies][-6:] == [ball["id"] for ball in balls]


def test_the_mesh_measures_itself_once() -> None:
    """Each shape of a page asked for one row, and all rows were measured for it: 20,000 took 12 s."""
    mesh = capture(sandbox.World(played.scene()).state).mesh
    assert mesh.reach is mesh.reach
    assert mesh.mark is mesh.mark


def test_many_bodies_that_are_alike_take_little_room() -> None:
    """2,000 balls in a page took 0.6 MB before they moved."""
    balls = [{"id": f"ball-{k}", "shapes": [{"circle": 0.4}], "position": [k % 50, k // 50]} for k in range(2000)]
    page = player_page("", film_run(sandbox.Scene(bodies=balls, gravity=[0, 0], settings={"steps": 2})))
    assert len(page) < 100_000


def test_a_refused_command_ends_it() -> None:
    film = film_run(Run(played.scene(), 20, ((7, ApplyImpulse("nobody", (1.0, 0.0))),)))
    assert film.end == 7
    assert "after step 7" in film.cut
    assert "nobody" in film.cut


def test_looking_ahead_leaves_the_world_alone() -> None:
    world = sandbox.World(played.scene())
    world.step(10)
    world.apply(Delete("pill"))
    digest = world.digest()
    film = film_ahead(world, 25)
    assert (world.digest(), world.step_count) == (digest, 10)
    world.step(25)
    np.testing.assert_array_equal(film.poses[:, -1], centers(world))


@pytest.mark.parametrize("make", [played.scene, played.recording, lambda: sandbox.World(played.scene())])
def test_a_notebook_shows_a_player(make) -> None:
    text = make()._repr_html_()
    assert text.startswith("<iframe srcdoc=")
    assert len(text) < 200_000


def test_a_notebook_shows_an_error_as_text(tmp_path) -> None:
    played.scene().save(tmp_path / "a.scene.json")
    recording = sandbox.record(tmp_path / "a.scene.json", 5)
    recording.save(tmp_path / "a.replay.json")
    (tmp_path / "a.scene.json").unlink()
    assert sandbox.Recording.load(tmp_path / "a.replay.json")._repr_html_().startswith("<pre>")


def test_shapes_that_overlap_from_the_start_touch_at_the_first_moment() -> None:
    ground = {"id": "ground", "type": "static", "shapes": [{"box": [9, 1]}], "position": [0, -0.5]}
    crate = {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.4]}
    for scene in (sandbox.Scene(bodies=[ground, crate]), sandbox.Scene(bodies=[crate])):
        film = film_run(Run(scene, 3, ()))
        assert film.figures[0].contacts == film.figures[1].contacts == len(scene.bodies) - 1
        assert film.figures[0].deepest == pytest.approx(0.1 if film.figures[0].contacts else 0.0)
        assert film.figures[0].step == 0
