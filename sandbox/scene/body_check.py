"""Whether ids and patterns mean bodies, with a bound on how many are compared."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.scene.body_refs import is_pattern, matches_any
from sandbox.scene.finding import TAKEN, Finding, Path, quoted
from sandbox.scene.limits import MAX_MATCHES, MAX_NAME
from sandbox.scene.names import BodyNames
from sandbox.scene.near_names import is_misspelling, near_pattern, nearest

_TOO_MANY = f"there are too many patterns for so many bodies; patterns times bodies may be {MAX_MATCHES:,}"


class BodyCheck:
    """Looks up what a part of a scene, at `home`, calls bodies; `given_up` once there were too many patterns."""

    def __init__(self, ids: BodyNames, home: Path) -> None:
        self._ids, self._home = ids, home
        self._known: dict[str, bool] = {}
        self._left = MAX_MATCHES
        self.given_up = False

    def faults(self, name: str, place: Path) -> Iterator[Finding]:
        """A finding if an id or pattern means no body; at most one in all about too many patterns."""
        if len(name) > MAX_NAME or self.given_up:  # its own model says so
            return
        if name not in self._known:
            self._left -= len(self._ids) if is_pattern(name) else 0
            if self._left < 0:
                self.given_up = True
                yield Finding(self._home, _TOO_MANY)
                return
            self._known[name] = _is_known(name, self._ids)
        if not self._known[name]:
            yield unknown_body(name, place, self._ids)


def _is_known(name: str, ids: BodyNames) -> bool:
    """Whether an id or pattern means a body, or may mean one of a generator that cannot be read."""
    if is_pattern(name):
        return bool(ids.unread) or matches_any(name, ids) or matches_any(name, ids.spawned_ids())
    return name in ids or ids.is_spawned(name) or ids.is_unread(name)


def unknown_body(name: str, place: Path, ids: BodyNames) -> Finding:
    """The finding about an id or pattern that means no body."""
    known = [*ids.spawned_ids(), *ids]
    lacks: tuple[str, ...] = ("bodies", "generate", "rules", "controls")
    if is_pattern(name):
        hint = near_pattern(name, known)
        return Finding(place, f"no body's id matches {quoted(name)}", hint, lacks=lacks if hint else (*lacks, TAKEN))
    near = nearest(name, known)
    hint = f'did you mean "{near}"?' if near else ""
    lacks = lacks if is_misspelling(name, near) else (*lacks, TAKEN)
    return Finding(place, f"no body has the id {quoted(name)}", hint, lacks=lacks)
