"""Every experiment of `tests/physics/truth`: our error is small, and nobody's is smaller."""

from __future__ import annotations

import json
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

import sandbox
from tests.physics.truth.ours import NAME
from tests.physics.truth.table import EXPERIMENTS, Row, head, is_best, measure_one

NAMES = [each.name for each in EXPERIMENTS]
BEHIND = {
    "box put on a slope: slip until it holds": "contacts against the ground are softer than Box2D's",
    "pendulum at 0.2 rad": "two errors of Box2D cancel at 0.19 rad: it is worse below 0.05 and above 0.3",
}
"""Experiments in which another engine is better, and why."""


@cache
def row(name: str) -> Row:
    return measure_one(EXPERIMENTS[NAMES.index(name)])


def test_each_experiment_has_its_own_name():
    assert len(set(NAMES)) == len(NAMES)
    assert set(BEHIND) <= set(NAMES)


@pytest.mark.parametrize("each", EXPERIMENTS, ids=NAMES)
def test_we_are_as_near_to_the_truth_as_promised(each):
    assert row(each.name)[NAME] <= each.bound


@pytest.mark.parametrize("name", [name for name in NAMES if name not in BEHIND])
def test_nobody_is_nearer_to_the_truth(name):
    assert is_best(row(name)[NAME], row(name)), row(name)


@pytest.mark.parametrize("name", BEHIND)
def test_where_we_are_behind_is_still_so(name):
    pytest.importorskip("pyb2d3")
    assert not is_best(row(name)[NAME], row(name)), f"{name}: take it off the list"


def test_the_architecture_shows_these_rows():
    """The digits may differ from machine to machine; which experiments there are, and what they measure, may not."""
    text = Path(sandbox.__file__).with_name("ARCHITECTURE.md").read_text(encoding="utf-8")
    section = text.split("## Truth", 1)[1].split("\n## ", 1)[0]
    rows = [line for line in section.splitlines() if line.startswith("| ")][1:]
    assert ["|".join(line.split("|")[:3]) + "|" for line in rows] == [head(each) for each in EXPERIMENTS]


def test_the_command_prints_json():
    command = [sys.executable, "-m", "tests.physics.truth", "free fall", "--json"]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=Path(__file__).parents[2])
    assert json.loads(done.stdout)["free fall"][NAME] == row("free fall")[NAME]
