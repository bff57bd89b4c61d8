"""The style sheet of the separating-axis pictures: one set of rules, in the colours of the light and the dark theme.

Colours are written out in every rule instead of as CSS variables, which not every viewer of SVG knows.
"""

from __future__ import annotations

from sandbox.render.oklab import oklch_to_srgb
from sandbox.render.svg import FONT
from sandbox.render.theme import DARK, LIGHT, Color, Theme

_HUES = {"a": 250.0, "b": 55.0, "gap": 150.0, "out": 350.0, "mtv": 305.0}
"""Shape a blue, shape b orange, a gap green, an overlap pink, the way out violet."""

_LAYOUT = f"""text {{ font-family: {FONT}; font-size: 14px; }}
.title {{ font-size: 22px; font-weight: 650; }}
.small {{ font-size: 12.5px; }}
.number {{ font-variant-numeric: tabular-nums; }}
.strong {{ font-weight: 650; }}
line, path, polygon, polyline, circle, rect {{ stroke-linecap: round; stroke-linejoin: round; fill: none; }}
.card {{ stroke-width: 1; }}
.grid {{ stroke-width: 1; }}
.shape {{ stroke-width: 2; fill-opacity: 0.22; }}
.ghost {{ stroke-width: 1.5; stroke-dasharray: 2 5; }}
.edge, .axis {{ stroke-width: 2; }}
.drop {{ stroke-width: 1; stroke-dasharray: 3 4; stroke-opacity: 0.8; }}
.rail {{ stroke-width: 1; }}
.faint {{ fill-opacity: 0.7; }}
.bar {{ stroke-width: 7; stroke-linecap: butt; }}
.mtv {{ stroke-width: 3; }}
.line {{ stroke-width: 2; stroke-dasharray: 9 6; }}
.thick {{ stroke-width: 4.5; }}
.band {{ fill-opacity: 0.2; }}
.hollow {{ stroke-width: 2; }}
.head, .dot {{ stroke-width: 0; }}"""


def style_sheet() -> str:
    """CSS for light pages, and for dark ones where the viewer says that it is dark."""
    return f"{_LAYOUT}\n{_colors(LIGHT)}\n@media (prefers-color-scheme: dark) {{\n{_colors(DARK)}\n}}"


def color_of(theme: Theme, name: str) -> Color:
    """The colour of `a`, `b`, `gap`, `out` or `mtv`."""
    return oklch_to_srgb(theme.lightness, theme.chroma * 1.15, _HUES[name])


def _colors(theme: Theme) -> str:
    ink, paper = theme.light, theme.background
    rules = [
        f"text {{ fill: {_hex(_mix(ink, paper, 0.12))}; }}",
        f".soft {{ fill: {_hex(_mix(ink, paper, 0.42))}; }}",
        f".card {{ fill: {_hex(paper)}; stroke: {_hex(theme.grid_axis)}; }}",
        f".grid {{ stroke: {_hex(theme.grid_major)}; }}",
        f".rail {{ stroke: {_hex(_mix(ink, paper, 0.6))}; }}",
        f".other {{ stroke: {_hex(_mix(ink, paper, 0.5))}; }}",
        f".other.shape {{ fill: {_hex(_mix(ink, paper, 0.5))}; stroke-width: 1; }}",
        f".rail.head {{ fill: {_hex(_mix(ink, paper, 0.6))}; }}",
        f".lit {{ fill: {_hex(theme.grid_minor)}; }}",
    ]
    for name in _HUES:
        color = _hex(color_of(theme, name))
        rules.append(f".{name} {{ stroke: {color}; }}")
        rules.append(
            f".{name}.head, .{name}.dot, .{name}.band, .{name}.shape, text.{name}, tspan.{name} {{ fill: {color}; }}"
        )
    rules.append("text[class], tspan[class], .band { stroke: none; }")
    return "\n".join(rules)


def _mix(color: Color, other: Color, amount: float) -> Color:
    red, green, blue = (one * (1.0 - amount) + two * amount for one, two in zip(color, other, strict=True))
    return red, green, blue


def _hex(color: Color) -> str:
    return "#" + "".join(f"{round(255 * part):02x}" for part in color)
