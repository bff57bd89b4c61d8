"""What is plotted as a file: comma-separated values, a row a step."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from sandbox.tables import Floats
from sandbox.window.panels.plots.quantities import Chart


def csv_text(lines: Sequence[tuple[Chart, str, str]], values: Mapping[str, Floats], step_seconds: float) -> str:
    """A head line, then the steps of which something is known. `lines` are charts with their quantities and titles.

    `values` are those of each quantity by step; a number that is not known is left empty.
    """
    head = ["step", "time (s)"]
    for chart, _, title in lines:
        unit = f" ({chart.unit})" if chart.unit else ""
        head.append(f"{chart.title}: {title}{unit}" if len(chart.lines) > 1 else f"{chart.title}{unit}")
    rows = [",".join(head)]
    columns = [values[name] for _, name, _ in lines]
    for step in range(max(map(len, columns), default=0)):
        numbers = [float(column[step]) if step < len(column) else math.nan for column in columns]
        if not all(map(math.isnan, numbers)):
            shown = ["" if math.isnan(number) else repr(number) for number in numbers]
            rows.append(",".join([str(step), repr(step * step_seconds), *shown]))
    return "\n".join(rows) + "\n"
