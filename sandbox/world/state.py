"""The state of a world: a handful of record arrays and who is behind their rows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from sandbox.tables import FloatWords, Records, WholeWords, words
from sandbox.world.census import Census
from sandbox.world.contact_rows import Resting
from sandbox.world.joined import Joined
from sandbox.world.patterns import KnownPatterns
from sandbox.world.records import BODY_WORDS
from sandbox.world.roster import Roster
from sandbox.world.tile_rows import Tiling

ARRAYS = (
    "bodies", "shapes", "vertices", "outlines", "seams", "contacts", "joints", "drags", "regions", "edges", "thrusters",
    "settings", "counters", "controls", "tallies", "rules", "spawners", "sensings", "paths", "outcome",
)  # fmt: skip
"""The record arrays of a state in the order of `records.TABLES`."""


@dataclass
class State:
    """Everything that a step reads and writes, and nothing else. Scratch memory lives in the engine.

    `contacts` has spare rows; the first `counters[0].contact_count` are in use. `settings` and `counters` have one row
    each; `tallies` are the counters of the scene's rules. `census` says who is behind the rows, `origin` tells the
    world from those of other scenes (`snapshot.origin`), and `layout` counts how often the rows have moved, or centres
    of mass in their bodies: while it stays the same, row `i` is the same body, and its shapes lie where they did.
    `tiling` says which shapes are tiles and where they lie, `joined` who is joined to whom, once that was asked;
    `patterns` are those of what was spawned; `resting` is what the engine knows of sleepers.
    """

    bodies: Records
    shapes: Records
    vertices: Records
    outlines: Records
    seams: Records
    contacts: Records
    joints: Records
    drags: Records
    regions: Records
    edges: Records
    thrusters: Records
    settings: Records
    counters: Records
    controls: Records
    tallies: Records
    rules: Records
    spawners: Records
    sensings: Records
    paths: Records
    outcome: Records
    census: Census
    origin: bytes
    layout: int = 0
    tiling: Tiling | None = None
    joined: Joined | None = None
    resting: Resting | None = field(default=None, repr=False)
    patterns: KnownPatterns = field(default_factory=KnownPatterns)
    _body_words: tuple[Records, FloatWords, WholeWords] | None = field(default=None, init=False, repr=False)
    """The words of a table of bodies, which is another one when bodies have come or gone."""
    _deferred: Callable[[], None] | None = field(default=None, init=False, repr=False)
    """What brings it up to date, while it is `Deferring`."""

    def defer(self, apply: Callable[[], None]) -> None:
        """Something is still to be changed in it: whoever asks for anything has `apply` called first."""
        self._deferred = apply
        self.__class__ = Deferring

    def body_words(self, row: int) -> tuple[FloatWords, WholeWords]:
        """The words of a body's row as floats and as whole numbers, by `BodyPlace`."""
        known = self._body_words
        if known is None or known[0] is not self.bodies:
            known = self._body_words = self.bodies, *words(self.bodies)
        own = slice(row * BODY_WORDS, (row + 1) * BODY_WORDS)
        return known[1][own], known[2][own]

    @property
    def roster(self) -> Roster:
        """Who is behind the rows at this moment, to be kept."""
        return self.census.roster

    @property
    def names(self) -> tuple[str, ...]:
        """The ids of the bodies, row by row."""
        return self.census.bodies.ids

    @property
    def joint_names(self) -> tuple[str, ...]:
        """The ids of the joints, row by row."""
        return self.census.joints.ids

    @property
    def arrays(self) -> tuple[Records, ...]:
        """The record arrays in the order of `records.TABLES`."""
        return tuple(getattr(self, name) for name in ARRAYS)


class Deferring(State):
    """A state in which something is still to be changed. It looks like any other, as nobody can see it so."""

    def __getattribute__(self, name: str) -> Any:
        apply_deferred(self)
        return getattr(self, name)

    def __setattr__(self, name: str, value: Any) -> None:
        apply_deferred(self)
        setattr(self, name, value)


def apply_deferred(state: State) -> None:
    """Have that done which was put off, if something was, and let it be a state like any other."""
    if not isinstance(state, Deferring):
        return
    own = object.__getattribute__(state, "__dict__")
    apply, own["_deferred"] = own["_deferred"], None
    object.__setattr__(state, "__class__", State)
    apply()
