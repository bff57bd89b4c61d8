"""The lesson on sequential impulses tells the truth: its commands run, its tables and pictures are what they give."""

from __future__ import annotations

import math
import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest

from sandbox.reference.simple.techniques import SWITCHES
from sandbox.resources import shipped_scenes
from sandbox.scene import load_scene
from tests.cli.conftest import cli  # noqa: F401

LESSON = Path(__file__).parents[1] / "scenes" / "solver"
TEXT = (LESSON / "README.md").read_text(encoding="utf-8")
DRAWN = re.findall(r"^sandbox (solver .*) --svg (\S+)$", TEXT, re.MULTILINE)
PRINTED = dict(re.findall(r"^```text\n\$ sandbox (solver [^\n]*)\n(.*?)^```", TEXT, re.MULTILINE | re.DOTALL))
ALONE = [command for command in PRINTED if command not in {drawn for drawn, _ in DRAWN}]


LONG = {"ends.svg", "soft.svg", "substeps.svg", "warm-starting.svg"}


@pytest.mark.parametrize(
    ("command", "name"),
    [pytest.param(*each, marks=[pytest.mark.slow] if each[1] in LONG else [], id=each[1]) for each in DRAWN],
)
def test_every_picture_is_what_its_command_draws_today(cli: Callable, tmp_path: Path, command: str, name: str) -> None:  # noqa: F811
    done = cli(*shlex.split(command), "--svg", tmp_path / name)
    assert done.code == 0
    *printed, last = done.out.splitlines(keepends=True)
    assert re.fullmatch(r".*\.svg: \d+ kB\n", last)
    # To draw it anew: run the command in scenes/solver.
    assert (tmp_path / name).read_text(encoding="utf-8") == (LESSON / name).read_text(encoding="utf-8")
    if command in PRINTED:
        assert "".join(printed) == PRINTED[command]


@pytest.mark.parametrize("command", ALONE)
def test_every_other_table_is_what_its_command_prints(cli: Callable, command: str) -> None:  # noqa: F811
    assert cli(*shlex.split(command)).out == PRINTED[command]


def test_every_section_has_a_command_and_a_picture_and_no_picture_is_left_over() -> None:
    sections = re.split(r"^## ", TEXT, flags=re.MULTILINE)[1:]
    assert len(sections) == 11
    for section in sections[:-1]:
        assert re.search(r"^sandbox solver ", section, re.MULTILINE), section[:30]
        assert re.search(r"^!\[[^\]]{20,}\]\([a-z-]+\.svg\)$", section, re.MULTILINE), section[:30]
    shown = re.findall(r"\]\(([a-z-]+\.svg)\)", TEXT)
    assert sorted(shown) == sorted(file.name for file in LESSON.glob("*.svg")) == sorted(name for _, name in DRAWN)


def test_every_switch_has_a_scene_without_it_beside_one_with_it() -> None:
    named = dict(re.findall(r"^\| `(\w+)` \| .* \| `(without-[a-z-]+)` \|", TEXT, re.MULTILINE))
    assert sorted(named) == sorted(SWITCHES)
    shipped = {file.name.split(".")[0]: file for file in shipped_scenes() if file.parent == LESSON}
    assert sorted(named.values()) == sorted(name for name in shipped if name.startswith("without-"))
    for switch, name in named.items():
        settings = load_scene(shipped[name]).settings
        assert [other for other in SWITCHES if not getattr(settings, other)] == [switch]
        assert load_scene(shipped[name].with_name(name + ".scene.json")).expect


def test_the_figures_between_the_tables_follow_from_the_formulas() -> None:
    """Lengths and masses of the plank, speeds by hand; the others stand in tables."""
    inertia = (4.0**2 + 0.5**2) / 12.0
    arm = 2.0 * math.cos(math.pi / 6) - 0.25 * math.sin(math.pi / 6)
    mass = 1.0 / (1.0 + arm * arm / inertia)
    assert f"{mass:.3f} kg" == "0.344 kg"
    assert f"3 - {3 * mass:.3f} = {3 - 3 * mass:.3f} m/s" == "3 - 1.032 = 1.968 m/s"
    for said in ("0.344 kg", "3 - 1.032 = 1.968 m/s", "112 passes", "0.48 m/s", "19 m/s", "15 Hz", "0.0124 m/s"):
        assert said in TEXT
    assert round(math.log(0.5) / math.log(math.cos(math.pi / 40.0) ** 2)) == 112
    assert pytest.approx(0.48) == 0.2 * 0.01 * 240
    assert round(0.2 * 0.4 * 240) == 19
    first = 1.0 / (1.0 + 6.0 / 16.0)
    second = first * (1.0 - first * (1.0 - 6.0 / 16.0))
    assert f"{0.1 * (first + second - 1.0):.4f} m/s" == "0.0124 m/s"


def test_links_within_it_lead_somewhere() -> None:
    headings = {
        re.sub(r"[^\w -]", "", line).strip().lower().replace(" ", "-") for line in re.findall(r"^## (.*)$", TEXT, re.M)
    }
    for target in re.findall(r"\]\(#([^)]+)\)", TEXT):
        assert target in headings
    for file in re.findall(r"\]\((\.\./[^)]+)\)", TEXT):
        assert (LESSON / file).is_file()


def test_the_solver_fits_on_two_screens() -> None:
    lines = (LESSON / "../../sandbox/reference/simple/solver.py").read_text(encoding="utf-8").splitlines()
    assert len(lines) <= 150
    assert "_softness" in "\n".join(lines)
    line = "before, p.normal = p.normal, max(p.normal + change, 0.0)"
    assert line in TEXT
    assert line in "\n".join(lines)


def test_pictures_and_scenes_are_small_enough_to_travel() -> None:
    assert sum(file.stat().st_size for file in LESSON.iterdir()) < 400_000
