"""Actions on what is in the world: undo, delete, select."""

from __future__ import annotations

from collections.abc import Callable

from sandbox.engine.commands.delete import Delete, DeleteJoint, DeleteRegion
from sandbox.engine.commands.spawn import Spawn
from sandbox.window.actions.action import Action
from sandbox.window.scaled import scaled_body, whole_body
from sandbox.window.workspace import Workspace
from sandbox.world.export.copies import Entries, copy_of, paste_of


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
        workspace.do(f"Delete {_told(bodies)}", Delete(bodies))
    elif selection.joint in world.joint_names and selection.joint is not None:
        workspace.do(f"Delete {selection.joint}", DeleteJoint(selection.joint))
    elif selection.region is not None and world.directory.find_region(selection.region) is not None:
        workspace.do(f"Delete {selection.region_title}", DeleteRegion(selection.region))
    else:
        workspace.say("there is nothing selected to delete")


def _select_all(workspace: Workspace) -> None:
    world = workspace.session.world
    moving = world.state.bodies.type != 0
    workspace.selection.pick_all(tuple(name for name, moves in zip(world.names, moving, strict=True) if moves))


def _copy(workspace: Workspace) -> bool:
    """Into the clipboard of this program; False if nothing is selected."""
    names = workspace.selection.present(workspace.session.world)
    if names:
        workspace.clipboard = copy_of(workspace.session.world, names)
        workspace.say(f"copied {_told(names)}")
    return bool(names)


def _cut(workspace: Workspace) -> None:
    if _copy(workspace):
        _delete(workspace)


def _paste(workspace: Workspace) -> None:
    """To where the pointer is, or a little beside where it was copied."""
    if workspace.clipboard is None:
        workspace.say("there is nothing to paste: copy something first")
        return
    bodies, joints = workspace.clipboard
    offset = _beside(workspace)
    if workspace.pointer is not None:
        xs = [entry.get("position", (0.0, 0.0))[0] for entry in bodies]
        ys = [entry.get("position", (0.0, 0.0))[1] for entry in bodies]
        offset = workspace.pointer[0] - sum(xs) / len(xs), workspace.pointer[1] - sum(ys) / len(ys)
    _spawn(workspace, "Paste", lambda: paste_of(workspace.session.world, bodies, joints, offset))


def _duplicate(workspace: Workspace) -> None:
    names = workspace.selection.present(workspace.session.world)
    if names:
        _spawn(workspace, "Duplicate", lambda: copy_of(workspace.session.world, names, _beside(workspace)))
    else:
        workspace.say("there is nothing selected to duplicate")


def _spawn(workspace: Workspace, title: str, make: Callable[[], Entries]) -> None:
    with workspace.attempt(f"{title} is not possible"):  # as so far away that nothing can be there
        entries = make()
        names = tuple(entry["id"] for entry in entries[0])
        if workspace.do(f"{title} {_told(names)}", Spawn(*entries)):
            workspace.selection.pick_all(names)


def _beside(workspace: Workspace) -> tuple[float, float]:
    """A twentieth of what is seen, to the right and up, in metres."""
    camera = workspace.viewport.camera
    step = 0.05 * camera.size[1] / camera.scale
    return step, step


def _scale(workspace: Workspace, factor: float) -> None:
    """Bodies of another size in the place of those selected; joints that hold them are gone with the old ones."""
    world = workspace.session.world
    names = workspace.selection.present(world)
    if not names:
        workspace.say("there is nothing selected to scale")
        return
    prefabs = {name: prefab.to_data() for name, prefab in workspace.session.scene.prefabs.items()}
    entries = [whole_body(entry, prefabs) for entry in copy_of(world, names)[0]]
    larger = [{**scaled_body(entry, factor), "id": name} for entry, name in zip(entries, names, strict=True)]
    lost = len([one for one in world.joints if set(one.bodies) & set(names)])
    if workspace.do(f"Scale {_told(names)}", Delete(names), Spawn(larger)) and lost:
        workspace.say(f"scaled; {lost} joints that held what was scaled are gone: Ctrl+Z brings them back")


def _told(names: tuple[str, ...]) -> str:
    return ", ".join(names) if len(names) <= 3 else f"{len(names)} bodies"


def _selected(workspace: Workspace) -> bool:
    """Bodies: nothing else can be copied or scaled."""
    return bool(workspace.selection.bodies)


def _deletable(workspace: Workspace) -> bool:
    selection = workspace.selection
    return bool(selection.bodies or selection.joint or selection.region)


ACTIONS = (
    Action("undo", "Undo", "Edit", ("Ctrl+Z",), "Take back the last act, and the time since.", _undo,
           enabled=lambda w: w.session.timeline.undo_label is not None),
    Action("redo", "Redo", "Edit", ("Ctrl+Y", "Ctrl+Shift+Z"), "Bring back what was undone.", _redo,
           enabled=lambda w: w.session.timeline.redo_label is not None),
    Action("cut", "Cut", "Edit", ("Ctrl+X",), "Copy what is selected, and delete it.", _cut, enabled=_selected),
    Action("copy", "Copy", "Edit", ("Ctrl+C",), "Copy what is selected, with the joints among it.", _copy,
           enabled=_selected),
    Action("paste", "Paste", "Edit", ("Ctrl+V",), "Bring what was copied to where the pointer is.", _paste,
           enabled=lambda w: w.clipboard is not None),
    Action("duplicate", "Duplicate", "Edit", ("Ctrl+D",), "A copy of what is selected beside it.", _duplicate,
           enabled=_selected),
    Action("enlarge", "Larger", "Edit", ("]",), "What is selected a tenth larger.", lambda w: _scale(w, 1.1),
           enabled=_selected),
    Action("shrink", "Smaller", "Edit", ("[",), "What is selected a tenth smaller.", lambda w: _scale(w, 1 / 1.1),
           enabled=_selected),
    Action("delete", "Delete", "Edit", ("Delete",), "Delete what is selected.", _delete, enabled=_deletable),
    Action("select-all", "Select all", "Edit", ("Ctrl+A",), "Select all that can move.", _select_all),
)  # fmt: skip
