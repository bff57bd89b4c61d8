"""Two convex shapes at their exact places: what all judges of a verdict are asked about."""

from __future__ import annotations

from dataclasses import dataclass

Point = tuple[float, float]


@dataclass(frozen=True)
class Core:
    """A rounded convex core in world axes about its body's centre: 1..64 points, counter-clockwise, and a radius."""

    points: tuple[Point, ...]
    radius: float = 0.0

    @property
    def kind(self) -> str:
        """What pymunk calls it: `circle`, `segment` or `polygon`."""
        return ("circle", "segment", "polygon")[min(len(self.points), 3) - 1]

    def source(self) -> str:
        """Python source of this value; every float comes back to the bit."""
        points = "".join(f"({x!r}, {y!r}), " for x, y in self.points)
        return f"Core(({points.rstrip()}), {self.radius!r})"


@dataclass(frozen=True)
class Pair:
    """Shapes a and b, and the centres of their bodies in the world."""

    a: Core
    b: Core
    center_a: Point = (0.0, 0.0)
    center_b: Point = (0.0, 0.0)

    @property
    def kinds(self) -> str:
        """Both kinds, such as `circle-polygon`, in the order pymunk sorts them."""
        order = ("circle", "segment", "polygon")
        return "-".join(sorted((self.a.kind, self.b.kind), key=order.index))

    def source(self) -> str:
        """Python source of this value."""
        a, b = self.a.source(), self.b.source()
        return f"Pair(\n    {a},\n    {b},\n    {self.center_a!r},\n    {self.center_b!r},\n)"
