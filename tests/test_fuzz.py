"""Thousands of damaged files, each in bounds of time and memory: `tests/fuzz`. Any number: `python -m tests.fuzz`."""

from __future__ import annotations

import pytest
from hypothesis import settings

pytest.importorskip("resource", reason="the bounds of time and memory are those of POSIX")

from tests.fuzz import budget
from tests.fuzz.budget import OverBudgetError, within_budget
from tests.fuzz.kinds import KINDS, make_case, text_of
from tests.fuzz.run import run_cases, shares

CASES = 10_000
"""A tenth of it where tests are to be quick."""
SEED = 1


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.slow(seconds=20)
def test_damaged_files_are_refused_or_run(kind: str) -> None:
    count = shares(CASES // 10 if settings.default.derandomize else CASES, list(KINDS))[kind]
    assert [*run_cases(kind, SEED, 0, count, lambda _: None)] == []


@pytest.mark.parametrize("kind", KINDS)
def test_a_case_is_the_same_whenever_it_is_made(kind: str) -> None:
    assert text_of(make_case(kind, 3, 14)) == text_of(make_case(kind, 3, 14))


@pytest.mark.slow
def test_what_takes_too_long_or_too_much_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budget, "SECONDS", 1000.0)
    with pytest.raises(OverBudgetError, match="MB of memory"):
        within_budget(lambda: len(b"x" * 600_000_000) * 0)
    monkeypatch.setattr(budget, "SECONDS", 0.001)
    with pytest.raises(OverBudgetError, match="processor time"):
        within_budget(lambda: sum(k & 1 for k in range(1_000_000)) * 0)
