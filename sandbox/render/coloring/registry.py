"""All ways to colour bodies by name."""

from __future__ import annotations

from collections.abc import Mapping

from sandbox.errors import ArgumentError
from sandbox.render.coloring import density, group, island, mass, material, sleep, speed, theme
from sandbox.render.overlays.look import Overlay
from sandbox.scene.near_names import did_you_mean

THEME = theme.COLORING.name
"""What bodies are coloured by unless something else is asked for."""
COLORINGS: Mapping[str, Overlay] = {
    module.COLORING.name: module.COLORING
    for module in (theme, material, group, speed, sleep, island, mass, density)
}  # fmt: skip
"""Each is an overlay that colours the bodies and says what the colours mean."""


def find_coloring(name: str) -> Overlay:
    """The way to colour of a name. Raises `ArgumentError` with the nearest one."""
    if name not in COLORINGS:
        hint = did_you_mean(name, COLORINGS) or f"there are {', '.join(COLORINGS)}"
        raise ArgumentError(f"no way to colour bodies is called {name!r}; {hint}")
    return COLORINGS[name]


def shown_coloring(name: str) -> list[Overlay]:
    """The overlay that colours bodies so, if any is needed."""
    return [] if name == THEME else [COLORINGS[name]]
