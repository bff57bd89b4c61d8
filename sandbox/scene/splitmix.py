"""A small random generator whose numbers are the same in every version of Python: SplitMix64.

Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (2014).
"""

from __future__ import annotations

_MASK = (1 << 64) - 1


class SplitMix64:
    """A stream of random numbers that depends on `seed` (0 <= seed < 2^64) alone."""

    def __init__(self, seed: int) -> None:
        self._state = seed & _MASK

    def next_bits(self) -> int:
        """The next 64 random bits."""
        self._state = (self._state + 0x9E3779B97F4A7C15) & _MASK
        z = self._state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & _MASK
        return z ^ (z >> 31)

    def between(self, low: float, high: float) -> float:
        """A number evenly spread over [low, high)."""
        return low + (high - low) * ((self.next_bits() >> 11) * 2.0**-53)
