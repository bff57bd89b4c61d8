"""The solver's switches: what each part of it is there for can be seen by switching it off."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from imgui_bundle import imgui

from sandbox.engine.commands.base import Command
from sandbox.engine.commands.set_settings import SetSettings
from sandbox.scene.limits import MAX_SUBSTEPS
from sandbox.window.adjustment import Adjustment
from sandbox.window.editor import Editor, Entry
from sandbox.window.widgets import Scale, checkbox, integer, label
from sandbox.window.workspace import Workspace

SWITCHES = (
    (
        "sleeping",
        "sleeping",
        "Off: what rests stays awake. A pile costs as much as when it fell.",
    ),
    (
        "warm_starting",
        "warm start",
        "Off: a substep begins with no impulses. Stacks go soft and sag.",
    ),
    ("accumulate", "accumulate", "Off: each impulse is clamped alone instead of the sum. Stacks jitter and creep."),
    ("soft", "soft contacts", "Off: rigid contacts, overlaps corrected by Baumgarte. What overlaps pops apart."),
    ("relax", "relax", "Off: the speed that pushes overlaps apart stays. Piles tremble, crates hop."),
    (
        "speculative",
        "speculative",
        "Off: contacts act only once shapes overlap. What is fast sinks in.",
    ),
)
"""Field, what it is called, and what one will see."""
_NUMBERS = {
    "contact_hertz": Entry("world.contact_hertz", "stiffness", Scale("Hz", 0.2, 1.0, 1e4),
                           "Of contacts. Low: shapes sink in as into foam."),
    "contact_damping_ratio": Entry("world.contact_damping_ratio", "damping", Scale("", 0.01, 0.0, 1e3),
                                   "Of contacts; 1 is critical. Low: what lands bobs up and down."),
    "push_out_speed": Entry("world.push_out_speed", "push-out", Scale("m/s", 0.02, 0.0, 1e6),
                            "Fastest recovery of an overlap. Low: what overlaps comes apart slowly."),
    "restitution_threshold": Entry("world.restitution_threshold", "bounce from", Scale("m/s", 0.01, 0.0, 1e6),
                                   "Slower impacts do not bounce. At 0 a ball never comes to rest."),
}  # fmt: skip


class SolverSwitches:
    """A section of the world panel."""

    def __init__(self) -> None:
        self._editor = Editor()
        self._editor.of = "the solver"
        self._substeps = Adjustment("Substeps")

    def draw(self, workspace: Workspace) -> None:
        """Substeps, switches, and figures of contacts."""
        setting = workspace.session.world.state.settings[0]
        tip = "Solver steps in a step. More: stiffer stacks and joints, at that much more time."
        label("substeps", tip)
        limits = 1, min(MAX_SUBSTEPS, MOST_SUBSTEPS)
        changed, count = integer("world.substeps", "", int(setting.substeps), tip, limits=limits)
        self._substeps.follow(workspace, changed, SetSettings(substeps=min(max(count, limits[0]), limits[1])))
        half = 0.5 * imgui.get_content_region_avail().x
        for number, (field, title, tip) in enumerate(SWITCHES):
            if number % 2:
                imgui.same_line(half)
            now = bool(setting[field])
            wanted = checkbox(f"world.{field}", title, now, tip)
            if wanted != now:
                what = {field: wanted}
                workspace.do(f"{title.capitalize()} {'on' if wanted else 'off'}", SetSettings(**what))
        for field, entry in _NUMBERS.items():
            self._draw_number(workspace, field, entry, float(setting[field]))

    def _draw_number(self, workspace: Workspace, field: str, entry: Entry, value: float) -> None:
        def change(value: float) -> Iterable[Command]:
            given: dict[str, Any] = {field: value}
            return [SetSettings(**given)]

        self._editor.number(workspace, entry, [value], change)


MOST_SUBSTEPS = 64
"""More can be given in a file; by hand, they would stop the picture."""
