"""What the bodies of a pattern have in common: all but where they are and how they move. Worked out once a world."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from struct import Struct
from typing import TypeAlias

from sandbox.scene.flat import FlatBody, FlatShape
from sandbox.world.body_prototypes import TYPES
from sandbox.world.shape_rows import Patterns, build_patterns

_NONE = float("nan")
_MOST = 1024
_pack = Struct("11d").pack

Shapes: TypeAlias = tuple[FlatShape, ...]
Key: TypeAlias = tuple[int, bytes]
"""A tuple of shapes by its identity, and the bits of all numbers that a pattern depends on."""


def pattern_keys(bodies: Sequence[FlatBody]) -> Iterator[Key]:
    """Equal for bodies of one pattern, as long as their tuples of shapes are kept."""
    for body in bodies:
        x, y = body.center or (_NONE, _NONE)
        mass, inertia = (_NONE if each is None else each for each in (body.mass, body.inertia))
        yield id(body.shapes), _pack(
            TYPES[body.type], x, y, mass, inertia, body.fixed_rotation, body.linear_damping, body.angular_damping,
            body.gravity_scale, body.sleep_speed, body.bullet,
        )  # fmt: skip


class KnownPatterns:
    """Patterns that were worked out before: of what is spawned again and again. At most about a thousand."""

    def __init__(self) -> None:
        self._known: dict[Key, tuple[FlatBody, Patterns]] = {}
        self._weighed: dict[str, Shapes] = {}

    def weighed(self, shapes: Shapes, densities: tuple[float, ...]) -> Shapes:
        """Some shapes with other densities (kg/m^2): the same tuple for the same ones, so that their pattern is known.

        They are told by how they are written, as 0 and -0 are equal.
        """
        fresh = tuple(replace(shape, density=value) for shape, value in zip(shapes, densities, strict=True))
        if len(self._weighed) >= _MOST:
            self._weighed.clear()
        return self._weighed.setdefault(repr(fresh), fresh)

    def has(self, bodies: Sequence[FlatBody]) -> bool:
        """Whether those of all these bodies were."""
        return all(key in self._known for key in pattern_keys(bodies))

    def of(self, keys: Sequence[Key], bodies: Sequence[FlatBody]) -> Patterns:
        """The patterns of bodies that all have another one."""
        lacking = [k for k, key in enumerate(keys) if key not in self._known]
        if lacking:
            if len(self._known) + len(lacking) > _MOST:
                self._known.clear()
                lacking = list(range(len(keys)))
            built = build_patterns([bodies[k] for k in lacking])
            if len(lacking) > _MOST:
                return built
            for place, k in enumerate(lacking):
                # The body keeps its shapes alive, whose identity is part of the key.
                self._known[keys[k]] = bodies[k], built.one(place)
        return Patterns.joined([self._known[key][1] for key in keys])
