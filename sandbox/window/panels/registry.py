"""All panels, in the order of the menu."""

from __future__ import annotations

from sandbox.window.panels.compare.panel import ComparePanel
from sandbox.window.panels.events.panel import EventsPanel
from sandbox.window.panels.inspector.panel import InspectorPanel
from sandbox.window.panels.lessons import LessonsPanel
from sandbox.window.panels.overlays import OverlaysPanel
from sandbox.window.panels.panel import Panel
from sandbox.window.panels.plots.panel import PlotsPanel
from sandbox.window.panels.profile.panel import ProfilePanel
from sandbox.window.panels.sat import SatPanel
from sandbox.window.panels.world import WorldPanel

PANELS: tuple[type[Panel], ...] = (
    InspectorPanel,
    WorldPanel,
    OverlaysPanel,
    SatPanel,
    ComparePanel,
    EventsPanel,
    PlotsPanel,
    ProfilePanel,
    LessonsPanel,
)


def new_panels() -> dict[str, Panel]:
    """One of each, by name."""
    return {kind.name: kind() for kind in PANELS}
