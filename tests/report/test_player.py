"""The player in a real browser."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import sandbox
from sandbox import ApplyImpulse
from sandbox.render.theme import LIGHT
from sandbox.replay.golden.run import Run
from sandbox.report.filming import film_run
from sandbox.report.player_page import player_frame, player_page
from sandbox.resources import find_scene
from tests.replay import played
from tests.report.browser import Browser

PLAYER = "document.querySelector('.player')"
EVIL = "</script><script>document.title = 'caught'</script><!-- \u2028 & \" '"


def opened(show: Browser, folder: Path, page: str) -> None:
    path = folder / "page.html"
    path.write_text(page, encoding="utf-8")
    show.open(path)
    show.until(f"{PLAYER}.dataset.ready")


@pytest.mark.slow
def test_it_plays_by_itself(show: Browser, tmp_path: Path) -> None:
    opened(show, tmp_path, player_page("A box of things", film_run(played.recording())))
    assert show.value("document.title") == "A box of things"
    assert show.value(f"{PLAYER}.dataset.step") == "0"
    show.value("document.querySelector('button').click()")
    show.until(f"{PLAYER}.dataset.step > 5")
    show.until(f"{PLAYER}.dataset.step == {played.STEPS}")
    show.until(f"!{PLAYER}.player.playing")


@pytest.mark.slow
def test_keys_and_the_slider_choose_the_step(show: Browser, tmp_path: Path) -> None:
    opened(show, tmp_path, player_page("", film_run(played.recording())))
    key = "{0}.dispatchEvent(new KeyboardEvent('keydown', {{key: '{1}', shiftKey: {2}}}))"
    for name, shift, step in (("ArrowRight", "false", 1), ("ArrowRight", "true", 11), ("ArrowLeft", "false", 10),
                              ("End", "false", 150), ("Home", "false", 0)):  # fmt: skip
        show.value(key.format(PLAYER, name, shift))
        assert show.value(f"{PLAYER}.dataset.step") == str(step)
    show.value("(s => { s.value = 77; s.dispatchEvent(new Event('input')); })(document.querySelector('.slider'))")
    assert show.value("document.querySelector('.count').textContent") == "step 77 / 150"


def test_keys_are_for_the_player_that_has_the_page_to_itself(show: Browser, tmp_path: Path) -> None:
    """Space scrolled the page of who had not clicked into the player first, and its button promises to play."""
    opened(show, tmp_path, player_page("A box", film_run(played.recording()), about="It falls."))
    assert show.value("document.querySelector('h1 + p').textContent") == "It falls."
    assert show.value("document.documentElement.scrollHeight <= innerHeight")
    show.value("document.body.dispatchEvent(new KeyboardEvent('keydown', {key: 'End', bubbles: true}))")
    assert show.value(f"{PLAYER}.dataset.step") == str(played.STEPS)


def test_a_page_is_light_where_its_film_is(show: Browser, tmp_path: Path) -> None:
    film = film_run(played.recording(), theme=LIGHT)
    assert film.bodies[-1].data["fill"] != film_run(played.recording()).bodies[-1].data["fill"]
    opened(show, tmp_path, player_page("", film))
    assert show.value("getComputedStyle(document.body).backgroundColor") == "rgb(251, 250, 246)"
    assert show.value("getComputedStyle(document.body).color") == "rgb(28, 33, 41)"
    pixel = f"[...{PLAYER}.querySelector('.view').getContext('2d').getImageData(5, 5, 1, 1).data]"
    assert min(show.value(pixel)[:3]) > 200


def test_a_game_is_told_with_its_counters_and_its_end(show: Browser, tmp_path: Path) -> None:
    ball = {"id": "ball", "shapes": [{"circle": 1}]}
    rules = [{"when": {"time": 0.1}, "do": [{"counter": "high-score", "add": 7}]},
             {"when": {"time": 0.2}, "do": [{"win": "Well <played>"}]}]  # fmt: skip
    game = sandbox.Scene(bodies=[ball], counters={"high-score": 3}, rules=rules, settings={"steps": 20})
    opened(show, tmp_path, player_page("", film_run(game)))
    for step, said in ((0, "high score 3"), (10, "high score 10"), (20, "high score 10  ·  Won: Well <played>")):
        show.value(f"{PLAYER}.player.seek({step})")
        assert show.value("document.querySelector('.label').textContent").endswith(f"awake  ·  {said}")


def test_rounding_is_no_drift(show: Browser, tmp_path: Path) -> None:
    """The energy of a body that falls is the same to 1e-11 J; what rounding adds filled the plot."""
    falling = sandbox.Scene(bodies=[{"id": "ball", "shapes": [{"circle": 1}]}], settings={"steps": 100})
    film = film_run(falling)
    energies = [row.energy for row in film.figures]
    assert 0.0 < max(energies) - min(energies) < 1e-9
    opened(show, tmp_path, player_page("", film))
    assert show.value(f"(p => p.high - p.low)({PLAYER}.player.plots[0].plot)") > 1.0


def test_its_poses_are_those_of_the_world(show: Browser, tmp_path: Path) -> None:
    film = film_run(played.recording())
    opened(show, tmp_path, player_page("", film))
    quanta = np.array([[body.quantum, body.quantum, body.turn] for body in film.bodies])
    for step in (0, 1, 50, 150):
        script = f"(r => r.bodies.map((_, row) => r.pose(row, {step})))({PLAYER}.player.film)"
        assert (np.abs(np.array(show.value(script)) - film.poses[:, step]) <= 0.51 * quanta).all()


@pytest.mark.slow
def test_between_kept_samples_it_goes_straight(show: Browser, tmp_path: Path) -> None:
    film = film_run(played.recording(), most=200)
    opened(show, tmp_path, player_page("", film))
    script = f"(r => [6, 9, 12].map(step => r.pose(r.rows.get('ball'), step)[1]))({PLAYER}.player.film)"
    before, middle, after = show.value(script)
    assert middle == pytest.approx((before + after) / 2, abs=1e-12)


@pytest.mark.slow
def test_the_wheel_zooms_about_the_pointer(show: Browser, tmp_path: Path) -> None:
    opened(show, tmp_path, player_page("", film_run(played.recording())))
    viewport = f"{PLAYER}.player.viewport"
    before = show.value(f"[{viewport}.scale, ...{viewport}.metres(200, 100)]")
    wheel = "new WheelEvent('wheel', {deltaY: -400, clientX: r.left + 200, clientY: r.top + 100})"
    show.value(f"(c => {{ const r = c.getBoundingClientRect(); c.dispatchEvent({wheel}); }})({viewport}.canvas)")
    after = show.value(f"[{viewport}.scale, ...{viewport}.metres(200, 100)]")
    assert after[0] > 1.5 * before[0]
    assert after[1:] == pytest.approx(before[1:], abs=1.5 / before[0])


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ragdolls", "harbour", "rocket", "tetrominoes", "gears-and-pulley", "zigzag", "cart"])
def test_shipped_scenes_of_every_kind(show: Browser, tmp_path: Path, name: str) -> None:
    scene = sandbox.load_scene(find_scene(Path(name)))
    opened(show, tmp_path, player_page(name, film_run(Run(scene, 61))))
    show.value(f"{PLAYER}.player.seek(60)")
    colors = f"""(c => {{
      const data = c.getContext('2d').getImageData(0, 0, c.width, c.height).data, seen = new Set();
      for (let i = 0; i < data.length; i += 4) seen.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
      return seen.size;
    }})({PLAYER}.player.canvas)"""
    assert show.value(colors) > 20


@pytest.mark.slow
def test_shapes_of_one_body_are_painted_one_by_one(show: Browser, tmp_path: Path) -> None:
    cross = [{"box": [4, 1]}, {"box": [1, 4]}]
    hoop = [{"polygon": [[-3, -3], [3, -3], [3, 3], [1, 3], [1, -1], [-1, -1], [-1, 3], [-3, 3]]}]
    bodies = [
        {"id": "cross", "type": "static", "shapes": cross, "color": "#ff0000"},
        {"id": "hoop", "type": "static", "shapes": hoop, "color": "#ff0000", "position": [9, 0]},
        {
            "id": "gate",
            "type": "static",
            "shapes": [{"box": [2, 2], "sensor": True}],
            "color": "#ff0000",
            "position": [15, 0],
        },
    ]
    opened(show, tmp_path, player_page("", film_run(sandbox.Scene(bodies=bodies, settings={"steps": 2}))))
    script = f"""(s => {{
      const image = s.context.getImageData(0, 0, s.canvas.width, s.canvas.height);
      const red = ([x, y]) => image.data[4 * (Math.round(y) * image.width + Math.round(x))];
      const points = [[0, 0], [1.5, 0], [1.5, 1.5], [9, -2], [9, 1], [7, 2], [15, 0]];
      return points.map((point) => red(s.pixel(...point)));
    }})({PLAYER}.player.viewport)"""
    middle, arm, corner, floor, hole, side, gate = show.value(script)
    assert middle == arm == floor == side == 255
    assert corner < 60
    assert hole < 60
    assert gate < 90


@pytest.mark.slow
def test_no_text_becomes_markup(show: Browser, tmp_path: Path) -> None:
    scene = played.scene(title=EVIL)
    recording = sandbox.record(scene, 20, [(3, ApplyImpulse("ball", (0.0, 1.0)))])
    opened(show, tmp_path, player_page(EVIL, film_run(recording)))
    assert show.value("document.title.includes('caught') && document.title.startsWith('</script>')")
    (tmp_path / "book.html").write_text(f"<!doctype html><title>book</title>{player_frame(EVIL, film_run(recording))}")
    show.open(tmp_path / "book.html")
    show.until("window.frames.length === 1")
    assert show.value("document.title") == "book"


@pytest.mark.slow
def test_an_empty_world(show: Browser, tmp_path: Path) -> None:
    opened(show, tmp_path, player_page("", film_run(sandbox.Scene(settings={"steps": 5}))))
    assert show.value(f"{PLAYER}.dataset.ready") == "1"
