"""Sweeps that lead two cores past each other, told from the circles about them before a time of impact is sought."""

from __future__ import annotations

from sandbox._jit import inlined_kernel, kernel
from sandbox.geometry.core import CoreRows
from sandbox.tables import Records


@kernel
def pass_by(cores: Records, a: CoreRows, b: CoreRows, s: Records, rim_a: float, rim_b: float) -> bool:
    """Whether two cores are apart all along the sweep `s` (`time_of_impact.SWEEP`), as their circles are, or that of
    one and a face of the other that does not turn. False leaves it open.

    The circles are about the centres of bodies, with the `rim` (m) that vertices reach, and the rounding.
    """
    rounding = a.radius + b.radius
    if _circles_are_apart(s, rim_a + rim_b + rounding):
        return True
    if s.rotation_a == 0.0 and s.angle_a == 0.0 and _is_beyond_a_face(cores, a, s, 1.0, rim_b + rounding):
        return True
    return bool(s.rotation_b == 0.0 and s.angle_b == 0.0 and _is_beyond_a_face(cores, b, s, -1.0, rim_a + rounding))


@inlined_kernel
def _circles_are_apart(s: Records, reach: float) -> bool:
    """Whether the centre of b stays farther than `reach` (m) from that of a."""
    square = s.translation_x * s.translation_x + s.translation_y * s.translation_y
    along = -(s.x * s.translation_x + s.y * s.translation_y)  # where it comes nearest, as a share of the square
    t = 0.0 if along <= 0.0 else (1.0 if along >= square else along / square)
    x = s.x + t * s.translation_x
    y = s.y + t * s.translation_y
    return bool(x * x + y * y > reach * reach)


@inlined_kernel
def _is_beyond_a_face(cores: Records, core: CoreRows, s: Records, side: float, reach: float) -> bool:
    """Whether the other centre, that of b if `side` is 1, begins and ends farther than `reach` (m) beyond a face."""
    for i in range(core.start, core.start + core.vertex_count):
        face = cores[i]
        first = face.normal_x * (side * s.x - face.x) + face.normal_y * (side * s.y - face.y)
        way = side * (face.normal_x * s.translation_x + face.normal_y * s.translation_y)
        if first + (way if way < 0.0 else 0.0) > reach:
            return True
    return False
