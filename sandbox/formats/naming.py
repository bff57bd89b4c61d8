"""Names of a foreign file as ids of a scene."""

from __future__ import annotations

import re

from sandbox.scene.limits import MAX_NAME

_STRANGE = re.compile(r"[^\w.:-]+")
_ROOM = 10
"""Characters left for what makes a name unique."""


class Names:
    """Gives every body, or joint, an id of its own: what an id cannot hold becomes "-", a second one gets a number."""

    def __init__(self) -> None:
        self._taken: set[str] = set()
        self._next: dict[str, int] = {}

    def take(self, name: str, otherwise: str) -> str:
        """An id made of `name`, or of `otherwise` where that is empty."""
        plain = _STRANGE.sub("-", name).strip("-")[: MAX_NAME - _ROOM] or otherwise
        found = plain
        while found in self._taken:
            number = self._next.get(plain, 2)
            self._next[plain] = number + 1
            found = f"{plain}-{number}"
        self._taken.add(found)
        return found
