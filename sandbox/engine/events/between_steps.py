"""What commands do between two steps, as far as events have to know: bodies put elsewhere, and deleted ones."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from sandbox.tables import Integers, Records
from sandbox.world.roster import Roster
from sandbox.world.rows import Moved
from sandbox.world.state import State

if TYPE_CHECKING:
    from sandbox.engine.events.sensors import Sensing

Vec = tuple[float, float]


@dataclass(frozen=True)
class Side:
    """A shape of a parting that outlives changes of rows: its body's serial number and id, which of its shapes."""

    serial: int
    name: str
    shape: int


@dataclass(frozen=True)
class Parting:
    """Two shapes that came apart because a body of theirs was deleted; `figures` is x, y, normal x and y."""

    first: Side
    second: Side
    figures: tuple[float, ...] = ()


@dataclass(frozen=True)
class Ties:
    """What touched and what sensors felt before a deletion."""

    contacts: Any
    bodies: Records
    shape_bodies: Integers
    roster: Roster
    felt: Any

    @classmethod
    def of(cls, state: State, sensing: Sensing | None) -> Ties:
        """Those of now; deletions make new tables of bodies and shapes, but close up that of the contacts."""
        contacts = np.asarray(state.contacts[: int(state.counters[0].contact_count)])
        owners: Integers = np.asarray(state.shapes)["body"]
        felt = None if sensing is None else sensing.now
        return cls(contacts[contacts["touching"] == 1].copy(), state.bodies, owners, state.roster, felt)

    def side(self, body: int, shape: int) -> Side:
        """A shape by what stays the same."""
        register = self.roster.bodies
        first = int(np.searchsorted(self.shape_bodies, body))
        return Side(register.serials[body], register.names[body], shape - first)


class Interlude:
    """What happened to a world between its steps."""

    def __init__(self) -> None:
        self.places: dict[int, Vec] = {}
        """Where the centres of bodies (by row) were before commands put them elsewhere, m."""
        self.ends: list[Parting] = []
        """Contacts that the events of the last step have to tell as ended."""
        self.leaves: list[Parting] = []
        """The same for sensors (first) and what they felt (second)."""
        self._waiting: tuple[list[Parting], list[Parting]] = ([], [])

    def close(self) -> None:
        """A step begins: its events tell what was deleted before it."""
        (self.ends, self.leaves), self._waiting = self._waiting, ([], [])
        self.places = {}

    def note_pose(self, row: int, body: Records) -> None:
        """A command is about to put a body elsewhere."""
        self.places.setdefault(row, (float(body.center_x), float(body.center_y)))

    def note_rows(self, ties: Ties, moved: Moved) -> None:
        """Rows have moved: what ties had to the deleted bodies is over."""
        self.places = {}
        gone = moved.bodies < 0
        rows = ties.contacts[gone[ties.contacts["body_a"]] | gone[ties.contacts["body_b"]]]
        self._waiting[0].extend(_contact(ties, row) for row in rows)
        if ties.felt is not None:
            felt = ties.felt[gone[ties.felt.sensor_body] | gone[ties.felt.body]]
            sides = ((ties.side(r.sensor_body, r.sensor), ties.side(r.body, r.shape_index)) for r in felt)
            self._waiting[1].extend(Parting(*pair) for pair in sides)


def _contact(ties: Ties, row: Any) -> Parting:
    center, two = ties.bodies[row["body_a"]], row["point_count"] == 2
    x, y = (0.5 * (row[f"anchor_a{k}1"] + row[f"anchor_a{k}2"]) if two else row[f"anchor_a{k}1"] for k in "xy")
    figures = (center.center_x + x, center.center_y + y, row["normal_x"], row["normal_y"])
    sides = ties.side(row["body_a"], row["shape_a"]), ties.side(row["body_b"], row["shape_b"])
    return Parting(*sides, tuple(map(float, figures)))


class Finder:
    """Finds the rows of partings now, and gives deleted bodies places after all others in `names`."""

    def __init__(self, state: State) -> None:
        self._register = state.roster.bodies
        self._owners: Integers = np.asarray(state.shapes)["body"]
        self.names: tuple[str, ...] = state.names
        self._gone: dict[int, int] = {}

    def rows(self, part: Parting) -> tuple[int, int, int, int]:
        """The bodies' indices into `names`, and the rows of the shapes; -1 for one that is gone."""
        (a, shape_a), (b, shape_b) = self._find(part.first), self._find(part.second)
        return a, b, shape_a, shape_b

    def _find(self, side: Side) -> tuple[int, int]:
        row = self._register.row_of(side.serial)
        if row is not None:
            return row, int(np.searchsorted(self._owners, row)) + side.shape
        if side.serial not in self._gone:
            self._gone[side.serial] = len(self.names)
            self.names = (*self.names, side.name)
        return self._gone[side.serial], -1
