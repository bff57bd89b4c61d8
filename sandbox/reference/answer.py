"""What one judge says of a pair of shapes."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.reference.pair import Point


@dataclass(frozen=True)
class Answer:
    """What one judge says: whether the shapes `hit`, their `separation` in m and the `normal` from a, if it tells."""

    hit: bool
    separation: float | None = None
    normal: Point | None = None

    @classmethod
    def ours(cls, separation: float, normal: Point) -> Answer:
        """The narrow phase's: shapes hit where they overlap."""
        return cls(separation < 0.0, separation, normal)

    @classmethod
    def theirs(cls, contact: tuple[float, Point] | None) -> Answer:
        """pymunk's, from (depth, normal) or None: shapes hit where there is a contact, be it of depth 0."""
        return cls(False) if contact is None else cls(True, -contact[0], contact[1])

    def __str__(self) -> str:
        if self.separation is None or self.normal is None:
            return "apart"
        side = "overlap of" if self.hit else "gap of"
        return f"{side} {abs(self.separation):.9g} m along ({self.normal[0]:.9g}, {self.normal[1]:.9g})"
