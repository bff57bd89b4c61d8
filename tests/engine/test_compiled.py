"""What is compiled before pytest's workers start can be called."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.compiled import PARTS


@pytest.mark.parametrize("part", PARTS.values(), ids=PARTS)
def test_each_part_runs(part: Callable[[], None]) -> None:
    part()
