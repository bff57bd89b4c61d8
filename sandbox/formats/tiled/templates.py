"""Objects made of a template: a file with the object as it is where an instance does not say otherwise."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sandbox.formats.reading import MisreadError, Node
from sandbox.formats.remarks import Remarks
from sandbox.formats.tiled.beside import Beside
from sandbox.formats.tiled.cells import NUMBER
from sandbox.formats.tiled.tilesets import Tilesets
from sandbox.formats.tiled.tmx import template_of


class Templates:
    """The templates that a map refers to, each read once."""

    def __init__(self, folder: Path, sets: Tilesets, remarks: Remarks) -> None:
        self._beside, self._sets, self._remarks = Beside(folder, template_of), sets, remarks
        self._read: dict[str, dict[str, Any] | None] = {}

    def filled(self, node: Node) -> Node | None:
        """The object with what its template says; None, with a remark, if that is not there. Raises `SceneError`."""
        name = node.text("template")
        if not name:
            return node
        if name not in self._read:
            self._read[name] = self._beside.read(name, self._object)
        found = self._read[name]
        if found is None:
            place = f'{node.place} "{name[:60]}"'
            self._remarks.note(place, "an object is left out: its template is not beside the map")
            return None
        own = {key: value for key, value in node.data.items() if value is not None}
        properties = _by_name(found) | _by_name(own)
        return type(node)(found | own | ({"properties": properties} if properties else {}), node.path)

    def _object(self, root: Node, path: Path) -> dict[str, Any]:
        node, tiles = root.node("object"), root.node("tileset")
        if node is None:
            raise MisreadError((), "this is no template: it has no object")
        if node.has("gid") and tiles:
            first = self._sets.borrowed(path.parent / tiles.text("source").replace("\\", "/"))
            gid = node.whole("gid")
            return node.data | {"gid": gid - (gid & NUMBER) + first + (gid & NUMBER) - tiles.whole("firstgid", 1)}
        return node.data


def _by_name(data: dict[str, Any]) -> dict[str, Any]:
    given = data.get("properties")
    if isinstance(given, dict):
        return given
    pairs = given if isinstance(given, list) else []
    return {str(each.get("name")): each.get("value") for each in pairs if isinstance(each, dict)}
