"""Actions on what the colours of bodies mean, and on how deep the picture looks."""

from __future__ import annotations

from sandbox.render.coloring.registry import COLORINGS
from sandbox.render.overlays.look import Overlay
from sandbox.window.actions.action import Action
from sandbox.window.workspace import Workspace


def _choose(workspace: Workspace, coloring: Overlay) -> None:
    workspace.color_by = coloring.name


def _next(workspace: Workspace) -> None:
    names = list(COLORINGS)
    workspace.color_by = names[(names.index(workspace.color_by) + 1) % len(names)]
    workspace.say(f"colours: {COLORINGS[workspace.color_by].title.lower()}")


def _toggle_depth(workspace: Workspace) -> None:
    workspace.depth = not workspace.depth


def _by(coloring: Overlay) -> Action:
    return Action(
        f"color-by-{coloring.name}", coloring.title, "Colour by", (), coloring.help,
        lambda workspace: _choose(workspace, coloring), checked=lambda workspace: workspace.color_by == coloring.name,
    )  # fmt: skip


ACTIONS = (
    *(_by(coloring) for coloring in COLORINGS.values()),
    Action("color-by-next", "The next one", "Colour by", ("Shift+C",), "Let colours mean the next thing.", _next),
    Action("depth", "Shadows", "View", ("Shift+D",), "Whether what moves casts a soft shadow.", _toggle_depth,
           checked=lambda w: w.depth),
)  # fmt: skip
