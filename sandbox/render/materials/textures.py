"""The textures of materials as tiles that repeat: all painters look into the same ones."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from sandbox.render.camera import Floats

TILE = 128
"""Samples along a side of a tile."""
UNITS = 8.0
"""How many times the texture's unit of length a tile is wide."""
NONE = 0
"""The number of no texture."""


@cache
def textures() -> NDArray[np.float32]:
    """Every texture (k, TILE, TILE): what is added to a colour, sRGB, rows along y; number 0 is empty."""
    tiles = np.stack([np.zeros((TILE, TILE)), *(draw() for draw in _DRAWN.values())]).astype(np.float32)
    tiles.flags.writeable = False
    return tiles


def texture_number(name: str) -> int:
    """Which of `textures()` a name means; 0 for an empty one."""
    return TEXTURES.index(name) if name else NONE


def _noise(seed: int, long: float, high: float) -> Floats:
    """Smooth noise that repeats, of mean 0 and deviation 1; blobs are about `long` x `high` units of length."""
    white = np.random.default_rng(seed).standard_normal((TILE, TILE))
    wave = np.fft.fftfreq(TILE) * TILE / UNITS  # waves a unit
    reach = np.exp(-((wave[None, :] * long) ** 2 + (wave[:, None] * high) ** 2) * 2.0)
    smooth = np.fft.ifft2(np.fft.fft2(white) * reach).real
    return _even(smooth)


def _even(values: Floats) -> Floats:
    even: Floats = (values - values.mean()) / values.std()
    return even


def _wood() -> Floats:
    """Lines along x that bend a little, and finer ones between them."""
    y = np.arange(TILE)[:, None] * (UNITS / TILE)
    bend = 0.10 * _noise(1, 3.0, 0.9)
    rings = np.sin(2.0 * np.pi * (1.5 * y + 2.2 * bend))
    return 0.026 * np.clip(rings, -0.6, 1.0) + 0.012 * _noise(2, 2.2, 0.10)


def _stone() -> Floats:
    """Specks, dark and light, on faint clouds."""
    fine = _noise(3, 0.13, 0.13)
    specks = np.clip(fine - 1.1, 0.0, 1.2) - np.clip(-fine - 1.1, 0.0, 1.2)
    return 0.055 * specks + 0.014 * _noise(4, 0.9, 0.9)


def _grains() -> Floats:
    """Fine even grains."""
    grains: Floats = 0.024 * np.clip(_noise(5, 0.11, 0.11), -2.0, 2.0)
    return grains + 0.010 * _noise(6, 0.5, 0.5)


def _steel() -> Floats:
    """Brushed along x, with broad soft bands that catch the light."""
    y = np.arange(TILE)[:, None] * (UNITS / TILE)
    sheen: Floats = 0.040 * np.cos(2.0 * np.pi * y / 2.0) ** 3
    return sheen + 0.012 * _noise(7, 2.5, 0.07)


def _ice() -> Floats:
    """Faint veins and clouds."""
    cloud = _noise(8, 0.8, 0.8)
    veins = np.clip(1.0 - np.abs(_noise(9, 1.0, 1.0)) / 0.09, 0.0, 1.0)
    return 0.030 * veins + 0.018 * cloud


def _rubber() -> Floats:
    """Hardly anything: a dull grain."""
    return 0.012 * np.clip(_noise(10, 0.16, 0.16), -2.0, 2.0)


_DRAWN = {"wood": _wood, "stone": _stone, "grains": _grains, "steel": _steel, "ice": _ice, "rubber": _rubber}
TEXTURES = ("", *_DRAWN)
"""The names of all textures; their places are their numbers."""
