"""How plots of sweeps look, and where the values of a column are on an axis."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from sandbox.sweeps.table import Column


@dataclass(frozen=True)
class Inks:
    """Colours of a theme: behind all, of a panel, its grid, words, quiet words, lines, and the map of values."""

    back: str
    panel: str
    grid: str
    ink: str
    quiet: str
    lines: tuple[str, ...]
    values: str


INKS: Mapping[str, Inks] = {
    "dark": Inks(
        "#12151b", "#171b23", "#262d39", "#e6eaf0", "#8b95a7",
        ("#ffb454", "#5fb0ff", "#7fd88f", "#f0719b", "#b79cff", "#4fd0c5", "#e8d26a", "#ff8a65", "#9fb4cc", "#d58ad8"),
        "viridis",
    ),
    "light": Inks(
        "#fbfaf6", "#ffffff", "#e7e4da", "#12151b", "#6b7280",
        ("#c76a00", "#1f6fbf", "#2e8b47", "#c2356a", "#6d4fc4", "#0d8a80", "#94801a", "#c94b22", "#54687f", "#97439b"),
        "viridis",
    ),
}  # fmt: skip


def style(inks: Inks) -> dict[str, Any]:
    """The settings of matplotlib for a theme."""
    return {
        "figure.facecolor": inks.back,
        "axes.facecolor": inks.panel,
        "savefig.facecolor": inks.back,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.spines.left": False,
        "axes.edgecolor": inks.grid,
        "axes.axisbelow": True,
        "grid.color": inks.grid,
        "grid.linewidth": 0.8,
        "xtick.color": inks.quiet,
        "ytick.color": inks.quiet,
        "font.family": "DejaVu Sans",
        "font.size": 9.5,
        "lines.solid_capstyle": "round",
        "lines.solid_joinstyle": "round",
        "svg.hashsalt": "sandbox",
    }


def places(column: Column) -> tuple[Column, list[str]]:
    """Where the values of a column are on an axis, and the labels if they are words."""
    if column.dtype != object:
        return column.astype(float), []
    words = list(dict.fromkeys(str(value) for value in column))
    return np.array([float(words.index(str(value))) for value in column]), words
