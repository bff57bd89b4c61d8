"""A column of a sweep over another, or over two others, drawn by matplotlib (the `plot` extra).

Over one, runs are points; a line goes through the means of those that share an x, and a band from the lowest to the
highest. Over two it is a heat map.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any, Literal

import numpy as np

from sandbox._atomic_write import write_bytes
from sandbox.errors import ArgumentError, MissingDependencyError
from sandbox.sweeps.heat_map import HeatMap, draw_heat_map
from sandbox.sweeps.plot_style import INKS, Inks, places, style
from sandbox.sweeps.table import Column, SweepTable

SUFFIXES = (".png", ".svg")
MOST_PANELS = 6
_MOST_GROUPS = 10
_LEGEND_WIDTH = 90
_FEW = 12


@dataclass(frozen=True)
class Plot:
    """What is drawn: column `x`, a panel for each of `y`, a colour for each value of `by` if that is given.

    With a column `over`, which goes upwards, `y` are the colours of heat maps, and there is no `by`.
    """

    x: str
    y: tuple[str, ...]
    by: str = ""
    over: str = ""
    title: str = ""
    theme: Literal["dark", "light"] = "dark"


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

    inks = INKS[plot.theme]
    with matplotlib.rc_context(style(inks)):
        layout: Any = ConstrainedLayoutEngine(h_pad=0.12, w_pad=0.16, hspace=0.02)
        figure = Figure(figsize=(9.6, 1.6 + 3.6 * len(plot.y)), layout=layout)
        axes = figure.subplots(len(plot.y), 1, sharex=True, squeeze=False)[:, 0]
        groups = _groups(table, plot)
        for axis, name in zip(axes, plot.y, strict=True):
            if plot.over:
                draw_heat_map(axis, HeatMap(table[plot.x], table[plot.over], numbers_of(table, name)), inks)
                axis.set_ylabel(plot.over, color=inks.quiet, labelpad=8)
            else:
                _draw(axis, name, (table, plot), groups, inks)
            axis.set_title(name, loc="left", color=inks.ink, fontsize=10.5, pad=7)
        axes[-1].set_xlabel(plot.x, color=inks.quiet, labelpad=8)
        _entitle(figure, axes[0], plot, groups, inks)
        kind = path.suffix.lower().removeprefix(".")
        data = BytesIO()
        figure.savefig(data, format=kind, dpi=150, metadata={"Date": None} if kind == "svg" else None)
    write_bytes(path, data.getvalue())


def check_plot(columns: Sequence[str], plot: Plot) -> None:
    """Whether there are such columns. Raises `ArgumentError`."""
    known = SweepTable(dict.fromkeys(columns, ()))
    for name in (plot.x, *plot.y, *filter(None, [plot.by, plot.over])):
        _ = known[name]
    if plot.by and plot.over:
        raise ArgumentError("a heat map has its colours for what is drawn: by and over exclude each other")
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


def _draw(axis: Any, name: str, of: tuple[SweepTable, Plot], groups: Sequence[tuple[str, Any]], inks: Inks) -> None:
    table, plot = of
    x, labels = places(table[plot.x])
    y = numbers_of(table, name)
    for (_, chosen), color in zip(groups, inks.lines, strict=False):
        _draw_group(axis, x[chosen], y[chosen], color)
    axis.margins(x=0.02, y=0.1)
    if labels:
        axis.set_xticks(range(len(labels)), labels)
    axis.locator_params(axis="y", nbins=6)
    axis.grid(True, axis="y")
    axis.tick_params(length=0)


def numbers_of(table: SweepTable, name: str) -> Column:
    """The numbers in a column. Raises `ArgumentError` where it holds texts."""
    if table[name].dtype == object:
        raise ArgumentError(f"{name} holds no numbers, so it cannot be plotted")
    return table[name].astype(float)


def _draw_group(axis: Any, x: Column, y: Column, color: str) -> None:
    there = np.isfinite(y)
    x, y = x[there], y[there]
    spots = np.unique(x)
    at = [y[x == spot] for spot in spots]
    if len(spots) < len(x):
        axis.fill_between(spots, [v.min() for v in at], [v.max() for v in at], color=color, alpha=0.13, linewidth=0)
    if len(spots) < len(x) or _is_a_row(spots):
        axis.plot(spots, [v.mean() for v in at], color=color, linewidth=2.0, zorder=3)
    size = 26.0 if len(x) <= 100 else 10.0
    axis.scatter(x, y, s=size, color=color, alpha=0.85 if len(spots) == len(x) else 0.4, linewidths=0, zorder=4)


def _is_a_row(spots: Column) -> bool:
    """Whether values of x are few, or evenly spread as no random sample is: then a line tells something."""
    gaps = np.diff(spots)
    return len(spots) <= _FEW or bool(np.allclose(gaps, gaps[0], rtol=1e-6))


def _entitle(figure: Any, first: Any, plot: Plot, groups: Sequence[tuple[str, Any]], inks: Inks) -> None:
    from matplotlib.lines import Line2D

    below = f"{plot.x} and {plot.over}" if plot.over else plot.x
    title = plot.title or f"{plot.y[0]} over {below}"
    figure.suptitle(title, x=0.016, ha="left", color=inks.ink, fontsize=15, fontweight="bold")
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
