"""What is selected, with live values: bodies with their shapes, contacts and thrusters, a joint, or a region."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.tables import Integers, plain
from sandbox.window.editor import Editor
from sandbox.window.fitting import fitting
from sandbox.window.panels.inspector.bodies import describe, draw_mass, draw_motion
from sandbox.window.panels.inspector.contacts import contacts_of, draw_contacts
from sandbox.window.panels.inspector.finder import Finder
from sandbox.window.panels.inspector.joint import draw_joint
from sandbox.window.panels.inspector.region import draw_region
from sandbox.window.panels.inspector.surfaces import Surfaces
from sandbox.window.panels.inspector.thrusters import draw_thrusters, thrusters_of
from sandbox.window.panels.panel import Panel
from sandbox.window.tools.region_handles import middle_of
from sandbox.window.widgets import button, mark, section
from sandbox.window.workspace import Workspace


class InspectorPanel(Panel):
    """Shows what is selected, and changes it."""

    name = "inspector"
    title = "Inspector"
    icon = icons.ICON_FA_MAGNIFYING_GLASS
    help = "What is selected, with live values to drag or type."
    key = "F2"
    shown_at_first = True

    def __init__(self) -> None:
        self._editor = Editor()
        self._surfaces = Surfaces()
        self._finder = Finder()
        self._key: tuple[tuple[str, ...], int] = ((), -1)
        self._names: Sequence[str] = ()
        self._rows: Integers = np.zeros(0, np.int64)

    def draw(self, workspace: Workspace) -> None:
        """What is selected, or what could be."""
        selection, world = workspace.selection, workspace.session.world
        bodies = self._bodies(workspace)
        if bodies:
            self._draw_bodies(workspace, bodies)
        elif selection.joint in world.joint_names and selection.joint:
            joint = world.joint(selection.joint)
            _draw_head(workspace, joint.id, joint.type, joint.anchors[1] if joint.type != "gear" else None)
            draw_joint(workspace, self._editor, joint)
        elif selection.region is not None and world.directory.find_region(selection.region) is not None:
            _draw_head(workspace, selection.region_title, "", middle_of(world, selection.region))
            draw_region(workspace, self._editor, selection.region)
        else:
            self._finder.draw(workspace)

    def _bodies(self, workspace: Workspace) -> Sequence[str]:
        """The ids of the bodies that are selected; their rows are kept until others are, or rows have moved."""
        selection, world = workspace.selection, workspace.session.world
        key = selection.bodies, world.layout
        if key[0] is not self._key[0] or key[1] != self._key[1]:
            self._key, self._names = key, selection.present(world)
            self._rows = np.array([world.directory.body(name) for name in self._names], np.int64)
        return self._names

    def _draw_bodies(self, workspace: Workspace, names: Sequence[str]) -> None:
        world, rows = workspace.session.world, self._rows
        table = plain(world.state.bodies)
        middle = float(table["center_x"][rows].mean()), float(table["center_y"][rows].mean())
        title = names[0] if len(names) == 1 else f"{len(names):,} bodies"
        self._editor.of = title
        _draw_head(workspace, title, describe(workspace, rows), middle)
        if section("Motion"):
            draw_motion(workspace, self._editor, names, rows)
        if section("Body"):
            draw_mass(workspace, rows)
        if section("Surface"):
            self._surfaces.draw(workspace, self._editor, names, rows)
        if len(names) == 1:
            self._draw_one(workspace, names[0], int(rows[0]))

    def _draw_one(self, workspace: Workspace, name: str, body: int) -> None:
        """What only a single body shows."""
        thrusters = thrusters_of(workspace, body)
        if len(thrusters) and section("Thrusters"):
            draw_thrusters(workspace, self._editor, name, thrusters)
        _draw_joints(workspace, body)
        contacts = contacts_of(workspace, body)
        if section(f"Contacts ({len(contacts):,})###contacts") and len(contacts):
            draw_contacts(workspace, body, contacts)


def _draw_head(workspace: Workspace, name: str, kind: str, place: tuple[float, float] | None) -> None:
    """Name and kind, and at the right what brings it into view and what unselects it."""
    right = imgui.get_cursor_pos_x() + imgui.get_content_region_avail().x
    width, gap = imgui.get_frame_height(), imgui.get_style().item_spacing.x
    room = imgui.get_content_region_avail().x - imgui.calc_text_size(kind).x - 2.0 * width - 4.0 - 2.0 * gap
    shown = fitting(name, room)
    imgui.align_text_to_frame_padding()
    imgui.text_unformatted(shown)
    mark("inspector.name", name if shown != name else "")
    imgui.same_line()
    imgui.text_disabled(kind)
    mark("inspector.kind")
    imgui.same_line(right - 2.0 * width - 4.0)
    if button("inspector.center", icons.ICON_FA_CROSSHAIRS, "Bring it into the middle of the picture.",
              enabled=place is not None, width=width) and place is not None:  # fmt: skip
        workspace.viewport.center_on(place)
    imgui.same_line(0.0, 4.0)
    if button("inspector.clear", icons.ICON_FA_XMARK, "Unselect: back to the list of all there is.", width=width):
        workspace.selection.clear()


def _draw_joints(workspace: Workspace, body: int) -> None:
    """The joints that hold a body, to be selected by a click."""
    world = workspace.session.world
    table = plain(world.state.joints)
    rows = np.flatnonzero((table["body_a"] == body) | (table["body_b"] == body))
    if not len(rows) or not section(f"Joints ({len(rows):,})###joints"):
        return
    for row in rows[:MOST_JOINTS]:
        joint: Any = world.joint_names[row]
        if button(f"inspector.joint.{joint}", f"{icons.ICON_FA_LINK}  {joint}", "Select this joint."):
            workspace.selection.pick_joint(joint)


MOST_JOINTS = 50
