"""A column of a sweep as colours over two others: a cell for each pair of values, or a dot for each run of a sample.

Runs that share a cell give it their mean; one in which all failed stays empty.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from sandbox.sweeps.plot_style import Inks, places
from sandbox.sweeps.table import Column

_TOLD = 12
"""Up to so many cells a side have their number written in them, and so many values their own tick."""
_SPARSE = 4
"""A grid of more cells than this times the runs is no grid."""
_DARK = 0.6
"""Below this share of the range, a cell is so dark that light words are read on it."""


@dataclass(frozen=True)
class HeatMap:
    """The columns of a heat map, of equal length: to the right, upwards, and the numbers that are colours."""

    x: Column
    y: Column
    values: Column


def draw_heat_map(axis: Any, of: HeatMap, inks: Inks) -> None:
    """Draw it into a panel of matplotlib, with a bar that says what the colours mean."""
    (x, x_labels), (y, y_labels) = places(of.x), places(of.y)
    across, up = np.unique(x), np.unique(y)
    if len(across) * len(up) > _SPARSE * len(x):
        there = np.isfinite(of.values)
        drawn = axis.scatter(x[there], y[there], c=of.values[there], s=44.0, cmap=inks.values, linewidths=0)
    else:
        cells = cells_of((x, y, of.values), across, up)
        drawn = axis.pcolormesh(_edges(across), _edges(up), cells, cmap=inks.values, linewidth=0)
        _write_numbers(axis, (across, up, cells), drawn)
    _set_ticks(axis.set_xticks, across, x_labels)
    _set_ticks(axis.set_yticks, up, y_labels)
    axis.tick_params(length=0)
    bar = axis.figure.colorbar(drawn, ax=axis, pad=0.015, aspect=24)
    bar.outline.set_visible(False)
    bar.ax.tick_params(length=0, colors=inks.quiet)


def cells_of(runs: tuple[Column, Column, Column], across: Column, up: Column) -> Column:
    """The mean of the runs in each cell, a row for each value upwards; NaN where there is none."""
    x, y, values = runs
    there = np.isfinite(values)
    place = np.searchsorted(up, y[there]) * len(across) + np.searchsorted(across, x[there])
    size = len(across) * len(up)
    count = np.bincount(place, minlength=size)
    total = np.bincount(place, weights=values[there], minlength=size)
    mean = np.divide(total, count, out=np.full(size, np.nan), where=count > 0)
    cells: Column = mean.reshape(len(up), len(across))
    return cells


def _edges(middles: Column) -> Column:
    """The edges of cells, half way between their middles."""
    if len(middles) == 1:
        return np.array([middles[0] - 0.5, middles[0] + 0.5])
    between = (middles[1:] + middles[:-1]) / 2.0
    edges: Column = np.concatenate([[2.0 * middles[0] - between[0]], between, [2.0 * middles[-1] - between[-1]]])
    return edges


def _write_numbers(axis: Any, of: tuple[Column, Column, Column], drawn: Any) -> None:
    across, up, cells = of
    if max(cells.shape) > _TOLD:
        return
    for (row, column), value in np.ndenumerate(cells):
        if np.isfinite(value):
            color = "#ffffff" if drawn.norm(value) < _DARK else "#12151b"
            axis.text(across[column], up[row], f"{value:.3g}", ha="center", va="center", color=color, fontsize=8.5)


def _set_ticks(set_ticks: Any, values: Column, labels: list[str]) -> None:
    if labels:
        set_ticks(range(len(labels)), labels)
    elif len(values) <= _TOLD:
        set_ticks(values, [f"{value:.4g}" for value in values])
