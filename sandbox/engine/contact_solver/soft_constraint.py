"""Soft constraints: a spring and a damper solved as an impulse, stable for any stiffness.

Source: E. Catto, "Soft Constraints", GDC 2011, and the implicit form of Box2D v3's soft step.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox._jit import inlined_kernel, kernel
from sandbox.geometry.trig import PI
from sandbox.tables import Records

BAUMGARTE = 0.2
"""Share of an overlap that is taken back in a substep where contacts are not soft."""
TOUCHING = 1e-9
"""Gap (m) that is closed but for rounding."""
JOINTED_SOFTNESS = 0.65
"""Least softness of a contact of bodies that joints hold, times what its bias rate takes back in a substep.

What is joined to them may be heavier than the contact knows. It rests on a spring and a damper that lag: with softness
s, bias rate b, effective mass m, substeps of h and the relax pass the impulse p of a substep follows a gap x as
h p' + s p = -m ((2 - s) x' + (1 - s) b x). So it comes to rest only if s (2 - s) > (1 - s) b h, however heavy it is
(the criterion of E. J. Routh, 1877, and A. Hurwitz, 1895)."""
JOINTED_STIFFENS = 2.5
"""Times as stiff as it is where its push begins to be cut such a contact becomes at most: it bears some 700 times the
weight of the lighter body. What joints keep in a wall, or in each other, would throw others when it comes free, as
the contact gives way too slowly to what is heavier than it knows."""


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


class Spring(NamedTuple):
    """The springs of contacts at a substep level.

    The bias rate (1/s) and softness are those of `contact_coefficients`, `softness_jointed` is that of contacts of
    bodies which joints hold; a substep takes so many seconds and is a `share` of one of level 0. An effective mass of
    1 kg sinks by `yields` (m), or `yields_jointed`, under a load of 1 N s in each substep of level 0, a fourth at each
    finer level; by 0 where impulses are not kept. A metre is so many units of length.
    """

    level: int
    bias: float
    softness: float
    softness_jointed: float
    seconds: float
    share: float
    yields: float
    yields_jointed: float
    units_per_meter: float


@inlined_kernel
def substep_share(level: int) -> float:
    """What share of a substep of level 0 one of a level takes: tables have impulses as of level 0, which fit when an
    island's substeps change."""
    return 1.0 / float(1 << level)


@kernel
def contact_spring(setting: Records, level: int) -> Spring:
    """The springs that contacts of islands of a substep level have: stiffer where substeps are shorter."""
    rate = (setting.substeps << level) / setting.step_seconds
    hertz = setting.contact_hertz * (1 << level)
    hertz = hertz if hertz < 0.25 * rate else 0.25 * rate
    bias, softness = contact_coefficients(setting, hertz, 1.0 / rate)
    share = substep_share(level)
    keeps = setting.accumulate == 1 and setting.warm_starting == 1 and bias > 0.0
    yields = share * softness / ((1.0 - softness) * bias) if keeps else 0.0
    least = JOINTED_SOFTNESS * bias / rate
    jointed = least if softness > 0.0 and softness < least else softness
    yields_jointed = share * jointed / ((1.0 - jointed) * bias) if keeps else 0.0
    return Spring(level, bias, softness, jointed, 1.0 / rate, share, yields, yields_jointed, setting.units_per_meter)


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
