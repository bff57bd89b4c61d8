"""What the simple solver can do with or without."""

from __future__ import annotations

from dataclasses import dataclass, fields

from sandbox.scene.flat import FlatScene

SWITCHES = ("warm_starting", "accumulate", "soft", "relax", "speculative")
"""The techniques that are on or off; the fields of `Techniques` of these names."""


@dataclass(frozen=True)
class Techniques:
    """How a step is solved. `iterations` are passes over all contacts in each of `substeps`.

    - `warm_starting`: begin with the impulses of the substep before.
    - `accumulate`: clamp the sum of a contact's impulses, not each impulse alone. Without it, nothing is kept to begin
      with either.
    - `soft`: overlaps are springs with dampers. Without it, a fifth of an overlap is taken back in a substep (J. W.
      Baumgarte, 1972).
    - `relax`: take the speed away again that pushing overlaps apart has added.
    - `speculative`: contacts work before the shapes touch, so that the gap between them just closes.
    """

    warm_starting: bool = True
    accumulate: bool = True
    soft: bool = True
    relax: bool = True
    speculative: bool = True
    substeps: int = 4
    iterations: int = 1

    @classmethod
    def of(cls, scene: FlatScene) -> Techniques:
        """Those that the settings of a scene ask for."""
        said = scene.settings
        known = {field.name for field in fields(cls)}
        return cls(**{name: getattr(said, name) for name in known if hasattr(said, name)})
