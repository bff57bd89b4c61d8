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


@cache
def row(name: str) -> Row:
    return measure_one(EXPERIMENTS[NAMES.index(name)])


def test_each_experiment_has_its_own_name():
    assert len(set(NAMES)) == len(NAMES)


@pytest.mark.parametrize("each", EXPERIMENTS, ids=NAMES)
def test_we_are_as_near_to_the_truth_as_promised(each):
    assert row(each.name)[NAME] <= each.bound


@pytest.mark.parametrize("name", NAMES)
def test_nobody_is_nearer_to_the_truth(name):
    assert is_best(row(name)[NAME], row(name)), row(name)


def test_the_architecture_shows_these_rows():
    """The digits may differ from machine to machine; which experiments there are, and what they measure, may not."""
    text = Path(sandbox.__file__).with_name("TRUTH.md").read_text(encoding="utf-8")
    section = text
    rows = [line for line in section.splitlines() if line.startswith("| ")][1:]
    assert ["|".join(line.split("|")[:3]) + "|" for line in rows] == [head(each) for each in EXPERIMENTS]


def test_the_command_prints_json():
    command = [sys.executable, "-m", "tests.physics.truth", "free fall", "--json"]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=Path(__file__).parents[2])
    assert json.loads(done.stdout)["free fall"][NAME] == row("free fall")[NAME]
