"""What rules and controls did, for those who ask for the events of a step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

HAPPENINGS = ("counter", "spawn", "delete", "win", "lose", "refused")
"""The kinds, in no order: what rules did is told in the order in which they did it."""


@dataclass(frozen=True)
class Happening:
    """One of `HAPPENINGS`; `facts` are its figures by name, `by` is the id of the rule or control, or empty."""

    event: str
    facts: tuple[tuple[str, Any], ...]
    by: str = ""

    def plain(self) -> dict[str, Any]:
        """As plain data, without the step."""
        return {**dict(self.facts), **({"by": self.by} if self.by else {})}
