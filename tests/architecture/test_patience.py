"""No test has a time limit that a busy machine can break, and property tests look at what the profile gives them."""

from __future__ import annotations

import re
from pathlib import Path

TESTS = Path(__file__).parents[1]
LIMITS = re.compile(r"\b(timeout|deadline|max_examples)=|\b(perf_counter|monotonic)\(")
ALLOWED = {
    "conftest.py": "sets the profiles",
    "examples.py": "gives each property test its share",
    "cli/test_writing.py": "gives up on processes that do not end after half an hour",
    "report/browser.py": "gives up on a browser after half an hour",
}


def test_only_those_who_may_speak_of_time_limits_and_numbers_of_examples() -> None:
    files = [file for file in TESTS.rglob("*.py") if file != Path(__file__) and file.parent.name != "benchmarks"]
    found = {file.relative_to(TESTS).as_posix() for file in files if LIMITS.search(file.read_text(encoding="utf-8"))}
    assert len(files) > 100
    assert found == ALLOWED.keys()
