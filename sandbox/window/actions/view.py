"""Actions on how the scene is seen."""

from __future__ import annotations

from sandbox.render.theme import DARK, LIGHT
from sandbox.scene.references import MOVING
from sandbox.window.actions.action import Action
from sandbox.window.steering import MENUS, PANELS
from sandbox.window.workspace import Workspace


def _toggle_interface(workspace: Workspace) -> None:
    workspace.interface = not workspace.interface


def _toggle_help(workspace: Workspace) -> None:
    workspace.help_shown = not workspace.help_shown


def _toggle_theme(workspace: Workspace) -> None:
    workspace.theme = LIGHT if workspace.theme is DARK else DARK


def _open_palette(workspace: Workspace) -> None:
    workspace.palette_shown = True


def _steer(workspace: Workspace, what: str) -> None:
    if what == PANELS and not workspace.panels:
        workspace.say("no panel is open; F1 shows the keys that open them")
        return
    workspace.interface = True
    workspace.steering.begin(what)


def _scale_text(workspace: Workspace, factor: float) -> None:
    workspace.text_scale = min(max(round(workspace.text_scale * factor, 3), 0.5), 3.0)


def _follow(workspace: Workspace) -> None:
    """The selected body, else what moves; nothing if anything is followed."""
    viewport = workspace.viewport
    selected = workspace.selection.present(workspace.session.world)
    if viewport.follow is not None:
        viewport.set_follow(None)
        workspace.say("nothing is followed")
    else:
        viewport.set_follow(selected[0] if selected else MOVING)
        workspace.say(f"following {selected[0] if selected else 'what moves'}")


ACTIONS = (
    Action("fit", "Fit", "View", ("F",), "Show all that there is to see now.", lambda w: w.viewport.fit(w.session)),
    Action("home-view", "As the scene asks", "View", ("0",), "Look as the scene asks for.",
           lambda w: w.viewport.look_home(w.session)),
    Action("follow", "Follow", "View", ("G",), "Go along with the selected body, or with what moves.", _follow,
           checked=lambda w: w.viewport.follow is not None),
    Action("zoom-in", "Zoom in", "View", ("Up",), "Nearer.", lambda w: w.viewport.zoom(1.05), held=True),
    Action("zoom-out", "Zoom out", "View", ("Down",), "Farther.", lambda w: w.viewport.zoom(1 / 1.05), held=True),
    Action("trails", "Trails", "View", ("Shift+T",), "Where moving bodies, or the selected ones, came from.",
           lambda w: w.toggle_overlay("trails"), checked=lambda w: "trails" in w.overlays),
    Action("interface", "Panels", "View", ("Tab",), "Show or hide all but the scene.", _toggle_interface,
           checked=lambda w: w.interface),
    Action("menus", "Menus by keyboard", "View", ("Ctrl+M",),
           "Open the menus: arrows go through them, Enter chooses, Esc comes back.",
           lambda w: _steer(w, MENUS)),
    Action("to-panels", "Panels by keyboard", "View", ("Ctrl+K",),
           "To the panel in front, then to the next: arrows and Tab go through it, Enter changes, Esc comes back.",
           lambda w: _steer(w, PANELS)),
    Action("theme", "Light", "View", ("F8",), "Light or dark.", _toggle_theme, checked=lambda w: w.theme is LIGHT),
    Action("larger-text", "Larger text", "View", ("Ctrl++", "Ctrl+="), "Text, buttons and panels a tenth larger.",
           lambda w: _scale_text(w, 1.1)),
    Action("smaller-text", "Smaller text", "View", ("Ctrl+-",), "Text, buttons and panels a tenth smaller.",
           lambda w: _scale_text(w, 1 / 1.1)),
    Action("less-motion", "Less motion", "View", (), "Nothing fades; what appears is there at once.",
           lambda w: setattr(w, "less_motion", not w.less_motion), checked=lambda w: w.less_motion),
    Action("palette", "Find and do", "Help", ("Ctrl+P", ":"), "Everything that can be done, found by typing.",
           _open_palette),
    Action("help", "Keys and mouse", "Help", ("F1", "H"), "All keys, and what the mouse does.", _toggle_help,
           checked=lambda w: w.help_shown),
)  # fmt: skip
