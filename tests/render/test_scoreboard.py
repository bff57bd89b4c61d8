"""The counters of a game, and how it ended, in pictures and films as in the window."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.render.label import Label
from sandbox.render.overlays.registry import find_overlay
from sandbox.render.scoreboard import GAP, SPACE, counter_lines
from sandbox.render.shots import Shooting, Shot, Style, shots, still
from sandbox.render.svg_painter import svg_picture
from sandbox.replay.golden.run import RunStepper

BALL = {"id": "ball", "shapes": [{"circle": 0.5}], "position": [0, 5]}
GAME: dict[str, Any] = {
    "bodies": [BALL],
    "counters": {"high-score": 13, "lives": 2},
    "rules": [
        {"when": {"time": 0.1}, "do": [{"counter": "high-score", "add": 7}]},
        {"when": {"time": 0.2}, "do": [{"win": "Well played"}]},
    ],
    "settings": {"steps": 20},
}


def words(shot: Shot) -> list[str]:
    return [label.text for layer in shot.marks for label in layer.labels]


def taken(scene: dict[str, Any], **style: Any) -> list[Shot]:
    stepper = RunStepper(sandbox.Scene(**scene), ())
    shooting = Shooting(stepper.world, Style(**({"size": (640, 400)} | style)))
    return list(shots(stepper, range(20), 1 / 60, shooting))


def test_a_film_shows_what_is_counted_and_how_it_ends() -> None:
    film = [words(shot) for shot in taken(GAME)]
    assert film[0] == film[4] == ["high score", "13", "lives", "2"]
    assert film[10] == ["high score", "20", "lives", "2"]
    assert film[20] == ["high score", "20", "lives", "2", "Won", "Well played"]


def test_they_stay_where_they_are() -> None:
    labels = [label for shot in taken(GAME) for layer in shot.marks for label in layer.labels]
    assert len({label.at for label in labels if label.text == "lives"}) == 1


def test_where_nothing_is_played_there_is_nothing() -> None:
    assert {shot.marks for shot in taken({"bodies": [BALL]})} == {()}


def test_an_svg_picture_has_them_too() -> None:
    stepper = RunStepper(sandbox.Scene(**GAME), ())
    shooting = Shooting(stepper.world, Style((640, 400)))
    text = svg_picture(shooting.draw_list(still(stepper, shooting)))
    assert "high score</text>" in text


@pytest.mark.parametrize("size", [(640, 400), (1280, 800), (160, 100), (64, 48)])
def test_they_share_the_picture_with_a_legend(size: tuple[int, int]) -> None:
    """Nothing that is said lies over the counters; on the smallest pictures there is room for nothing else."""
    for shot in taken(GAME, size=size, overlays=[find_overlay("velocities"), find_overlay("centers")])[:3]:
        *others, board = shot.marks
        counters = [label.box for label in board.labels]
        labels: list[Label] = [label for layer in others for label in layer.labels]
        assert not any(overlap(label.box, box) for label in labels for box in counters)
        assert size[0] < 200 or labels


def overlap(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


@given(
    st.dictionaries(st.text("abc-_", min_size=1, max_size=9), st.integers(-999, 9999), max_size=9), st.floats(1, 500)
)
def test_lines_hold_what_fits(counters: dict[str, int], room: float) -> None:
    lines = list(counter_lines(counters, room, lambda text, _: 8.0 * len(text)))
    assert [value for line in lines for _, _, _, value in line] == [f"{number:g}" for number in counters.values()]
    for line in lines:
        ends = [at + 8.0 * len(value) for _, _, at, value in line]
        assert len(line) == 1 or ends[-1] <= room
        assert all(value_at == at + 8.0 * len(name) + SPACE for at, name, value_at, _ in line)
        assert [at for at, *_ in line[1:]] == pytest.approx([end + GAP for end in ends[:-1]])
