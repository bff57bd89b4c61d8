"""`sandbox sat`: the table, the explanation, the data, and what it says when it cannot."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest

from sandbox.render.sat_figure import FIGURES
from tests.geometry.tutorial_cases import TABLE_ONE, TABLE_TWO

SVG = "{http://www.w3.org/2000/svg}"


def rows_of(text: str) -> list[list[str]]:
    return [line.split() for line in text.partition("\n\n")[0].splitlines()[1:]]


@pytest.mark.parametrize(("scene", "table"), [("test-one", TABLE_ONE), ("test-two", TABLE_TWO)])
def test_it_prints_the_tutorials_numbers(cli: Callable, scene: str, table: tuple) -> None:
    done = cli("sat", f"scenes/sat/{scene}.scene.json")
    assert done.code == 0
    head, *_ = done.out.splitlines()
    assert head.split() == ["amax", "amin", "bmax", "bmin", "gap"]
    assert rows_of(done.out) == [[str(k), *map(str, row)] for k, row in enumerate(table, 1)]


def test_the_early_exit_is_told(cli: Callable) -> None:
    done = cli("sat", "test-one")
    assert "not colliding: axis 2, edge 2 of square, leaves a gap of 1 m.\n5 more axes were not needed.\n" in done.out
    full = cli("sat", "test-one", "--all")
    assert len(rows_of(full.out)) == 7
    assert full.out.count("the test stops here") == 1
    assert "not needed" not in full.out


def test_the_other_order_turns_the_way_round(cli: Callable) -> None:
    assert "moves triangle by (0, 1) m" in cli("sat", "test-two").out
    assert "moves square by (0, -1) m" in cli("sat", "test-two", "--bodies", "triangle", "square").out


@pytest.mark.parametrize(
    ("a", "b", "name"),
    [
        ({"circle": 0.5}, {"circle": 0.5}, "centre to centre"),
        ({"circle": 0.2}, {"box": [1, 1]}, "centre to vertex 4"),
        ({"capsule": [[-1, 0], [0, 0]], "radius": 0.2}, {"circle": 0.8}, "vertex 2 to centre"),
        ({"capsule": [[-1, 0], [0, 0]], "radius": 0.2}, {"capsule": [[0, 0], [1, 0]], "radius": 0.6},
         "vertex 2 to vertex 1"),
    ],
)  # fmt: skip
def test_discs_have_a_centre_and_no_vertices(
    cli: Callable, write_scene: Callable, tmp_path: Path, a: dict, b: dict, name: str
) -> None:
    bodies = [{"id": "a", "shapes": [a]}, {"id": "b", "position": [0.55, -0.55], "shapes": [b]}]
    picture = tmp_path / "out.svg"
    done = cli("sat", write_scene("pair.scene.json", bodies=bodies), "--step-by-step", "--svg", picture)
    assert f", from {name}\n" in done.out
    assert ("It is the only axis: no gap." in done.out) == (name == "centre to centre")
    classes = [text.get("class", "") for text in ElementTree.parse(picture).iter(f"{SVG}text")]
    numbered = sum(words in ("a small strong number", "b small strong number") for words in classes)
    assert numbered == sum({"circle": 0, "capsule": 2, "box": 4}[next(iter(shape))] for shape in (a, b))


def test_a_later_step_is_another_table(cli: Callable) -> None:
    data = json.loads(cli("sat", "test-two", "--step", "60", "--json").out)
    assert data["step"] == 60
    assert data["bodies"][1]["vertices"][0] == pytest.approx([13, 14], abs=1e-5)
    assert (data["depth"] or 0.0) == pytest.approx(0, abs=1e-5)  # nothing if rounding left a gap


def test_json_holds_the_table(cli: Callable) -> None:
    data = json.loads(cli("sat", "test-one", "--json").out)
    assert (data["colliding"], data["axes"], data["stopped_at"], data["mtv"]) == (False, 7, 2, None)
    assert [body["id"] for body in data["bodies"]] == ["square", "triangle"]
    assert data["bodies"][0]["vertices"] == [[13, 10], [13, 3], [6, 3], [6, 10]]
    got = [tuple(row[name] for name in ("amax", "amin", "bmax", "bmin")) for row in data["rows"]]
    assert got == [row[:4] for row in TABLE_ONE]
    assert [row["stopped"] for row in data["rows"]] == [False, True]


def test_step_by_step_tells_six_steps_of_a_collision(cli: Callable) -> None:
    out = cli("sat", "test-two", "--step-by-step").out
    titles = ["1. Axes", "2. Projections", "3. Early exit", "4. Minimum", "5. Orientation", "6. Clipping"]
    assert [line for line in out.splitlines() if line[:1].isdigit()] == titles
    assert "edge 1 of triangle  (13, 13) to (8, 9)   (-5, -4)  (4, -5)" in out
    assert "triangle  -47 to -13  (-13, -13, -47)" in out
    assert "amax - bmin = 7,\n" in out
    assert "Reference face: edge 4 of square" in out
    assert "cut at the side to (11, 11.4): 1.4 m above it, dropped" in out
    assert "Half way between the surfaces: (8, 9.5)." in out


def test_step_by_step_ends_with_the_gap(cli: Callable) -> None:
    out = cli("sat", "test-one", "--step-by-step").out
    assert "Axis 2: -70 < -77 is false. That is a gap: the test stops here." in out
    assert "4. " not in out


@pytest.mark.parametrize("scene", ["round", "inside", "same-floor", "slanted", "cup", "corners"])
def test_every_case_of_the_lesson_can_be_told(cli: Callable, scene: str) -> None:
    assert cli("sat", scene, "--step-by-step").code == 0
    assert "nan" not in cli("sat", scene, "--step-by-step", "--step", "30").out


def test_of_several_shapes_the_deepest_pair_is_taken_and_told(cli: Callable, write_scene: Callable) -> None:
    table = {"id": "table", "type": "static", "shapes": [{"box": [1, 1]}, {"box": [1, 1], "at": [3, 0]}]}
    ball = {"id": "ball", "position": [3.2, 0.9], "shapes": [{"circle": 0.5}, {"circle": 0.1, "at": [0, 5]}]}
    path = write_scene("many.scene.json", bodies=[table, ball])
    done = cli("sat", path)
    first = "shape 2 of the 2 of table and shape 1 of the 2 of ball: of all pairs of their shapes the deepest"
    assert done.out.startswith(first)
    assert "0.1 m deep" in done.out
    far = write_scene("far.scene.json", bodies=[table, {**ball, "position": [8, 0]}])
    assert cli("sat", far).out.startswith("shape 2 of the 2 of table and shape 1 of the 2 of ball")


def test_mistakes_are_told_with_their_mend(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    crate = {"id": "crate", "position": [0, 0.5], "shapes": [{"box": [1, 1]}]}
    bodies = [{**crate, "id": f"crate-{k}", "position": [k, 0]} for k in range(3)]
    path = write_scene("three.scene.json", bodies=bodies)
    lone = write_scene("one.scene.json", bodies=[crate])
    for arguments, words in [
        ((path,), "3 bodies, and the test takes two; name two of them: --bodies crate-0 crate-1"),
        ((lone,), "one body, and the test takes two"),
        ((path, "--bodies", "crate-0", "crat-1"), "no body 'crat-1' in this scene; did you mean \"crate-1\"?"),
        ((path, "--bodies", "crate-0", "moon"), "it has crate-0, crate-1, crate-2"),
        ((path, "--bodies", "crate-0", "crate-0"), "does not collide with itself"),
        (("test-one", "--svg", tmp_path / "a.png"), "must end in .svg"),
        (("test-one", "--svg", tmp_path / "no" / "a.svg"), "does not exist"),
        (("test-one", "--svg", tmp_path / "a.svg", "--figure", "edgs"), 'did you mean "edges"?'),
        (("test-one", "--svg", tmp_path / "a.svg", "--axis", "8"), "these two shapes have 7 axes"),
        (("nowhere.json",), "there is no such file"),
        (("tset-one",), 'there is no such file: did you mean "test-one", which comes with the package?'),
        (("test-one", "--axis", "3"), "--axis chooses what --svg FILE draws: give both"),
        (("test-one", "--figure", "edges"), "--figure chooses what --svg FILE draws: give both"),
        (
            ("test-one", "--svg", tmp_path / "a.svg", "--figure", "mtv", "--axis", "3"),
            "--axis is for --figure axis or dot",
        ),
        (("test-one", "--json", "--step-by-step"), "give one of the two"),
    ]:
        done = cli("sat", *arguments)
        assert (done.code, words in done.err) == (2, True), (arguments, done)
        assert "Traceback" not in done.err
        assert done.out == "" or "--json" in arguments


def test_more_pairs_of_parts_than_a_picture_holds_are_refused(
    cli: Callable, write_scene: Callable, tmp_path: Path
) -> None:
    balls = [{"circle": 0.1, "at": [k, 0]} for k in range(40)]
    bodies = [{"id": name, "position": [0, y], "shapes": balls} for name, y in (("low", 0), ("high", 3))]
    path, svg = write_scene("balls.scene.json", bodies=bodies), tmp_path / "a.svg"
    done = cli("sat", path, "--svg", svg, "--figure", "parts")
    assert (done.code, svg.exists()) == (2, False)
    assert "--figure parts: 1600 pairs of shapes are too many for a picture, at most 1000" in done.err


def test_a_concave_body_is_drawn_where_it_is_now(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    notch = {"polygon": [[0, 0], [4, 0], [4, 4], [2, 4], [2, 2], [0, 2]]}
    bodies = [
        {"id": "notch", "position": [3, 1], "angle": 90, "shapes": [notch]},
        {"id": "stone", "position": [2.2, 2], "shapes": [{"circle": 0.25}]},
    ]
    path = write_scene("notch.scene.json", bodies=bodies)
    assert cli("sat", path, "--bodies", "notch", "stone", "--svg", tmp_path / "a.svg", "--figure", "parts").code == 0
    root = ElementTree.parse(tmp_path / "a.svg").getroot()
    outline, *parts = [path.get("d") for path in root.iter(f"{SVG}path") if path.get("class") == "a shape"]
    assert len(parts) == 2
    # Turned by a quarter, the outline has the box of its parts, one window (440 px and an edge of 24) further left.
    assert box(outline) == pytest.approx(box(" ".join(parts), left=464.0), abs=0.02)


def box(steps: str, left: float = 0.0) -> tuple[float, ...]:
    numbers = [float(number) for number in re.findall(r"-?[\d.]+", steps)]
    xs, ys = [x - left for x in numbers[0::2]], numbers[1::2]
    return min(xs), min(ys), max(xs), max(ys)


def test_long_names_fit_into_a_picture(cli: Callable, write_scene: Callable, tmp_path: Path) -> None:
    box = {"shapes": [{"box": [1, 1]}]}
    path = write_scene("long.scene.json", bodies=[{"id": name * 30, "position": [0, 0], **box} for name in "ab"])
    assert cli("sat", path, "--svg", tmp_path / "a.svg", "--figure", "edges").code == 0
    assert f"the edges of {'a' * 16}… and {'b' * 16}…" in (tmp_path / "a.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize("figure", FIGURES)
@pytest.mark.parametrize("scene", ["test-one", "test-two", "round", "inside", "cup", "corners"])
def test_every_figure_of_every_case_is_a_picture_with_a_title(
    cli: Callable, tmp_path: Path, scene: str, figure: str
) -> None:
    path = tmp_path / "a.svg"
    done = cli("sat", scene, "--svg", path, "--figure", figure)
    assert done.code == 0
    assert f"{path}: " in done.out
    root = ElementTree.parse(path).getroot()
    assert root.tag == f"{SVG}svg"
    assert " and " in root.find(f"{SVG}title").text
    assert "prefers-color-scheme: dark" in root.find(f"{SVG}style").text
    assert "nan" not in path.read_text()
