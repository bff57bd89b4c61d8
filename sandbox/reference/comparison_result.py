"""What a comparison found: the counts of a scene, and the poses of what went wrong."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from sandbox.reference.answer import Answer
from sandbox.reference.arbitration import Ruling
from sandbox.reference.pair import Pair

KEEP = 100
"""Disagreements of a scene kept with their poses; more are only counted."""


@dataclass(frozen=True)
class Disagreement:
    """One pair on which the engine is wrong, or pymunk in a way that has no name yet.

    `what` is `verdict`, `depth or axis`, `no contact` or `contact axis`; the last two are about the step's contact.
    `names` are the bodies, `shapes` the rows of the shapes.
    """

    step: int
    what: str
    names: tuple[str, str]
    shapes: tuple[int, int]
    pair: Pair
    ours: Answer
    theirs: Answer
    ruling: Ruling

    @property
    def who_is_wrong(self) -> str:
        """`sandbox`; `pymunk` where exact arithmetic confirms this engine; `nobody` where it confirms both."""
        if self.ruling.faults or self.what in ("no contact", "contact axis"):
            return "sandbox"
        return "pymunk" if self.ruling.their_faults else "nobody"


@dataclass(frozen=True)
class Miss:
    """A pair of overlapping boxes that the grid did not propose."""

    step: int
    names: tuple[str, str]
    shapes: tuple[int, int]


@dataclass
class Comparison:
    """The tally of a scene. Lengths in m, angles in rad; `pymunk_wrong` counts by the names of the traps."""

    steps: int = 0
    pairs: int = 0
    agreed: int = 0
    touching: int = 0
    disagreed: int = 0
    missed: int = 0
    other_axis: int = 0
    depth_error: float = 0.0
    normal_error: float = 0.0
    pymunk_wrong: Counter[str] = field(default_factory=Counter)
    disagreements: list[Disagreement] = field(default_factory=list)
    misses: list[Miss] = field(default_factory=list)

    @property
    def agrees(self) -> bool:
        """True if there is no disagreement and no missed pair."""
        return not self.disagreed and not self.missed
