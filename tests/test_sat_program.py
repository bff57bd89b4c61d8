"""The lesson's program: its pieces put together are the file beside it, and that says what the engine says."""

from __future__ import annotations

import doctest
import re
import runpy
import shutil
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import sandbox
from tests.cli.conftest import cli  # noqa: F401
from tests.examples import examples
from tests.geometry.convex_cases import numbers, polygons

LESSON = Path(__file__).parents[1] / "scenes" / "sat"
PROGRAM = LESSON / "separating_axis.py"
TEXT = (LESSON / "README.md").read_text(encoding="utf-8")
SECTIONS = dict(re.findall(r"^## ([^\n]+)\n(.*?)(?=^## |\Z)", TEXT, re.M | re.S))
GROWING = [title for title in SECTIONS if int(title.split(".")[0]) <= 12]
EXERCISES = re.findall(r"^\*\*(\d+)\.\*\*(.*?)^</details>$", SECTIONS["18. Exercises"], re.M | re.S)
Polygon = Sequence[tuple[float, float]]

program: dict[str, Any] = runpy.run_path(str(PROGRAM))


def blocks(text: str, language: str = "python") -> list[str]:
    """The fenced blocks of a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.M | re.S)


def try_out(text: str, names: dict[str, Any]) -> int:
    """Runs the lines with `>>>` and compares what comes out; returns how many there are."""
    test = doctest.DocTestParser().get_doctest(text, names, "lesson", None, 0)
    said: list[str] = []
    doctest.DocTestRunner(verbose=False).run(test, out=said.append, clear_globs=False)
    assert not said, "".join(said)
    return len(test.examples)


def run(*arguments: object, folder: Path) -> str:
    """What Python prints with those arguments; without site-packages, so no package can have helped."""
    done = subprocess.run(
        [sys.executable, "-S", *map(str, arguments)], capture_output=True, text=True, cwd=folder, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def test_the_pieces_one_under_the_other_are_the_file() -> None:
    assert "\n\n".join(blocks(TEXT)) == PROGRAM.read_text(encoding="utf-8")


def test_each_of_the_first_twelve_sections_ends_with_one_piece_and_what_it_can_do() -> None:
    assert len(GROWING) == 12
    for title in GROWING:
        assert re.search(r"\n```python\n((?!```).)*\n```\n\n```pycon\n((?!```).)*\n```\n*$", SECTIONS[title], re.S), (
            title
        )
        assert len(blocks(SECTIONS[title])) == 1, title
    assert len(blocks(TEXT)) == 12 + 1


@pytest.mark.parametrize("count", range(1, 13))
def test_the_program_runs_at_every_stage_of_its_growth(count: int) -> None:
    names: dict[str, Any] = {"__name__": "lesson"}
    for title in GROWING[:count]:
        exec("".join(blocks(SECTIONS[title])), names)
    assert try_out("".join(blocks(SECTIONS[GROWING[count - 1]], "pycon")), names) >= 1


@pytest.mark.parametrize(("number", "text"), EXERCISES, ids=[number for number, _ in EXERCISES])
def test_the_answers_to_the_exercises_are_right(number: str, text: str) -> None:
    assert "<details><summary>Answer</summary>" in text
    tried = try_out("".join(blocks(text, "pycon")), dict(program))
    assert tried >= 1 or number == "9", "the ninth asks for an argument"


def test_there_are_nine_exercises() -> None:
    assert [number for number, _ in EXERCISES] == [str(k) for k in range(1, 10)]


def test_a_student_who_runs_the_file_sees_what_the_lesson_prints(tmp_path: Path) -> None:
    (printed,) = re.findall(r"^```text\n\$ python scenes/sat/separating_axis.py\n(.*?)^```$", TEXT, re.M | re.S)
    assert run("scenes/sat/separating_axis.py", folder=LESSON.parents[1]) == printed
    shutil.copy(PROGRAM, tmp_path / "mine.py")
    assert run("mine.py", folder=tmp_path) == printed


def test_its_tables_are_those_of_the_command(cli: Callable) -> None:  # noqa: F811
    one, two = run(PROGRAM, folder=LESSON).split("Test two\n")
    for printed, scene in ((one.removeprefix("Test one\n"), "test-one"), (two, "test-two")):
        table, said = printed.rstrip("\n").rsplit("\n", 1)
        report = cli("sat", scene).out
        assert report.startswith(table + "\n\n")
        assert said.startswith("colliding") == (" are colliding: " in report)
    assert two.endswith("the shortest way out is (0, 1)\n")
    assert "The shortest way out moves triangle by (0, 1) m." in cli("sat", "test-two").out


def shape(polygon: Polygon) -> sandbox.Polygon:
    return sandbox.Polygon(tuple(polygon))


def moved(polygon: Polygon, x: float, y: float) -> list[tuple[float, float]]:
    return [(px + x, py + y) for px, py in polygon]


@given(polygons(), polygons(), numbers, numbers)
@examples(400)
def test_random_polygons_get_the_engines_verdict_and_its_way_out(a: Polygon, b: Polygon, x: float, y: float) -> None:
    a, b = list(a), moved(b, x, y)
    table = sandbox.sat_table(shape(a), shape(b), all_axes=True)
    assume(all(abs(row.separation) > 1e-9 for row in table.rows))  # So near a touch the program's own rounding decides.
    contact, way = sandbox.collide(shape(a), shape(b)), program["way_out"](a, b)
    assert program["colliding"](a, b) == (contact is not None) == (way is not None)
    assert [row[4] for row in program["rows"](a, b)] == [row.gap for row in sandbox.sat_table(shape(a), shape(b)).rows]
    if contact is not None:
        assert program["length"](way) == pytest.approx(contact.depth, rel=1e-9, abs=1e-12)
        left = sandbox.collide(shape(a), shape(moved(b, *way)))
        assert left is None or left.depth < 1e-9


whole = st.integers(-4, 4)
triangles = st.tuples(*[st.tuples(whole, whole)] * 3).filter(
    lambda t: (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) != (t[1][1] - t[0][1]) * (t[2][0] - t[0][0])
)
boxes = st.builds(
    lambda x, y, w, h: ((x, y), (x, y + h), (x + w, y + h), (x + w, y)),
    whole,
    whole,
    st.integers(1, 4),
    st.integers(1, 4),
)


@given(triangles | boxes, triangles | boxes)
@examples(400)
def test_whole_numbers_are_exact_even_where_shapes_touch(a: Polygon, b: Polygon) -> None:
    a, b = list(a), list(b)
    assert program["colliding"](a, b) == (sandbox.collide(shape(a), shape(b)) is not None)
    numbers_of = [
        (row.amax, row.amin, row.bmax, row.bmin, row.gap) for row in sandbox.sat_table(shape(a), shape(b)).rows
    ]
    assert program["rows"](a, b) == numbers_of


@given(triangles | boxes, triangles | boxes)
def test_either_direction_round_and_any_first_vertex_will_do(a: Polygon, b: Polygon) -> None:
    a, b = list(a), list(b)
    turned = b[1:] + b[:1]
    assert program["colliding"](a, b) == program["colliding"](a[::-1], turned) == program["colliding"](b, a)


def test_a_concave_polygon_is_refused_with_the_cure() -> None:
    cup = [(2, 0), (8, 0), (10, 7), (8, 7), (7, 2), (3, 2), (2, 7), (0, 7)]
    stone = [(4, 6), (6, 5), (5, 3)]
    for a, b in ((cup, stone), (stone, cup)):
        with pytest.raises(ValueError, match="cut a concave one into convex parts"):
            program["rows"](a, b)
    assert sandbox.load_scene(LESSON / "cup.scene.json").to_data()["bodies"][0]["shapes"][0]["polygon"] == [
        list(vertex) for vertex in cup
    ], "the cup of the lesson is that of the scene"
