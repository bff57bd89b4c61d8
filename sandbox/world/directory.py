"""From ids to rows, and what to say where there is nobody."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

from sandbox.errors import SandboxError, UnknownBodyError, UnknownJointError, UnknownRegionError
from sandbox.scene.known import Known
from sandbox.world.state import State


class Directory:
    """The rows of a state by id, as they are now: make it anew when rows have moved."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._bodies = _rows(state.names)
        self._joints = _rows(state.joint_names)
        self._regions = _rows(region.id for region in state.roster.scene.regions)

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
        types, kinds = {body.id: body.type for body in bodies}, {joint.id: joint.kind for joint in joints}
        return Known(types, kinds, len(self._state.shapes))


def _rows(names: Iterable[str]) -> dict[str, int]:
    return {name: row for row, name in enumerate(names) if name}


def _row(what: str, name: str, rows: dict[str, int], error: type[SandboxError]) -> int:
    if not isinstance(name, str):
        raise error(f"an id is a text, not {name!r}")
    if name not in rows:
        near = difflib.get_close_matches(name, rows, 1)
        raise error(f"no {what} {name!r} in this world" + (f"; did you mean {near[0]!r}?" if near else ""))
    return rows[name]
