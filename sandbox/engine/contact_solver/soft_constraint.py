"""Soft constraints: a spring and a damper solved as an impulse, stable for any stiffness.

Source: E. Catto, "Soft Constraints", GDC 2011, and the implicit form of Box2D v3's soft step.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.geometry.trig import PI
from sandbox.tables import Records

BAUMGARTE = 0.2
"""Share of an overlap that is taken back in a substep where contacts are not soft."""


@kernel
def soft_coefficients(hertz: float, damping_ratio: float, seconds: float) -> tuple[float, float, float]:
    """(bias rate 1/s, mass scale, impulse scale) of a soft constraint stepped by `seconds`.

    The impulse is `-mass_scale * m * (velocity + bias_rate * error) - impulse_scale * accumulated impulse`.
    Zero hertz gives a rigid constraint without position correction: (0, 1, 0).
    """
    if hertz <= 0.0:
        return 0.0, 1.0, 0.0
    omega = 2.0 * PI * hertz
    a1 = 2.0 * damping_ratio + seconds * omega
    a2 = seconds * omega * a1
    a3 = 1.0 / (1.0 + a2)
    return omega / a1, a2 * a3, a3


@kernel
def contact_coefficients(setting: Records, hertz: float, seconds: float) -> tuple[float, float]:
    """(bias rate 1/s, softness) of contacts; where `setting` wants them rigid, those of a correction by Baumgarte.

    The softness is the impulse scale of `soft_coefficients`; the mass scale is what is left of 1. Baumgarte's
    correction turns a fifth of the overlap into a speed that would take it back in `seconds` (J. W. Baumgarte, 1972).
    """
    if setting.soft == 0:
        return BAUMGARTE / seconds, 0.0
    bias, _, impulse_scale = soft_coefficients(hertz, setting.contact_damping_ratio, seconds)
    return bias, impulse_scale
