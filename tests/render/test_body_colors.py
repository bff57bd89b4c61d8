from __future__ import annotations

import numpy as np
import pytest

from sandbox.render.body_colors import choose_colors, family, frame_colors
from sandbox.render.frame import capture
from sandbox.render.oklab import oklch_to_srgb
from sandbox.render.theme import DARK, LIGHT, Theme, hex_color
from sandbox.world.records import DYNAMIC, STATIC
from tests.render.stages import zoo


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("crate", "crate"),
        ("crate-3", "crate"),
        ("crate-3-7", "crate"),
        ("wall.12", "wall"),
        ("42", "42"),
        ("b2b", "b2b"),
    ],
)
def test_family_is_the_id_without_counters(name: str, expected: str) -> None:
    assert family(name) == expected


def test_colours_depend_on_ids_and_types_alone() -> None:
    names = [f"crate-{i}" for i in range(50)] + ["ball", "ground"]
    types = [DYNAMIC] * 51 + [STATIC]
    first, second = choose_colors(names, types, DARK).base, choose_colors(names, types, DARK).base
    assert np.array_equal(first, second)
    assert tuple(first[-1]) == DARK.static


def test_families_get_hues_of_their_own_while_there_are_enough() -> None:
    names = [f"thing{chr(97 + i)}" for i in range(len(DARK.hues))]
    base = choose_colors(names, [DYNAMIC] * len(names), DARK).base
    assert len({tuple(row) for row in base.tolist()}) == len(names)


def test_neighbours_in_a_family_can_be_told_apart() -> None:
    base = choose_colors([f"crate-{i}" for i in range(100)], [DYNAMIC] * 100, DARK).base
    assert np.abs(np.diff(base, axis=0)).max(axis=1).min() > 0.005


def test_a_scene_can_choose_a_colour() -> None:
    base = choose_colors(["a", "b"], [DYNAMIC, STATIC], DARK, {"b": "#ff8000"}).base
    assert tuple(base[1]) == hex_color("#ff8000") == (1.0, 128 / 255, 0.0)


def test_sleep_dims_and_bad_numbers_show_red() -> None:
    state = zoo()
    body_colors = choose_colors(state.names, state.bodies.type, DARK)
    colors = frame_colors(capture(state), body_colors)
    asleep, frozen = state.names.index("dozer"), state.names.index("broken")
    assert colors.fill[asleep].mean() < body_colors.base[asleep].mean()
    assert tuple(colors.fill[frozen]) == DARK.frozen
    assert np.flatnonzero(colors.hatched).tolist() == [frozen]


def test_oklch_ends_are_black_and_white() -> None:
    assert oklch_to_srgb(0.0, 0.0, 0.0) == (0.0, 0.0, 0.0)
    assert oklch_to_srgb(1.0, 0.0, 0.0) == pytest.approx((1.0, 1.0, 1.0), abs=1e-4)


def test_oklch_red_is_red() -> None:
    # The published coordinates of sRGB red.
    assert oklch_to_srgb(0.62796, 0.25768, 29.2339) == pytest.approx((1.0, 0.0, 0.0), abs=2e-3)


# Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision deficiency", 2009:
# severity 1, on linear sRGB.
SIGHT = {
    "usual": np.eye(3),
    "deuteranopia": np.array([[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413],
                              [-0.011820, 0.042940, 0.968881]]),
    "protanopia": np.array([[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216],
                            [-0.003882, -0.048116, 1.051998]]),
}  # fmt: skip


def oklab(linear: np.ndarray) -> np.ndarray:
    """Linear sRGB (n, 3) in OKLab."""
    cones = np.array([[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566],
                      [0.0883024619, 0.2817188376, 0.6299787005]])  # fmt: skip
    axes = np.array([[0.2104542553, 0.7936177850, -0.0040720468], [1.9779984951, -2.4285922050, 0.4505937099],
                     [0.0259040371, 0.7827717662, -0.8086757660]])  # fmt: skip
    found: np.ndarray = np.cbrt(np.clip(linear, 0.0, 1.0) @ cones.T) @ axes.T
    return found


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
@pytest.mark.parametrize("sight", list(SIGHT))
def test_families_differ_for_the_colour_blind(theme: Theme, sight: str) -> None:
    names = [f"thing{chr(97 + i)}" for i in range(len(theme.hues))]
    base = choose_colors(names, [DYNAMIC] * len(names), theme).base
    linear = np.where(base <= 0.04045, base / 12.92, ((base + 0.055) / 1.055) ** 2.4)
    seen = oklab(linear @ SIGHT[sight].T)
    apart = np.linalg.norm(seen[:, None] - seen[None], axis=2)[np.triu_indices(len(names), 1)]
    assert apart.min() > 0.04  # with one lightness for all it was 0.004
