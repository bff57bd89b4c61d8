"""What there is to select: bodies, joints and regions by name, found as one types."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from imgui_bundle import icons_fontawesome_6 as icons
from imgui_bundle import imgui

from sandbox.window.panels.inspector.bodies import TYPES
from sandbox.window.widgets import mark, text, wrapped
from sandbox.window.workspace import Workspace
from sandbox.world.build_fields import KINDS as REGION_KINDS
from sandbox.world.joint_records import KINDS as JOINT_KINDS

if TYPE_CHECKING:
    from sandbox.engine.world import World

ICONS = {"body": icons.ICON_FA_SQUARE, "joint": icons.ICON_FA_LINK}
_REGION_ICONS = {
    "water": icons.ICON_FA_DROPLET, "wind": icons.ICON_FA_WIND, "gravity": icons.ICON_FA_ARROW_DOWN,
    "gravity_scale": icons.ICON_FA_FEATHER, "attraction": icons.ICON_FA_SUN,
}  # fmt: skip
_HINT = (
    "Click a body in the scene to see all of it here; Shift adds another. Click on an anchor for its joint, or into "
    "water, wind or another field for that."
)
_REGIONS = {number: name for name, number in REGION_KINDS.items()}
_FLAGS = imgui.TableFlags_.row_bg | imgui.TableFlags_.scroll_y | imgui.TableFlags_.sizing_stretch_prop


@dataclass(frozen=True)
class Found:
    """One that can be selected: "body", "joint" or "region", its id and its row."""

    sort: str
    name: str
    row: int


class Finder:
    """The list; what it found is kept until names or rows change."""

    def __init__(self) -> None:
        self._words = ""
        self._key: tuple[object, ...] = ()
        self._found: list[Found] = []

    def draw(self, workspace: Workspace) -> None:
        """A hint, the line to type in, and the list."""
        wrapped(_HINT)
        imgui.set_next_item_width(-1.0)
        self._words = text("inspector.search", "", self._words, f"{icons.ICON_FA_MAGNIFYING_GLASS}  search")
        world = workspace.session.world
        key = world.layout, len(world.names), len(world.joint_names), world.state.census.regions.ids, self._words
        if key != self._key:
            self._key, self._found = key, matching(everything(world), self._words)
        if not self._found:
            wrapped("Nothing of that name." if self._words else "The scene is empty.")
        elif imgui.begin_table("everything", 2, _FLAGS, imgui.ImVec2(0.0, 0.0)):
            imgui.table_setup_column("name", imgui.TableColumnFlags_.width_stretch, 2.0)
            imgui.table_setup_column("kind", imgui.TableColumnFlags_.width_stretch, 1.0)
            self._draw_rows(workspace)
            imgui.end_table()

    def _draw_rows(self, workspace: Workspace) -> None:
        clipper = imgui.ListClipper()
        clipper.begin(len(self._found))
        while clipper.step():
            for number in range(clipper.display_start, clipper.display_end):
                one = self._found[number]
                imgui.table_next_row()
                imgui.table_set_column_index(0)
                kind = kind_of(workspace.session.world, one)
                shown = f"{ICONS.get(one.sort) or _REGION_ICONS[kind]}  {one.name}##{one.sort} {one.row}"
                clicked, _ = imgui.selectable(shown, False, imgui.SelectableFlags_.span_all_columns)
                mark(f"inspector.find.{one.name}")
                imgui.table_set_column_index(1)
                imgui.text_disabled(kind.replace("_", " "))
                if clicked:
                    select(workspace, one)


def everything(world: World) -> list[Found]:
    """All bodies, all joints that have a name, and all regions, in that order."""
    regions = world.state.census.regions
    rows = (("body", world.names), ("joint", world.joint_names),
            ("region", [regions.called(row) for row in range(len(regions))]))  # fmt: skip
    return [Found(sort, name, row) for sort, names in rows for row, name in enumerate(names) if name]


def matching(found: list[Found], words: str) -> list[Found]:
    """Those whose name or sort holds every word."""
    wanted = words.lower().split()
    return [one for one in found if all(word in f"{one.sort} {one.name}".lower() for word in wanted)]


def kind_of(world: World, one: Found) -> str:
    """What kind of body, joint or region it is, as scene files say it."""
    if one.sort == "body":
        return TYPES[int(world.state.bodies.type[one.row])]
    if one.sort == "joint":
        return JOINT_KINDS[int(world.state.joints.kind[one.row])]
    return _REGIONS[int(world.state.regions.kind[one.row])]


def select(workspace: Workspace, one: Found) -> None:
    """Select what was found; with Shift, a body is added."""
    if one.sort == "body":
        workspace.selection.pick(one.name, bool(imgui.get_io().key_shift))
    elif one.sort == "joint":
        workspace.selection.pick_joint(one.name)
    else:
        workspace.selection.pick_region(one.name)
