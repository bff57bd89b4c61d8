"""Actions on what is in the world: undo, delete, select."""

from __future__ import annotations

from sandbox.engine.commands.delete import Delete, DeleteJoint
from sandbox.window.actions.action import Action
from sandbox.window.workspace import Workspace


def _undo(workspace: Workspace) -> None:
    workspace.interrupt()
    label = workspace.session.undo()
    workspace.say(f"undone: {label}" if label else "there is nothing to undo")


def _redo(workspace: Workspace) -> None:
    workspace.interrupt()
    label = workspace.session.redo()
    workspace.say(f"done again: {label}" if label else "there is nothing to redo")


def _delete(workspace: Workspace) -> None:
    selection, world = workspace.selection, workspace.session.world
    bodies = selection.present(world)
    if bodies:
        workspace.do(f"Delete {', '.join(bodies)}", Delete(bodies))
    elif selection.joint in world.joint_names and selection.joint is not None:
        workspace.do(f"Delete {selection.joint}", DeleteJoint(selection.joint))
    else:
        workspace.say("there is nothing selected to delete")


def _select_all(workspace: Workspace) -> None:
    world = workspace.session.world
    moving = world.state.bodies.type != 0
    workspace.selection.bodies = tuple(name for name, moves in zip(world.names, moving, strict=True) if moves)


def _selected(workspace: Workspace) -> bool:
    return bool(workspace.selection.bodies or workspace.selection.joint)


ACTIONS = (
    Action("undo", "Undo", "Edit", ("Ctrl+Z",), "Take back the last act, and the time since.", _undo,
           enabled=lambda w: w.session.timeline.undo_label is not None),
    Action("redo", "Redo", "Edit", ("Ctrl+Y", "Ctrl+Shift+Z"), "Bring back what was undone.", _redo,
           enabled=lambda w: w.session.timeline.redo_label is not None),
    Action("delete", "Delete", "Edit", ("Delete",), "Delete what is selected.", _delete, enabled=_selected),
    Action("select-all", "Select all", "Edit", ("Ctrl+A",), "Select all that can move.", _select_all),
)  # fmt: skip
