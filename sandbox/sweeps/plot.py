"""A column of a sweep over another, drawn by matplotlib (the `plot` extra).

Runs are points; a line goes through the means of those that share an x, and a band from the lowest to the highest.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any, Literal

import numpy as np

from sandbox._atomic_write import write_bytes
from sandbox.errors import ArgumentError, MissingDependencyError
from sandbox.sweeps.table import Column, SweepTable

SUFFIXES = (".png", ".svg")
MOST_PANELS = 6
_MOST_GROUPS = 10
_LEGEND_WIDTH = 90
_FEW = 12


@dataclass(frozen=True)
class Plot:
    """What is drawn: column `x`, a panel for each of `y`, a colour for each value of `by` if that is given."""

    x: str
    y: tuple[str, ...]
    by: str = ""
    title: str = ""
    theme: Literal["dark", "light"] = "dark"


@dataclass(frozen=True)
class _Inks:
    back: str
    panel: str
    grid: str
    ink: str
    quiet: str
    lines: tuple[str, ...]


_INKS: Mapping[str, _Inks] = {
    "dark": _Inks(
        "#12151b", "#171b23", "#262d39", "#e6eaf0", "#8b95a7",
        ("#ffb454", "#5fb0ff", "#7fd88f", "#f0719b", "#b79cff", "#4fd0c5", "#e8d26a", "#ff8a65", "#9fb4cc", "#d58ad8"),
    ),
    "light": _Inks(
        "#fbfaf6", "#ffffff", "#e7e4da", "#12151b", "#6b7280",
        ("#c76a00", "#1f6fbf", "#2e8b47", "#c2356a", "#6d4fc4", "#0d8a80", "#94801a", "#c94b22", "#54687f", "#97439b"),
    ),
}  # fmt: skip


def save_plot(table: SweepTable, plot: Plot, path: Path) -> None:
    """Draw a plot into a PNG or SVG file.

    Raises `ArgumentError` where a column is not there or holds no numbers, `MissingDependencyError` where matplotlib is
    not installed, and OSError.
    """
    check_plot(table.columns, plot)
    matplotlib = require_matplotlib()
    # The figure is made without pyplot, so that no display is looked for.
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    inks = _INKS[plot.theme]
    with matplotlib.rc_context(_style(inks)):
        layout: Any = ConstrainedLayoutEngine(h_pad=0.12, w_pad=0.16, hspace=0.02)
        figure = Figure(figsize=(9.6, 1.6 + 3.6 * len(plot.y)), layout=layout)
        axes = figure.subplots(len(plot.y), 1, sharex=True, squeeze=False)[:, 0]
        groups = _groups(table, plot)
        for axis, name in zip(axes, plot.y, strict=True):
            _draw(axis, name, (table, plot), groups, inks)
        axes[-1].set_xlabel(plot.x, color=inks.quiet, labelpad=8)
        _entitle(figure, axes[0], plot, groups, inks)
        kind = path.suffix.lower().removeprefix(".")
        data = BytesIO()
        figure.savefig(data, format=kind, dpi=150, metadata={"Date": None} if kind == "svg" else None)
    write_bytes(path, data.getvalue())


def check_plot(columns: Sequence[str], plot: Plot) -> None:
    """Whether there are such columns. Raises `ArgumentError`."""
    known = SweepTable(dict.fromkeys(columns, ()))
    for name in (plot.x, *plot.y, *filter(None, [plot.by])):
        _ = known[name]
    if not 1 <= len(plot.y) <= MOST_PANELS:
        raise ArgumentError(f"a plot has 1 to {MOST_PANELS} columns for y, not {len(plot.y)}")


def require_matplotlib() -> Any:
    """The matplotlib package. Raises `MissingDependencyError` where it is not installed."""
    try:
        import matplotlib
    except ImportError as error:
        text = "--plot draws with matplotlib, which is not installed: python -m pip install matplotlib"
        raise MissingDependencyError(text) from error
    return matplotlib


def _groups(table: SweepTable, plot: Plot) -> list[tuple[str, Any]]:
    """The runs of each colour: what they are called, and which rows they are."""
    if not plot.by:
        return [("", np.full(len(table), True))]
    column = table[plot.by]
    values = sorted(set(column.tolist()), key=lambda value: (isinstance(value, str), value))
    if len(values) > _MOST_GROUPS:
        raise ArgumentError(f"{plot.by} has {len(values)} values; colours can be told apart for {_MOST_GROUPS}")
    return [(f"{value:g}" if isinstance(value, float) else str(value), column == value) for value in values]


def _draw(axis: Any, name: str, of: tuple[SweepTable, Plot], groups: Sequence[tuple[str, Any]], inks: _Inks) -> None:
    table, plot = of
    x, labels = _places(table[plot.x])
    y = table[name]
    if y.dtype == object:
        raise ArgumentError(f"{name} holds no numbers, so it cannot be plotted")
    for (_, chosen), color in zip(groups, inks.lines, strict=False):
        _draw_group(axis, x[chosen], y[chosen].astype(float), color)
    axis.set_title(name, loc="left", color=inks.ink, fontsize=10.5, pad=7)
    axis.margins(x=0.02, y=0.1)
    if labels:
        axis.set_xticks(range(len(labels)), labels)
    axis.locator_params(axis="y", nbins=6)
    axis.grid(True, axis="y")
    axis.tick_params(length=0)


def _draw_group(axis: Any, x: Column, y: Column, color: str) -> None:
    there = np.isfinite(y)
    x, y = x[there], y[there]
    places = np.unique(x)
    at = [y[x == place] for place in places]
    if len(places) < len(x):
        axis.fill_between(places, [v.min() for v in at], [v.max() for v in at], color=color, alpha=0.13, linewidth=0)
    if len(places) < len(x) or _is_a_row(places):
        axis.plot(places, [v.mean() for v in at], color=color, linewidth=2.0, zorder=3)
    size = 26.0 if len(x) <= 100 else 10.0
    axis.scatter(x, y, s=size, color=color, alpha=0.85 if len(places) == len(x) else 0.4, linewidths=0, zorder=4)


def _is_a_row(places: Column) -> bool:
    """Whether places are few, or evenly spread, as those of a random sample are not: then a line tells something."""
    gaps = np.diff(places)
    return len(places) <= _FEW or bool(np.allclose(gaps, gaps[0], rtol=1e-6))


def _places(column: Column) -> tuple[Column, list[str]]:
    """Where the values of a column are on an axis, and the labels if they are words."""
    if column.dtype != object:
        return column.astype(float), []
    words = list(dict.fromkeys(str(value) for value in column))
    return np.array([float(words.index(str(value))) for value in column]), words


def _entitle(figure: Any, first: Any, plot: Plot, groups: Sequence[tuple[str, Any]], inks: _Inks) -> None:
    from matplotlib.lines import Line2D

    figure.suptitle(plot.title or f"{plot.y[0]} over {plot.x}", x=0.016, ha="left", color=inks.ink, fontsize=15,
                    fontweight="bold")  # fmt: skip
    if not plot.by:
        return
    names = [name for name, _ in groups]
    lines = [Line2D([], [], color=c, linewidth=2.4, label=n) for n, c in zip(names, inks.lines, strict=False)]
    per_row = max(1, min(len(names), _LEGEND_WIDTH // (4 + max(map(len, names)))))
    legend = first.legend(
        handles=lines, title=plot.by, loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=per_row, frameon=False,
        labelcolor=inks.ink, borderaxespad=0.1, handlelength=1.4, columnspacing=1.6,
    )  # fmt: skip
    legend.get_title().set_color(inks.quiet)


def _style(inks: _Inks) -> dict[str, Any]:
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
