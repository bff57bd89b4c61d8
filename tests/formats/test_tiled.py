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
from sandbox.formats.reading import Node
from sandbox.formats.tiled.cells import SWAPPED, TURNED
from sandbox.formats.tiled.figures import Figure
from sandbox.formats.tiled.grid import grid_of
from sandbox.formats.tiled.merge import merged
from sandbox.formats.tiled.tileset import flipped
from tests.formats.conftest import Read, texts

RAMP = {"id": 1, "objectgroup": {"objects": [{"x": 0, "y": 16, "polygon": [
    {"x": 0, "y": 0}, {"x": 16, "y": -16}, {"x": 16, "y": 0}]}]}}  # fmt: skip
BLOCK = {"id": 0, "objectgroup": {"objects": [{"x": 0, "y": 0, "width": 16, "height": 16}]}}
TILES = {"firstgid": 1, "name": "tiles", "tilewidth": 16, "tileheight": 16, "tiles": [BLOCK, RAMP, {"id": 2}]}
ZSTD = "KLUv/QRobQAAAkICgjIQ/7x3/HsBAOSvZv0="
"""The grid of `TestTiles`."""
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
            "a point is left out", "text is left out", "an object is left out: its template is not beside the map"
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

    def test_packed_by_zstd(self, read: Read) -> None:
        packed = {"data": ZSTD, "encoding": "base64", "compression": "zstd"}
        assert self.shapes(read, cells() | packed) == self.shapes(read, cells(*self.GRID))

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"data": [1, 2]}, "has 2 cells; its width and height say 8"),
            ({"data": "!!", "encoding": "base64"}, "is not base64"),
            (
                {"data": BOMB, "compression": "zlib"},
                "33 bytes or more",
            ),
            ({"data": ZSTD[:20], "compression": "zstd"}, "the data end too early"),
            ({"width": 10**6, "height": 10**6}, "has 1000000 x 1000000 cells"),
            ({"data": [-1] * 8}, "must be whole numbers of 32 bits"),
        ],
    )
    def test_damage(self, read: Read, change: dict[str, Any], message: str) -> None:
        with pytest.raises(SceneError, match=message):
            read(tiled(cells(*self.GRID) | change))


HEXAGON = {(0, -9), (0, -3), (7, 0), (14, -3), (14, -9), (7, -12)}


class TestWays:
    """Maps that do not lie square: places as Tiled draws them."""

    @pytest.mark.parametrize(
        ("fields", "cell", "corner"),
        [
            ({"orientation": "isometric"}, (0, 0), (16, 16)), ({"orientation": "isometric"}, (3, 1), (48, 48)),
            ({"orientation": "staggered"}, (0, 1), (16, 24)), ({"orientation": "staggered"}, (2, 2), (64, 32)),
            ({"orientation": "staggered", "staggerindex": "even"}, (0, 0), (16, 16)),
            ({"orientation": "staggered", "staggeraxis": "x"}, (1, 0), (16, 24)),
            ({"orientation": "hexagonal", "hexsidelength": 4}, (1, 1), (48, 26)),
            ({"orientation": "hexagonal", "hexsidelength": 8, "staggeraxis": "x"}, (1, 1), (20, 40)),
        ],
    )  # fmt: skip
    def test_where_cells_are(self, fields: dict[str, Any], cell: tuple[int, int], corner: tuple[float, float]) -> None:
        """The lower left corner of the box around a cell, in pixels from the upper left of the map."""
        grid = grid_of(Node({"tilewidth": 32, "tileheight": 16, "width": 4, "height": 2, **fields}))
        assert grid.lower_left(*cell) == corner

    @pytest.mark.parametrize(
        ("fields", "height"),
        [({"orientation": "isometric"}, 48), ({"orientation": "staggered"}, 24), ({"orientation": "orthogonal"}, 32),
         ({"orientation": "hexagonal", "hexsidelength": 4}, 26),
         ({"orientation": "staggered", "staggeraxis": "x"}, 40)],
    )  # fmt: skip
    def test_how_high_the_map_is(self, fields: dict[str, Any], height: float) -> None:
        assert grid_of(Node({"tilewidth": 32, "tileheight": 16, "width": 4, "height": 2, **fields})).height == height

    def test_objects_of_isometric_maps_lie_at_a_slant(self, read: Read) -> None:
        crate = {"x": 16, "y": 0, "width": 16, "height": 16}
        (body,) = read(tiled(objects(crate), orientation="isometric", tilewidth=32)).scene.bodies
        assert body.position == (3, 2.5)
        assert set(body.shapes[0].polygon) == {(0, 0), (1, -0.5), (0, -1), (-1, -0.5)}

    def test_solid_cells_of_isometric_maps_are_one_field(self, read: Read) -> None:
        layer = cells(1, 1, 0, 0, 1, 1, 0, 0, properties=[{"name": "solid", "value": True}])
        imported = read(tiled(layer, orientation="isometric", tilewidth=32, tilesets=[]))
        assert set(imported.scene.bodies[0].shapes[0].polygon) == {(2, 0), (4, -1), (2, -2), (0, -1)}

    def test_solid_cells_of_hexagonal_maps_are_hexagons(self, read: Read) -> None:
        layer = cells(1, 0, 0, 0, 0, 0, 0, 0, properties=[{"name": "solid", "value": True}])
        hexagonal = {"orientation": "hexagonal", "tilewidth": 14, "tileheight": 12, "hexsidelength": 6}
        (shape,) = read(tiled(layer, **hexagonal, tilesets=[]), units=1.0).scene.bodies[0].shapes
        assert set(shape.polygon) == HEXAGON

    def test_tiles_of_hexagonal_maps_are_turned_by_sixths(self) -> None:
        point = Figure("polygon", ((7.0, 0.0),))
        for flips, corner in ((SWAPPED, (12.196, 3.0)), (TURNED, (12.196, 9.0)), (SWAPPED | TURNED, (7.0, 12.0))):
            assert flipped(point, (14.0, 12.0), flips, True).points[0] == pytest.approx(corner, abs=1e-3)

    def test_other_ways_are_told(self, read: Read) -> None:
        assert texts(read(tiled(orientation="oblique")))[0].startswith("the map is oblique")


class TestTemplates:
    XML = """<template><tileset firstgid="1" source="tiles.tsx"/><object name="crate" gid="1" width="16" height="16">
        <properties><property name="bodyType" value="dynamic"/><property name="density" type="float" value="2"/>
        </properties></object></template>"""
    JSON = json.dumps({"type": "template", "object": {"name": "crate", "width": 16, "height": 16, "properties": [
        {"name": "bodyType", "value": "dynamic"}, {"name": "density", "value": 2}]}})  # fmt: skip

    @pytest.mark.parametrize(("name", "text", "y"), [("crate.tx", XML, 32), ("sub/crate.tj", JSON, 16)])
    def test_an_instance_is_what_its_template_says_and_what_it_says_itself(
        self, read: Read, tmp_path: Path, name: str, text: str, y: float
    ) -> None:
        (tmp_path / "sub").mkdir()
        (tmp_path / "tiles.tsx").write_text(XML_TILES)
        (tmp_path / name).write_text(text)
        entry = {"template": name.replace("/", "\\"), "x": 16, "y": y, "properties": {"density": 3}}
        (body,) = read(tiled(objects(entry), tilesets=[])).scene.bodies
        assert (body.id, body.type, body.position) == ("crate", "dynamic", (1.5, 0.5))
        assert (body.shapes[0].box, body.shapes[0].density) == ((1, 1), 3)


class TestWhatIsSolid:
    FULL = (1, 1, 1, 1, 1, 1, 1, 1)

    @pytest.mark.parametrize(
        ("name", "grid", "count"),
        [("Ground", (3, 3, 3, 3, 0, 0, 0, 0), 1), ("wallLayer", (3, 0, 0, 0, 0, 0, 0, 0), 1),
         ("Ground", FULL, 0), ("sky", (3, 3, 0, 0, 0, 0, 0, 0), 0)],
    )  # fmt: skip
    def test_names_of_layers_tell_it_where_nothing_else_does(
        self, read: Read, name: str, grid: tuple[int, ...], count: int
    ) -> None:
        plain = {"firstgid": 1, "tilewidth": 16, "tileheight": 16}
        imported = read(tiled(cells(*grid, name=name), tilesets=[plain]))
        assert len(imported.scene.bodies) == count
        assert any(text.startswith("no tile has a collision shape") for text in texts(imported)) is bool(count)

    def test_layers_may_be_asked_for(self, read: Read) -> None:
        plain = {"firstgid": 1, "tilewidth": 16, "tileheight": 16}
        layers = {"type": "group", "layers": [cells(*self.FULL, name="sea"), cells(3, 0, 0, 0, 0, 0, 0, 0)]}
        assert len(read(tiled(layers, tilesets=[plain]), solid=["sea"]).scene.bodies) == 1
        with pytest.raises(SceneError, match='no tile layer is named "sky"; there are "sea", "ground"'):
            read(tiled(layers, tilesets=[plain]), solid=["sky"])
        nothing = texts(read(tiled(cells(3, 0, 0, 0, 0, 0, 0, 0, name="sea"), tilesets=[plain])))[-1]
        assert nothing.endswith('; or import it with --solid LAYER ("sea")')

    def test_names_tell_nothing_where_shapes_do(self, read: Read) -> None:
        point = {"x": 1, "y": 1, "point": True}
        imported = read(tiled(cells(3, 1, 0, 0, 0, 0, 0, 0, name="ground"), objects(point)))
        assert imported.scene.bodies[0].shapes[0].at == (1.5, -0.5)

    def test_a_tile_as_an_object_that_is_said_to_move_is_a_box(self, read: Read) -> None:
        tiles = {"firstgid": 1, "tilewidth": 64, "tileheight": 64, "tiles": [
            {"id": 0, "imagewidth": 32, "imageheight": 16}]}  # fmt: skip
        entry = {"gid": 1, "type": "dynamic", "x": 0, "y": 32}
        (body,) = read(tiled(objects(entry), tilesets=[tiles])).scene.bodies
        assert (body.shapes[0].box, body.position) == ((2, 1), (1, 0.5))

    def test_a_tile_that_is_not_square_is_turned_about_the_corner_that_it_stands_on(self, read: Read) -> None:
        drawn = {"x": 0, "y": 0, "width": 8, "height": 32}
        tiles = {"firstgid": 1, "tilewidth": 16, "tileheight": 32,
                 "tiles": [{"id": 0, "objectgroup": {"objects": [drawn]}}]}  # fmt: skip
        layer = cells(1 | SWAPPED, 0, 0, 0, 0, 0, 0, 0)
        (shape,) = read(tiled(layer, tilesets=[tiles])).scene.bodies[0].shapes
        assert (shape.box, shape.angle, shape.at) == ((0.5, 2), 90, (1, -0.25))


class TestFiles:
    def test_numbers_may_be_text(self, read: Read) -> None:
        entry = {"x": "16", "y": "0", "width": "16", "height": "16"}
        assert read(tiled(objects(entry), infinite="0")).scene.bodies[0].position == (1.5, 1.5)

    @pytest.mark.parametrize(
        ("content", "what"),
        [(TILES | {"type": "tileset"}, "tileset"), ('<tileset name="a"/>', "tileset"), ("<template/>", "template"),
         ({"maps": [], "onlyShowAdjacentMaps": False, "type": "world"}, "world")],
    )  # fmt: skip
    def test_parts_of_maps_are_told(self, read: Read, content: Any, what: str) -> None:
        with pytest.raises(SceneError, match=f"this is a {what} of Tiled: import"):
            read(content)

    def test_parallax_is_told(self, read: Read) -> None:
        assert texts(read(tiled(objects(parallaxx=0.5))))[0].startswith("parallax is left out")


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
