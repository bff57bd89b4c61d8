"""Who an id or a pattern means, among those that are there now."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fnmatch import translate

from sandbox.scene.body_refs import is_pattern
from sandbox.scene.flat_rules import Names

_MOST = 100_000


class Selector:
    """Ids and patterns that are asked about again and again; what was found for a name is kept."""

    def __init__(self, names: Names) -> None:
        self._exact = frozenset(name for name in names if not is_pattern(name))
        self._patterns = [re.compile(translate(name)) for name in names if is_pattern(name)]
        self._known: dict[str, bool] = {}

    def __contains__(self, name: str) -> bool:
        if not self._patterns:
            return name in self._exact
        found = self._known.get(name)
        if found is None:
            if len(self._known) >= _MOST:
                self._known.clear()
            found = name in self._exact or any(pattern.match(name) for pattern in self._patterns)
            self._known[name] = found
        return found

    @property
    def ids(self) -> frozenset[str] | None:
        """All that it may mean; None if it has patterns."""
        return None if self._patterns else self._exact

    @property
    def is_several(self) -> bool:
        """Whether it has patterns."""
        return bool(self._patterns)

    def among(self, names: Sequence[str]) -> list[str]:
        """Those of some names that are meant, in their order."""
        return [name for name in names if name in self]
