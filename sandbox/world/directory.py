"""From ids to rows, and what to say where there is nobody."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from sandbox.arguments import shown
from sandbox.errors import CommandError, SandboxError, UnknownBodyError, UnknownJointError, UnknownRegionError
from sandbox.scene.known import Known
from sandbox.scene.near_names import nearest
from sandbox.world.census import Ledger
from sandbox.world.state import State

_MOST_DIGITS = 9
"""Of the number of a region without an id."""


class Directory:
    """The rows of a state by id, as they are now. Whoever adds or removes rows says so; a new census needs a new one.

    It leads to serial numbers, and the census from there to rows, so that it need not follow those that move.
    """

    def __init__(self, state: State) -> None:
        self._state = state
        self._census = census = state.census
        """The same while rows are still to come or go: who asks for it by the state has them come and go."""
        self._bodies: dict[str, int] = {}
        self._joints: dict[str, int] = {}
        self._regions: dict[str, int] = {}
        self.add(*map(len, census))
        self._controls = {control.id: row for row, control in enumerate(census.scene.controls)}

    def add(self, bodies: int, joints: int, regions: int) -> None:
        """So many have come after all others."""
        census = self._census
        for known, ledger, count in (
            (self._bodies, census.bodies, bodies), (self._joints, census.joints, joints),
            (self._regions, census.regions, regions),
        ):  # fmt: skip
            if count:
                known.update(_serials(ledger, count))

    def remove(self, bodies: Sequence[str] = (), joints: Sequence[str] = (), regions: Sequence[str] = ()) -> None:
        """There are none of those names any longer."""
        for serials, names in ((self._bodies, bodies), (self._joints, joints), (self._regions, regions)):
            for name in names:
                serials.pop(name, None)

    def has_body(self, name: str) -> bool:
        """Whether there is a body of that id."""
        return name in self._bodies

    def body(self, name: str) -> int:
        """The row of a body. Raises `UnknownBodyError` with the nearest name."""
        return _row(self._state.census.bodies, self.body_serial(name))

    def joint(self, name: str) -> int:
        """The row of a joint. Raises `UnknownJointError` with the nearest name."""
        return _row(self._state.census.joints, self.joint_serial(name))

    def body_serial(self, name: str) -> int:
        """The serial number of a body. Raises as `body`."""
        return _looked_up("body", name, self._bodies, UnknownBodyError)

    def joint_serial(self, name: str) -> int:
        """The serial number of a joint. Raises as `joint`."""
        return _looked_up("joint", name, self._joints, UnknownJointError)

    def region(self, name: str) -> int:
        """The row of a region: by its id, or as #2 if it is the second of the scene and has none.

        Raises `UnknownRegionError` with the nearest name.
        """
        found = self.find_region(name)
        if found is not None:
            return found
        return _row(self._state.census.regions, _looked_up("region", name, self._regions, UnknownRegionError))

    def find_region(self, name: str | None) -> int | None:
        """The same; None if there is no such region."""
        regions = self._state.census.regions
        if not isinstance(name, str):
            return None
        if name in self._regions:
            return _row(regions, self._regions[name])
        number = name.removeprefix("#")
        if number == name or not (number.isascii() and number.isdigit()) or len(number) > _MOST_DIGITS:
            return None
        row = regions.row_of(int(number) - 1)
        return row if row is not None and regions.called(row) == name else None

    def control(self, name: str) -> int:
        """The row of a control. Raises `CommandError` with the nearest name."""
        return _looked_up("control", name, self._controls, CommandError)

    def standing(self, name: str) -> int:
        """The row of a body in the tables as they are, though others are still to go. Raises as `body`."""
        return _row(self._census.bodies, self.body_serial(name))

    def announce(self, names: Sequence[str], after: int) -> None:
        """Bodies of those names will come, after so many others that will: their ids are taken."""
        first = self._census.bodies.next + after
        self._bodies.update({name: first + k for k, name in enumerate(names) if name})

    def known(self, shapes: int, coming: int = 0) -> Known:
        """What a body or a joint that comes may refer to, where there are so many shapes, and so many bodies come."""
        census = self._census
        types = _Looked(self._bodies, census.bodies, lambda body: body.type, coming)
        kinds = _Looked(self._joints, census.joints, lambda joint: joint.kind)
        return Known(types, kinds, shapes, self._regions, len(census.regions))


class _Looked(Mapping[str, str]):
    """Something about what each id stands for, looked up when it is asked; what has no id only counts."""

    def __init__(self, serials: dict[str, int], ledger: Ledger[Any], ask: Callable[[Any], str], more: int = 0) -> None:
        self._serials, self._ledger, self._ask, self._more = serials, ledger, ask, more

    def __getitem__(self, name: str) -> str:
        return self._ask(self._ledger.items[_row(self._ledger, self._serials[name])])

    def __contains__(self, name: object) -> bool:
        return name in self._serials

    def __iter__(self) -> Iterator[str]:
        return iter(self._serials)

    def __len__(self) -> int:
        return len(self._ledger) + self._more


def _serials(ledger: Ledger[Any], last: int) -> dict[str, int]:
    """The serial numbers of the last rows by their names."""
    first = len(ledger) - last
    return {name: serial for name, serial in zip(ledger.names[first:], ledger.serials[first:], strict=True) if name}


def _row(ledger: Ledger[Any], serial: int) -> int:
    row = ledger.row_of(serial)
    assert row is not None
    return row


def _looked_up(what: str, name: str, known: dict[str, int], error: type[SandboxError]) -> int:
    found = known.get(name) if isinstance(name, str) else None
    if found is not None:
        return found
    if not isinstance(name, str):
        raise error(f"an id is a text, not {shown(name)}")
    near = nearest(name, known)
    raise error(f"no {what} {shown(name)} in this world" + (f"; did you mean {near!r}?" if near else ""))
