"""What a scene cannot carry over of a world, one line for each reason."""

from __future__ import annotations

_SHOWN = 5


class Remarks:
    """Collects reasons, and the ids of those that they hold for."""

    def __init__(self) -> None:
        self._found: dict[str, list[str]] = {}

    def note(self, reason: str, name: str = "") -> None:
        """Something is left out or changed; `name` is the id of what it is about."""
        names = self._found.setdefault(reason, [])
        if name and name not in names:
            names.append(name)

    def lines(self) -> tuple[str, ...]:
        """The reasons in the order in which they came up, each with the ids."""
        return tuple(f"{reason}{_listed(names)}" for reason, names in self._found.items())


def _listed(names: list[str]) -> str:
    if not names:
        return ""
    more = f" and {len(names) - _SHOWN} more" if len(names) > _SHOWN else ""
    return f": {', '.join(names[:_SHOWN])}{more}"
