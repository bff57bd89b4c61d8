"""The curves of a twin run as a picture, drawn by matplotlib (the `plot` extra)."""

from __future__ import annotations

from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

from sandbox._atomic_write import write_bytes
from sandbox.errors import MissingDependencyError
from sandbox.reference.measures import Measures
from sandbox.reference.twin import Twin

SUFFIXES = (".svg", ".png")
_BACK, _PANEL, _GRID, _INK, _QUIET = "#12151b", "#171b23", "#262d39", "#e6eaf0", "#8b95a7"
_OURS, _THEIRS = "#ffb454", "#5fb0ff"


@dataclass(frozen=True)
class _Panel:
    """One measure over time: its field, title and unit, and the factor from SI to that unit."""

    field: str
    title: str
    unit: str
    factor: float = 1.0


def save_plot(twin: Twin, title: str, path: Path) -> None:
    """Draw energy, deepest overlap and heights of both runs into an SVG or PNG file.

    Raises `MissingDependencyError` where matplotlib is not installed, and OSError.
    """
    matplotlib = require_matplotlib()
    # The figure is made without pyplot, so that no display is looked for.
    from matplotlib.figure import Figure
    from matplotlib.layout_engine import ConstrainedLayoutEngine

    with matplotlib.rc_context(_STYLE):
        layout: Any = ConstrainedLayoutEngine(h_pad=0.12, w_pad=0.16, hspace=0.02)
        figure = Figure(figsize=(9.6, 8.4), layout=layout)
        panels = _panels(twin)
        axes = figure.subplots(len(panels), 1, sharex=True)
        for axis, panel in zip(axes, panels, strict=True):
            _draw(axis, panel, twin)
        axes[-1].set_xlabel("time, s", color=_QUIET)
        axes[-1].set_xlim(twin.times[0], twin.times[-1] or 1.0)
        _entitle(figure, axes[0], title, twin.label)
        kind = path.suffix.lower().removeprefix(".")
        data = BytesIO()
        figure.savefig(data, format=kind, dpi=150, metadata={"Date": None} if kind == "svg" else None)
    write_bytes(path, data.getvalue())


def require_matplotlib() -> Any:
    """The matplotlib package. Raises `MissingDependencyError` where it is not installed."""
    try:
        import matplotlib
    except ImportError as error:
        text = "--plot draws with matplotlib, which is not installed: python -m pip install matplotlib"
        raise MissingDependencyError(text) from error
    return matplotlib


def _panels(twin: Twin) -> list[_Panel]:
    deepest = max(each.penetration for each in (*twin.ours, *twin.theirs))
    overlap = _Panel("penetration", "deepest overlap", "mm", 1e3) if deepest < 1.0 else None
    return [
        _Panel("energy", "energy, kinetic and potential", "J"),
        overlap or _Panel("penetration", "deepest overlap", "m"),
        _Panel("height", "height of the common centre of mass", "m"),
        _Panel("top", "height of the highest body", "m"),
    ]


def _draw(axis: Any, panel: _Panel, twin: Twin) -> None:
    for samples, color, width, order in ((twin.theirs, _THEIRS, 1.6, 2), (twin.ours, _OURS, 1.9, 3)):
        axis.plot(twin.times, _values(samples, panel), color=color, linewidth=width, zorder=order)
    axis.set_title(f"{panel.title}, {panel.unit}", loc="left", color=_INK, fontsize=10.5, pad=7)
    axis.margins(x=0.0, y=0.12)
    if panel.field == "penetration":
        axis.set_ylim(bottom=0.0)
    axis.locator_params(axis="y", nbins=5)
    axis.ticklabel_format(axis="y", style="plain", useOffset=False)
    axis.grid(True, axis="y")
    axis.tick_params(length=0)


def _values(samples: tuple[Measures, ...], panel: _Panel) -> list[float]:
    return [panel.factor * getattr(each, panel.field) for each in samples]


def _entitle(figure: Any, first: Any, title: str, other: str) -> None:
    from matplotlib.lines import Line2D

    figure.suptitle(title, x=0.016, ha="left", color=_INK, fontsize=15, fontweight="bold")
    names = (("sandbox", _OURS), (other, _THEIRS))
    lines = [Line2D([], [], color=color, linewidth=2.4, label=name) for name, color in names]
    first.legend(
        handles=lines, loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2, frameon=False, labelcolor=_INK,
        borderaxespad=0.1, handlelength=1.4, columnspacing=1.6,
    )  # fmt: skip


_STYLE = {
    "figure.facecolor": _BACK,
    "axes.facecolor": _PANEL,
    "savefig.facecolor": _BACK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.spines.left": False,
    "axes.edgecolor": _GRID,
    "axes.axisbelow": True,
    "grid.color": _GRID,
    "grid.linewidth": 0.8,
    "xtick.color": _QUIET,
    "ytick.color": _QUIET,
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "lines.solid_capstyle": "round",
    "lines.solid_joinstyle": "round",
    "svg.hashsalt": "sandbox",
}
