"""The contacts of the selected body: with whom, where, how deep and how hard. A click selects the other body."""

from __future__ import annotations

from typing import Any

import numpy as np
from imgui_bundle import imgui

from sandbox.tables import plain
from sandbox.window.widgets import mark
from sandbox.window.workspace import Workspace

MOST_ROWS = 8
"""Rows that are seen at once; the others are scrolled to."""
_FLAGS = (
    imgui.TableFlags_.row_bg | imgui.TableFlags_.scroll_y | imgui.TableFlags_.borders_inner_h
    | imgui.TableFlags_.sizing_stretch_prop
)  # fmt: skip
_COLUMNS = (("with", 2.2), ("gap mm", 1.3), ("impulse N s", 1.7))


def contacts_of(workspace: Workspace, body: int) -> Any:
    """The numbers of the contacts that a body is part of."""
    contacts = plain(workspace.session.world.contacts)
    return np.flatnonzero((contacts["body_a"] == body) | (contacts["body_b"] == body))


def draw_contacts(workspace: Workspace, body: int, found: Any) -> None:
    """A table of the contacts `found` of a body."""
    world = workspace.session.world
    contacts, impulses = world.contacts, world.contact_impulses
    line = imgui.get_frame_height_with_spacing() - 2.0
    height = line * (1 + min(len(found), MOST_ROWS)) + 4.0
    if not imgui.begin_table("contacts", len(_COLUMNS), _FLAGS, imgui.ImVec2(0.0, height)):
        return
    imgui.table_setup_scroll_freeze(0, 1)
    for title, share in _COLUMNS:
        imgui.table_setup_column(title, imgui.TableColumnFlags_.width_stretch, share)
    imgui.table_headers_row()
    clipper, clicked = imgui.ListClipper(), ""
    clipper.begin(len(found))
    while clipper.step():
        for number in range(clipper.display_start, clipper.display_end):
            index = int(found[number])
            name = _draw_row(world, body, contacts[index], float(impulses[index]))
            clicked = name if imgui.is_item_clicked() else clicked
            mark(f"inspector.contact.{number}", contact_text(contacts[index]))
    imgui.end_table()
    if clicked:
        workspace.selection.pick(clicked)


def _draw_row(world: Any, body: int, contact: Any, impulse: float) -> str:
    other = int(contact.body_b if contact.body_a == body else contact.body_a)
    gaps = [1000.0 * float(contact[f"separation{k}"]) for k in range(1, int(contact.point_count) + 1)]
    imgui.table_next_row()
    imgui.table_set_column_index(1)
    imgui.text_unformatted(f"{min(gaps):.3f}")
    imgui.table_set_column_index(2)
    (imgui.text_unformatted if contact.touching else imgui.text_disabled)(f"{impulse:.4g}" if impulse else "–")
    imgui.table_set_column_index(0)
    name = str(world.names[other])
    unique = f"{name}##contact {contact.shape_a} {contact.shape_b}"
    imgui.selectable(unique, False, imgui.SelectableFlags_.span_all_columns)
    return name


def contact_text(contact: Any) -> str:
    """All of one contact in words: normal, friction, and its points with what they pass on in a substep."""
    lines = [
        f"shapes {contact.shape_a} and {contact.shape_b}, {'touching' if contact.touching else 'near each other'}",
        f"normal {contact.normal_x:.4f}, {contact.normal_y:.4f}",
        f"friction {contact.friction:.3g}, restitution {contact.restitution:.3g}",
    ]
    for k in range(1, int(contact.point_count) + 1):
        lines.append(
            f"point {k}: gap {1000.0 * contact[f'separation{k}']:.3f} mm, in the last substep"
            f" {contact[f'normal_impulse{k}']:.4g} N s along the normal, {contact[f'tangent_impulse{k}']:.4g} across"
        )
    return "\n".join(lines)
