"""Maps of Tiled: objects, solid tiles however they are packed, tilesets inside and beside, and both kinds of file."""

from __future__ import annotations

import base64
import gzip
import json
import struct
import zlib
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.errors import SceneError
from sandbox.formats.tiled.merge import merged
from tests.formats.conftest import Read, texts

RAMP = {"id": 1, "objectgroup": {"objects": [{"x": 0, "y": 16, "polygon": [
    {"x": 0, "y": 0}, {"x": 16, "y": -16}, {"x": 16, "y": 0}]}]}}  # fmt: skip
BLOCK = {"id": 0, "objectgroup": {"objects": [{"x": 0, "y": 0, "width": 16, "height": 16}]}}
TILES = {"firstgid": 1, "name": "tiles", "tilewidth": 16, "tileheight": 16, "tiles": [BLOCK, RAMP, {"id": 2}]}
BOMB = base64.b64encode(zlib.compress(bytes(10**7))).decode()


def tiled(*layers: dict[str, Any], **fields: Any) -> dict[str, Any]:
    base = {"type": "map", "orientation": "orthogonal", "width": 4, "height": 2, "tilewidth": 16, "tileheight": 16}
    return {**base, "layers": list(layers), "tilesets": [TILES], **fields}


def objects(*entries: dict[str, Any], **fields: Any) -> dict[str, Any]:
    return {"type": "objectgroup", "name": "things", "objects": list(entries), **fields}


def cells(*numbers: int, **fields: Any) -> dict[str, Any]:
    return {"type": "tilelayer", "name": "ground", "width": 4, "height": 2, "data": list(numbers), **fields}


class TestObjects:
    def body(self, read: Read, entry: dict[str, Any], **fields: Any) -> Any:
        (body,) = read(tiled(objects(entry, **fields))).scene.bodies
        return body

    def test_pixels_go_down_and_metres_up(self, read: Read) -> None:
        body = self.body(read, {"name": "box", "x": 16, "y": 0, "width": 32, "height": 16})
        assert (body.position, body.shapes[0].box, body.type) == ((2, 1.5), (2, 1), "static")

    def test_units_per_metre(self, read: Read) -> None:
        entry = {"name": "box", "x": 0, "y": 0, "width": 32, "height": 16}
        (body,) = read(tiled(objects(entry)), units=32.0).scene.bodies
        assert (body.position, body.shapes[0].box) == ((0.5, 0.75), (1, 0.5))

    def test_a_box_turns_clockwise_about_its_corner(self, read: Read) -> None:
        body = self.body(read, {"x": 16, "y": 16, "width": 32, "height": 16, "rotation": 90})
        assert (body.angle, body.position) == (-90, (0.5, 0))

    def test_a_circle_and_an_ellipse(self, read: Read) -> None:
        assert self.body(read, {"x": 0, "y": 0, "width": 16, "height": 16, "ellipse": True}).shapes[0].circle == 0.5
        imported = read(tiled(objects({"x": 0, "y": 0, "width": 32, "height": 16, "ellipse": True})))
        corners = imported.scene.bodies[0].shapes[0].polygon
        assert max(x for x, _ in corners) == pytest.approx(1)
        assert imported.remarks[0].place == f"layers[0].objects[0] ({len(corners)} sides)"

    def test_polygons_and_lines(self, read: Read) -> None:
        points = [{"x": 0, "y": 0}, {"x": 16, "y": 0}, {"x": 16, "y": 16}]
        assert self.body(read, {"x": 0, "y": 32, "polygon": points}).shapes[0].polygon == ((0, 0), (1, 0), (1, -1))
        assert self.body(read, {"x": 0, "y": 32, "polyline": points}).shapes[0].chain == ((0, 0), (1, 0), (1, -1))

    @pytest.mark.parametrize(
        "fields",
        [{"type": "dynamic"}, {"class": "Dynamic"}, {"properties": [{"name": "bodyType", "value": "dynamic"}]},
         {"properties": {"dynamic": True}}],
    )  # fmt: skip
    def test_class_and_properties_say_what_moves(self, read: Read, fields: dict[str, Any]) -> None:
        box = {"x": 0, "y": 0, "width": 16, "height": 16}
        assert self.body(read, box | fields).type == "dynamic"
        assert self.body(read, box, properties=[{"name": "type", "value": "kinematic"}]).type == "kinematic"

    def test_properties_of_bodies_and_surfaces(self, read: Read) -> None:
        properties = {"friction": 0.1, "bounce": 2, "gravityScale": 0.5, "fixed_rotation": True, "hp": 3}
        entry = {"name": "hero", "type": "dynamic", "x": 0, "y": 0, "width": 16, "height": 16}
        imported = read(tiled(objects(entry | {"properties": properties})))
        (body,) = imported.scene.bodies
        assert (body.gravity_scale, body.fixed_rotation) == (0.5, True)
        assert (body.shapes[0].friction, body.shapes[0].restitution) == (0.1, 1)
        assert imported.remarks[0].place == 'layers[0].objects[0] "hero" (hp)'

    def test_a_line_that_should_move_is_static(self, read: Read) -> None:
        line = [{"x": 0, "y": 0}, {"x": 16, "y": 0}]
        imported = read(tiled(objects({"type": "dynamic", "x": 0, "y": 0, "polyline": line})))
        assert imported.scene.bodies[0].type == "static"
        assert texts(imported) == ["a body that weighs nothing is static"]

    def test_groups_shift_what_is_in_them(self, read: Read) -> None:
        inner = objects({"x": 0, "y": 16, "width": 16, "height": 16}, offsetx=16, offsety=-16)
        group = {"type": "group", "name": "static", "offsetx": 32, "layers": [inner]}
        assert read(tiled(group)).scene.bodies[0].position == (3.5, 1.5)

    def test_points_text_and_templates_are_listed(self, read: Read) -> None:
        point, text = {"x": 1, "y": 1, "point": True}, {"x": 1, "y": 1, "width": 9, "height": 9, "text": {}}
        imported = read(tiled(objects(point, text, {"x": 0, "y": 0, "template": "a.tx"})))
        assert texts(imported)[:3] == [
            "a point is left out", "text is left out", "an object made of a template is left out"
        ]  # fmt: skip
        assert "nothing is solid" in texts(imported)[-1]

    def test_a_tile_that_stands_as_an_object(self, read: Read) -> None:
        entry = {"gid": 2, "type": "dynamic", "x": 16, "y": 32, "width": 32, "height": 32}
        body = self.body(read, entry)
        assert body.position == (1, 0)
        assert set(body.shapes[0].polygon) == {(0, 0), (2, 2), (2, 0)}


class TestTiles:
    GRID = (1, 1, 0, 2, 1, 1, 3, 0)

    def shapes(self, read: Read, layer: dict[str, Any], **fields: Any) -> Any:
        (body,) = read(tiled(layer, **fields)).scene.bodies
        return body.shapes

    def test_whole_tiles_are_one_box(self, read: Read) -> None:
        ramp, box = self.shapes(read, cells(*self.GRID))
        assert (box.box, box.at) == ((2, 2), (1, -1))
        assert set(ramp.polygon) == {(3, -1), (4, 0), (4, -1)}

    @pytest.mark.parametrize("packing", ["", "zlib", "gzip"])
    def test_however_they_are_packed(self, read: Read, packing: str) -> None:
        raw = struct.pack("<8I", *self.GRID)
        packed = {"": raw, "zlib": zlib.compress(raw), "gzip": gzip.compress(raw)}[packing]
        layer = cells() | {"data": base64.b64encode(packed).decode(), "encoding": "base64", "compression": packing}
        assert self.shapes(read, layer) == self.shapes(read, cells(*self.GRID))

    def test_chunks_of_a_map_without_an_end(self, read: Read) -> None:
        chunks = [{"x": -4, "y": 2, "width": 1, "height": 1, "data": [1]}]
        (body,) = read(tiled(cells() | {"chunks": chunks, "data": None}, infinite=True)).scene.bodies
        assert (body.position, body.shapes[0].at) == ((0, 0), (-3.5, -2.5))

    @pytest.mark.parametrize(
        ("flips", "corners"),
        [
            (0, {(0, 1), (1, 1), (1, 0)}), (8, {(0, 1), (1, 1), (0, 0)}), (4, {(0, 0), (1, 0), (1, 1)}),
            (2, {(1, 0), (0, 1), (1, 1)}), (8 + 4, {(0, 0), (1, 0), (0, 1)}), (8 + 2, {(0, 0), (1, 1), (0, 1)}),
        ],
    )  # fmt: skip
    def test_flipped_tiles(self, read: Read, flips: int, corners: set[tuple[int, int]]) -> None:
        """`corners` in the cell, y down, as Tiled turns them: the diagonal first."""
        (shape,) = self.shapes(read, cells(2 | flips << 28, 0, 0, 0, 0, 0, 0, 0))
        assert {(x, -y) for x, y in shape.polygon} == corners

    def test_tiles_without_a_shape_are_counted(self, read: Read) -> None:
        imported = read(tiled(cells(3, 3, 1, 0, 0, 0, 0, 0)))
        assert imported.remarks[0] == ('layers[0] "ground" (2)', "tiles without a collision shape are left out")

    def test_a_solid_layer_is_solid_all_over(self, read: Read) -> None:
        (box,) = self.shapes(read, cells(3, 3, 3, 3, 0, 0, 0, 0, properties=[{"name": "solid", "value": True}]))
        assert box.box == (4, 1)

    def test_zstd_is_told(self, read: Read) -> None:
        layer = cells() | {"data": "KLUv/Q==", "encoding": "base64", "compression": "zstd"}
        assert "packed by zstd" in texts(read(tiled(layer)))[0]

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"data": [1, 2]}, "has 2 cells; its width and height say 8"),
            ({"data": "!!", "encoding": "base64"}, "is not base64"),
            (
                {"data": BOMB, "compression": "zlib"},
                "33 bytes or more",
            ),
            ({"width": 10**6, "height": 10**6}, "has 1000000 x 1000000 cells"),
            ({"data": [-1] * 8}, "must be whole numbers of 32 bits"),
        ],
    )
    def test_damage(self, read: Read, change: dict[str, Any], message: str) -> None:
        with pytest.raises(SceneError, match=message):
            read(tiled(cells(*self.GRID) | change))


class TestTilesets:
    def test_beside_the_map(self, read: Read, tmp_path: Path) -> None:
        (tmp_path / "tiles.tsj").write_text(json.dumps(TILES))
        (tmp_path / "tiles.tsx").write_text(XML_TILES)
        for name in ("tiles.tsj", "tiles.tsx"):
            imported = read(tiled(cells(1, 1, 1, 1, 0, 0, 0, 0), tilesets=[{"firstgid": 1, "source": name}]))
            assert imported.scene.bodies[0].shapes[0].box == (4, 1)

    def test_one_that_is_not_there_is_told(self, read: Read) -> None:
        imported = read(tiled(cells(1, 0, 0, 0, 0, 0, 0, 0), tilesets=[{"firstgid": 1, "source": "gone.tsx"}]))
        assert imported.remarks[0] == (
            'tilesets[0] "gone.tsx"', "a tileset is left out: it is not beside the map"
        )  # fmt: skip

    def test_a_damaged_one_is_told_with_its_own_name(self, read: Read, tmp_path: Path) -> None:
        (tmp_path / "bad.tsj").write_text('{"tilewidth": "wide"}')
        with pytest.raises(SceneError, match=r"bad\.tsj:1:15: must be a number"):
            read(tiled(tilesets=[{"firstgid": 1, "source": "bad.tsj"}]))


XML_TILES = """<?xml version="1.0"?>
<tileset name="tiles" tilewidth="16" tileheight="16"><tile id="0"><objectgroup>
<object x="0" y="0"><polygon points="0,0 16,0 16,16 0,16"/></object></objectgroup></tile></tileset>"""
XML = f"""<?xml version="1.0" encoding="UTF-8"?>
<map orientation="orthogonal" width="4" height="2" tilewidth="16" tileheight="16">
 <tileset firstgid="1" {XML_TILES.partition("<tileset ")[2]}
 <layer name="ground" width="4" height="2"><data encoding="csv">1,1,0,0,
0,0,0,1</data></layer>
 <group offsetx="16"><objectgroup name="things"><object id="1" name="ball" class="dynamic" x="0" y="0" width="16"
   height="16"><properties><property name="friction" type="float" value="0.25"/></properties><ellipse/></object>
 </objectgroup></group>
</map>"""


class TestXml:
    def test_is_read_like_json(self, read: Read) -> None:
        ground, ball = read(XML, "map.tmx").scene.bodies
        assert [shape.box for shape in ground.shapes] == [(2, 1), (1, 1)]
        assert (ball.id, ball.position, ball.shapes[0].friction) == ("ball", (1.5, 1.5), 0.25)

    def test_mistakes_have_their_line(self, read: Read) -> None:
        with pytest.raises(SceneError, match=r"map\.tmx:7:1: must be a number, not text"):
            read(XML.replace('offsetx="16"', 'offsetx="far"'), "map.tmx")


@given(st.sets(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), max_size=40))
def test_merged_boxes_cover_the_cells_and_nothing_twice(cells: set[tuple[int, int]]) -> None:
    covered = [(x + i, y + j) for x, y, columns, rows in merged(cells) for i in range(columns) for j in range(rows)]
    assert sorted(covered) == sorted(cells)
