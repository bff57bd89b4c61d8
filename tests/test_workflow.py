"""The workflow for GitHub tells the truth: its Pythons are the package's, its commands and options exist."""

from __future__ import annotations

import re
import tomllib

import pytest

from tests.test_guides import ROOT, check_options, said

WORKFLOW = ROOT / ".github" / "workflows" / "bits.yml"
TEXT = WORKFLOW.read_text(encoding="utf-8")
LINES = [line.strip() for line in TEXT.splitlines()]
COMMANDS = [line.removeprefix("- run: ") for line in LINES if re.match(r"(- run: )?sandbox ", line)]


def test_it_runs_every_python_that_the_package_names() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    named = re.findall(r"Python :: (3\.\d+)", " ".join(project["classifiers"]))
    for matrix in re.findall(r"python: \[(.*)\]", TEXT):
        assert re.findall(r'"(.*?)"', matrix) == named
    assert project["requires-python"] == f">={named[0]}"


def test_it_asks_for_the_same_bits() -> None:
    assert "sandbox replay scenes" in COMMANDS
    assert '- run: python -m pytest tests/determinism -m "not benchmark"' in LINES


@pytest.mark.parametrize("line", COMMANDS)
def test_its_commands_have_the_options_that_it_names(line: str) -> None:
    check_options(*said(line))


def test_files_it_runs_are_there() -> None:
    assert "- run: .ci/run" in LINES
    assert (ROOT / ".ci" / "run").is_file()
