"""The colours of the separating-axis test, the same as in its pictures: a, b, a gap, an overlap, the way out."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from sandbox.geometry.sat_rows import SatRow
from sandbox.render.sat_style import color_of
from sandbox.render.theme import Color, Theme


@dataclass(frozen=True)
class SatColors:
    """`gap` parts the shapes, `out` is an overlap, `mtv` the shortest way out."""

    a: Color
    b: Color
    gap: Color
    out: Color
    mtv: Color
    corners: Color

    def of(self, owner: str) -> Color:
        """The colour of whose edge gave an axis."""
        return {"a": self.a, "b": self.b}.get(owner, self.corners)

    def outcome(self, row: SatRow) -> Color:
        """Gap or overlap."""
        return self.gap if row.gap else self.out


@lru_cache(maxsize=4)
def sat_colors(theme: Theme) -> SatColors:
    """The colours that go with a theme."""
    a, b, gap, out, mtv = (color_of(theme, name) for name in ("a", "b", "gap", "out", "mtv"))
    return SatColors(a, b, gap, out, mtv, theme.joint)
