"""From ids to rows, and what to say where there is nobody."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from sandbox.errors import SandboxError, UnknownBodyError, UnknownJointError, UnknownRegionError
from sandbox.scene.known import Known
from sandbox.world.state import State


class Directory:
    """The rows of a state by id, as they are now: make it anew when rows have gone; rows that come are added."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._bodies = _rows(state.names)
        self._joints = _rows(state.joint_names)
        self._counts = _counts(state)
        self._regions = _rows(region.id for region in state.roster.scene.regions)

    def add(self, bodies: Sequence[str], joints: Sequence[str]) -> None:
        """Rows come after all others, with those ids."""
        for rows, count, names in zip((self._bodies, self._joints), self._counts, (bodies, joints), strict=True):
            rows.update((name, row) for row, name in enumerate(names, count) if name)
        self._counts = self._counts[0] + len(bodies), self._counts[1] + len(joints)

    @property
    def is_complete(self) -> bool:
        """Whether it knows of as many bodies and joints as there are: no rows have gone since it was made."""
        return self._counts == _counts(self._state)

    def body(self, name: str) -> int:
        """The row of a body. Raises `UnknownBodyError` with the nearest name."""
        return _row("body", name, self._bodies, UnknownBodyError)

    def joint(self, name: str) -> int:
        """The row of a joint. Raises `UnknownJointError` with the nearest name."""
        return _row("joint", name, self._joints, UnknownJointError)

    def region(self, name: str) -> int:
        """The row of a region that has an id. Raises `UnknownRegionError` with the nearest name."""
        return _row("region", name, self._regions, UnknownRegionError)

    def known(self) -> Known:
        """What a body or a joint that comes may refer to."""
        bodies, joints = self._state.roster.bodies.items, self._state.roster.joints.items
        types = _Looked(self._bodies, len(bodies), lambda row: bodies[row].type)
        kinds = _Looked(self._joints, len(joints), lambda row: joints[row].kind)
        return Known(types, kinds, len(self._state.shapes))


class _Looked(Mapping[str, str]):
    """Something about what each id stands for, looked up when it is asked; what has no id only counts."""

    def __init__(self, rows: dict[str, int], count: int, ask: Callable[[int], str]) -> None:
        self._rows, self._count, self._ask = rows, count, ask

    def __getitem__(self, name: str) -> str:
        return self._ask(self._rows[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return self._count


def _counts(state: State) -> tuple[int, int]:
    return len(state.roster.bodies.items), len(state.roster.joints.items)


def _rows(names: Iterable[str]) -> dict[str, int]:
    return {name: row for row, name in enumerate(names) if name}


def _row(what: str, name: str, rows: dict[str, int], error: type[SandboxError]) -> int:
    if not isinstance(name, str):
        raise error(f"an id is a text, not {name!r}")
    if name not in rows:
        near = difflib.get_close_matches(name, rows, 1)
        raise error(f"no {what} {name!r} in this world" + (f"; did you mean {near[0]!r}?" if near else ""))
    return rows[name]
