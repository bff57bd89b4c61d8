"""The lesson tells the truth: its commands run, its printed tables and pictures are what they give today."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest

from sandbox.resources import find_scene, shipped_scenes
from tests.cli.conftest import cli  # noqa: F401

LESSON = Path(__file__).parents[1] / "scenes" / "sat"
TEXT = (LESSON / "README.md").read_text(encoding="utf-8")
DRAWN = re.findall(r"^sandbox (sat .* --svg (\S+))$", TEXT, re.MULTILINE)
PRINTED = re.findall(r"^```text\n\$ sandbox (sat [^\n]*)\n(.*?)^```", TEXT, re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize(("command", "name"), DRAWN, ids=[name for _, name in DRAWN])
def test_every_picture_is_what_its_command_draws_today(cli: Callable, tmp_path: Path, command: str, name: str) -> None:  # noqa: F811
    arguments = [str(tmp_path / name) if part == name else part for part in shlex.split(command)]
    assert cli(*arguments).code == 0
    # To draw it anew: run the command in scenes/sat.
    assert (tmp_path / name).read_text(encoding="utf-8") == (LESSON / name).read_text(encoding="utf-8")


@pytest.mark.parametrize(("command", "printed"), PRINTED, ids=[command for command, _ in PRINTED])
def test_every_printed_table_is_what_its_command_prints(cli: Callable, command: str, printed: str) -> None:  # noqa: F811
    assert cli(*shlex.split(command)).out == printed


def test_every_section_but_two_has_a_command_and_a_picture_and_no_picture_is_left_over() -> None:
    sections = re.split(r"^## ", TEXT, flags=re.MULTILINE)[1:]
    assert [section.split(".")[0] for section in sections] == [str(number) for number in range(1, 19)]
    without = [section for section in sections if section.startswith(("16. The program\n", "18. Exercises\n"))]
    assert len(without) == 2
    for section in sections:
        if section in without:
            continue
        assert re.search(r"^sandbox sat ", section, re.MULTILINE), section[:30]
        assert re.search(r"^!\[[^\]]{20,}\]\([a-z-]+\.svg\)$", section, re.MULTILINE), section[:30]
    shown = re.findall(r"\]\(([a-z-]+\.svg)\)", TEXT)
    assert sorted(shown) == sorted(file.name for file in LESSON.glob("*.svg")) == sorted(name for _, name in DRAWN)


def test_every_test_it_names_exists() -> None:
    tests = (Path(__file__).parent / "geometry" / "test_tutorial_slips.py").read_text(encoding="utf-8")
    named = re.findall(r"`(test_\w+)`", TEXT)
    assert len(named) == 6
    assert [name for name in named if f"def {name}(" not in tests] == []


def test_links_within_it_lead_somewhere() -> None:
    headings = {
        re.sub(r"[^\w -]", "", line).strip().lower().replace(" ", "-") for line in re.findall(r"^## (.*)$", TEXT, re.M)
    }
    targets = re.findall(r"\]\(#([^)]+)\)", TEXT)
    assert set(targets) == headings, "every section is in the table at the top"
    for file in re.findall(r"\]\(([^#)]+)\)", TEXT):
        assert (LESSON / file).is_file(), file


@pytest.mark.parametrize("scene", re.findall(r"`sandbox run ([a-z-]+)`", TEXT))
def test_every_scene_it_lets_run_is_shipped(scene: str) -> None:
    assert find_scene(Path(scene)).is_file()


def test_its_scenes_are_small_enough_to_travel() -> None:
    assert sum(file.stat().st_size for file in LESSON.iterdir()) < 200_000
    assert {file.name.split(".")[0] for file in shipped_scenes() if file.parent == LESSON} >= {"test-one", "test-two"}
