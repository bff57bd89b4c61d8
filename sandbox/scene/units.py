"""How long a metre is: scenes may count in pixels, or in whatever else.

What the engine takes for slow, or for close, is meant in metres, as that of Box2D is (`b2SetLengthUnitsPerMeter`).
"""

from __future__ import annotations

from math import hypot

EARTH = 9.81
"""Gravity (m/s^2)."""
HEAVIEST = 30.0
"""More gravity (m/s^2) than any planet has, Jupiter's being 25: lengths are no metres."""


def guessed_units(gravity: tuple[float, float]) -> float:
    """Units of length to a metre, by the gravity of a scene: as many as make it Earth's, if no planet has so much.

    Chipmunk guesses from gravity, too, what is slow (`cpSpaceGetIdleSpeedThreshold`).
    """
    size = hypot(*gravity)
    return size / EARTH if size > HEAVIEST else 1.0
