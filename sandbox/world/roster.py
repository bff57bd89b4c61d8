"""Who is behind the rows: the bodies, joints and regions of the scene that are still there, then what was spawned.

Everything has a *serial number* that nothing else ever gets: its place in the scene, or the next free number. Rows are
in the order of serial numbers. A snapshot holds the numbers, and the words of what the scene does not know.
"""

from __future__ import annotations

import json
from bisect import bisect_left
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Generic, TypeAlias, TypeVar

from sandbox.scene.flat import FlatBody, FlatJoint, FlatRegion, FlatScene

T = TypeVar("T", bound=FlatBody | FlatJoint | FlatRegion)
Words: TypeAlias = dict[str, Any]
"""An entry of `bodies`, `joints` or `regions`, as a scene file holds it."""


@dataclass(frozen=True)
class Register(Generic[T]):
    """One table's part of a roster: what is behind each row, its serial number, and the words of what was spawned.

    It never changes; `census` has the one that does.
    """

    items: tuple[T, ...]
    serials: tuple[int, ...]
    words: Mapping[int, Words]
    next: int

    @classmethod
    def of(cls, items: Sequence[T]) -> Register[T]:
        """That of a scene."""
        return cls(tuple(items), tuple(range(len(items))), {}, len(items))

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The ids, row by row."""
        return tuple(item.id for item in self.items)

    def row_of(self, serial: int) -> int | None:
        """The row of what has that serial number; None if it is gone."""
        row = bisect_left(self.serials, serial)
        return row if row < len(self.serials) and self.serials[row] == serial else None

    def only(self, rows: Sequence[int]) -> Register[T]:
        """With only those rows."""
        serials = tuple(map(self.serials.__getitem__, rows))
        left = set(serials) if self.words else ()
        words = {serial: entry for serial, entry in self.words.items() if serial in left}
        fewer = replace(self, items=tuple(map(self.items.__getitem__, rows)), serials=serials, words=words)
        vars(fewer)["names"] = tuple(map(self.names.__getitem__, rows))
        return fewer

    def plain(self, of_scene: int) -> dict[str, Any]:
        """As plain data: runs of rows of the scene that are left, and the words of the others."""
        runs: list[list[int]] = []
        for serial in (serial for serial in self.serials if serial < of_scene):
            if runs and runs[-1][1] == serial:
                runs[-1][1] += 1
            else:
                runs.append([serial, serial + 1])
        spawned = [[serial, self.words[serial]] for serial in self.serials if serial >= of_scene]
        return {"left": runs, "spawned": spawned, "next": self.next}


@dataclass(frozen=True)
class Roster:
    """Everybody in a world that began as `scene`."""

    scene: FlatScene
    bodies: Register[FlatBody]
    joints: Register[FlatJoint]
    regions: Register[FlatRegion]

    @classmethod
    def of(cls, scene: FlatScene) -> Roster:
        """The roster of a world in which nothing has been spawned or deleted."""
        return cls(scene, Register.of(scene.bodies), Register.of(scene.joints), Register.of(scene.regions))

    @cached_property
    def flat(self) -> FlatScene:
        """The scene with the bodies, joints and regions of now, row by row."""
        return replace(self.scene, bodies=self.bodies.items, joints=self.joints.items, regions=self.regions.items)

    @cached_property
    def changed(self) -> bool:
        """Whether anything has ever been spawned or deleted."""
        return any(
            (len(register.items), register.next) != (len(getattr(self.scene, name)),) * 2
            for name, register in self._parts
        )

    @cached_property
    def text(self) -> bytes:
        """What a snapshot keeps of it: JSON, or nothing while it is that of the scene."""
        if not self.changed:
            return b""
        plain = {name: register.plain(len(getattr(self.scene, name))) for name, register in self._parts}
        return json.dumps(plain, separators=(",", ":")).encode()

    @property
    def _parts(self) -> tuple[tuple[str, Register[Any]], ...]:
        """The registers by the names that their lists have in a scene."""
        return ("bodies", self.bodies), ("joints", self.joints), ("regions", self.regions)
