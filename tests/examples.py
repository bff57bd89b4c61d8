"""How many examples a property test looks at."""

from __future__ import annotations

from typing import Any

from hypothesis import settings


def examples(count: int, **others: Any) -> settings:
    """`count` in the profile `thorough`, else a share of it and at least 5; `others` as in `hypothesis.settings`."""
    share = settings.default.max_examples
    return settings(max_examples=max(min(count, 5), count * share // 100), **others)
