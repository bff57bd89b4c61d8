"""The geometry API and the narrow phase under it against exact rational arithmetic.

`SANDBOX_PAIRS=100000 python -m pytest tests/geometry/test_oracle.py -n auto` runs as many pairs as it says; without
it there are 720 of each family, of which three quarters are marked slow.
"""

from __future__ import annotations

import os
from collections import Counter
from random import Random

import pytest
from hypothesis import given

from tests.examples import examples
from tests.geometry.judged import judge
from tests.geometry.shape_families import FAMILIES, pairs

EACH = -(-int(os.environ.get("SANDBOX_PAIRS", 7200)) // len(FAMILIES))
CHUNKS = 8
LATER = [] if "SANDBOX_PAIRS" in os.environ else [pytest.mark.slow]


@pytest.mark.parametrize("chunk", [pytest.param(k, marks=LATER if 4 * k >= CHUNKS else []) for k in range(CHUNKS)])
@pytest.mark.parametrize("family", FAMILIES)
def test_no_pair_is_judged_wrongly(family: str, chunk: int) -> None:
    seen: Counter[int] = Counter()
    for k in range(chunk, EACH, CHUNKS):
        a, b = FAMILIES[family](Random(f"{family}/{k}"))
        try:
            seen[judge(a, b)] += 1
        except Exception as error:
            raise AssertionError(f"{family}/{k}: {error}\na = {a!r}\nb = {b!r}") from error
    assert sum(seen.values()) == len(range(chunk, EACH, CHUNKS))
    assert len(seen) > 1, "a family that always gives the same verdict proves little"


@given(pairs)
@examples(400)
def test_no_pair_is_found_that_is_judged_wrongly(pair):
    judge(*pair)
