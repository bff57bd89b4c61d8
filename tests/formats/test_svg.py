"""Drawings in SVG: shapes, maps, styles, holes, what a body is, and files that mean harm."""

from __future__ import annotations

import contextlib
import math
import time
from typing import Any

import pytest

from sandbox.errors import SceneError
from sandbox.formats.svg import reader
from sandbox.formats.svg.sheet import Sheet
from tests.formats.conftest import Read, texts


def svg(content: str, size: str = 'width="320" height="320"', before: str = "") -> str:
    spaces = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
    return f"{before}<svg {spaces} {size}>{content}</svg>"


def bodies(read: Read, content: str, size: str = 'width="320" height="320"') -> Any:
    return read(svg(content, size)).scene.bodies


class TestShapes:
    def test_a_rect_is_a_box_with_y_up(self, read: Read) -> None:
        (body,) = bodies(read, '<rect id="crate" x="32" y="0" width="64" height="32" fill="#c08040"/>')
        assert (body.id, body.position, body.shapes[0].box, body.color) == ("crate", (2, 9.5), (2, 1), "#c08040")

    def test_rounded_corners_are_inside_in_both(self, read: Read) -> None:
        (body,) = bodies(read, '<rect width="64" height="32" rx="8"/>')
        assert (body.shapes[0].box, body.shapes[0].radius) == ((2, 1), 0.25)
        (pill,) = bodies(read, '<rect width="96" height="32" rx="16"/>')
        assert (pill.shapes[0].capsule, pill.shapes[0].radius) == (((-1, 0), (1, 0)), 0.5)

    def test_circle_and_ellipse(self, read: Read) -> None:
        ball, egg = bodies(read, '<circle cx="32" cy="32" r="16"/><ellipse cx="99" cy="50" rx="32" ry="16"/>')
        assert (ball.position, ball.shapes[0].circle) == ((1, 9), 0.5)
        assert max(x for x, _ in egg.shapes[0].polygon) == pytest.approx(1)

    def test_polygon_path_line_and_polyline(self, read: Read) -> None:
        drawn = bodies(
            read,
            '<polygon points="0,0 32,0 0,32"/><path d="M64 0h32v32z"/><g stroke="red" fill="none">'
            '<line x2="32" y2="0"/><polyline points="0,0 32,0 32,32" stroke-width="0"/></g>',
        )
        assert [body.type for body in drawn] == ["dynamic", "dynamic", "static", "static"]
        assert (drawn[2].shapes[0].segment, drawn[2].shapes[0].radius) == (((-0.5, 0), (0.5, 0)), 1 / 64)
        assert drawn[3].shapes[0].chain == ((-0.5, 0.5), (0.5, 0.5), (0.5, -0.5))

    def test_curves_within_the_tolerance(self, read: Read) -> None:
        disc = svg('<path d="M160 0A160 160 0 0 1 160 320A160 160 0 0 1 160 0z"/>')
        coarse, fine = (read(disc, tolerance=t).scene.bodies[0].shapes[0].polygon for t in (0.02, 0.002))
        assert len(coarse) < len(fine)
        for (ax, ay), (bx, by) in zip(coarse, [*coarse[1:], coarse[0]], strict=True):
            assert math.hypot((ax + bx) / 2, (ay + by) / 2) >= 5 - 0.0201

    @pytest.mark.parametrize(
        ("rule", "inner", "holes"),
        [("evenodd", "M96 96h128v128h-128z", 1), ("nonzero", "M96 96h128v128h-128z", 0),
         ("nonzero", "M96 96v128h128v-128z", 1)],
    )  # fmt: skip
    def test_holes_by_the_fill_rule(self, read: Read, rule: str, inner: str, holes: int) -> None:
        (body,) = bodies(read, f'<path fill-rule="{rule}" d="M32 32h256v256h-256z {inner}"/>')
        assert len(body.shapes[0].holes) == holes

    def test_an_island_in_a_hole_is_another_shape(self, read: Read) -> None:
        rings = "M32 32h256v256h-256z M96 96h128v128h-128z M128 128h64v64h-64z"
        (body,) = bodies(read, f'<path fill-rule="evenodd" d="{rings}"/>')
        assert [len(shape.holes) for shape in body.shapes] == [1, 0]

    @pytest.mark.parametrize(
        ("attributes", "counts"),
        [
            ('d="M32 32L96 96H32L96 32z"', [(3, 0), (3, 0)]),  # a bow tie
            ('fill-rule="evenodd" d="M160 32L220 220L64 96H256L100 220z"', [(3, 0)] * 5),  # a star: its points
            ('d="M160 32L220 220L64 96H256L100 220z"', [(10, 0)]),  # and all of it
            ('d="M32 32h64v64h-64z M64 64h64v64h-64z"', [(8, 0)]),
            ('fill-rule="evenodd" d="M32 32h64v64h-64z M64 64h64v64h-64z"', [(6, 0), (6, 0)]),
            ('fill-rule="evenodd" d="M32 32h128v128h-128z M32 96l32-32 32 32-32 32z"', [(9, 0)]),  # a hole at the side
            ('d="M32 32h128v128h-128z M32 32h128v128h-128z"', [(4, 0)]),
            ('fill-rule="evenodd" d="M32 32h256v256h-256z M64 64l64 64h-64l64-64z"', [(4, 1)]),  # holes that touch
        ],
    )
    def test_rings_that_cross_are_cut_apart(self, read: Read, attributes: str, counts: list[tuple[int, int]]) -> None:
        imported = read(svg(f"<path {attributes}/>"))
        (body,) = imported.scene.bodies
        assert [(len(shape.polygon), len(shape.holes)) for shape in body.shapes] == counts
        assert imported.remarks == ()

    def test_a_path_goes_on_where_it_was_closed(self, read: Read) -> None:
        (body,) = bodies(read, '<path d="M32 32h32v32z v-32h-16z"/>')
        assert len(body.shapes) == 2


class TestMaps:
    @pytest.mark.parametrize(
        ("transform", "position", "angle"),
        [("translate(32 64)", (1.5, 7.5), 0), ("rotate(30)", None, 150), ("rotate(90 16 16)", (0.5, 9.5), 90),
         ("matrix(1 0 0 1 32,0)", (1.5, 9.5), 0), ("translate(32) rotate(0)", (1.5, 9.5), 0)],
    )  # fmt: skip
    def test_similar_maps_keep_boxes(self, read: Read, transform: str, position: Any, angle: float) -> None:
        (body,) = bodies(read, f'<rect width="32" height="32" transform="{transform}"/>')
        assert body.shapes[0].box == (1, 1)
        assert body.shapes[0].angle == pytest.approx(angle)
        assert position is None or body.position == pytest.approx(position)

    def test_other_maps_make_polygons(self, read: Read) -> None:
        for transform in ("scale(2 1)", "skewX(20)", "matrix(1 0.5 0 1 0 0)"):
            (body,) = bodies(read, f'<rect width="32" height="32" transform="{transform}"/>')
            assert len(body.shapes[0].polygon) == 4

    def test_view_box_and_units(self, read: Read) -> None:
        (body,) = bodies(read, '<circle cx="5" cy="5" r="5"/>', 'width="1in" height="2in" viewBox="0 0 10 10"')
        assert (body.shapes[0].circle, body.position) == (pytest.approx(1.5), pytest.approx((1.5, 3)))

    @pytest.mark.parametrize(
        ("how", "position"),
        [
            ('transform="rotate(90, 16 16)"', (0.5, 9.5)), ('style="transform:translate(32px,0px)"', (1.5, 9.5)),
            ('style="transform: rotate(0.25turn); transform-origin: 32px 32px"', (1.5, 9.5)),
            ('class="moved"', (0.5, 8.5)), ('transform="translateX(5) scaleX(2)"', None),
        ],
    )  # fmt: skip
    def test_transforms_of_style_sheets(self, read: Read, how: str, position: Any) -> None:
        sheet = "<style>.moved { transform: translateY(32px) }</style>"
        (body,) = bodies(read, f'{sheet}<rect width="32" height="32" {how}/>')
        assert position is None or body.position == pytest.approx(position)

    @pytest.mark.parametrize(
        "how", ["spin(3)", "rotate(3furlong)", "translate(1 2", "scale(2);transform-origin:center"]
    )
    def test_what_cannot_be_read_is_told(self, read: Read, how: str) -> None:
        imported = read(svg(f'<rect width="32" height="32" style="transform:{how}"/>'))
        assert texts(imported)[0] == "what has a transform that cannot be read is left out"

    @pytest.mark.parametrize(
        ("way", "position"),
        [("", (5, 5)), ("xMinYMin meet", (2.5, 5)), ("xMaxYMax", (7.5, 5)), ("xMidYMax slice", (5, 10)),
         ("none", (5, 5))],
    )  # fmt: skip
    def test_how_a_view_box_is_fitted(self, read: Read, way: str, position: Any) -> None:
        size = f'width="320" height="320" viewBox="0 0 10 20" preserveAspectRatio="{way}"'
        (body,) = bodies(read, '<circle cx="5" cy="10" r="2"/>', size)
        assert body.position == pytest.approx(position)

    def test_symbols_have_the_size_of_their_use(self, read: Read) -> None:
        symbol = '<symbol id="s" viewBox="0 0 1 1"><circle cx=".5" cy=".5" r=".5"/></symbol>'
        (body,) = bodies(read, f'{symbol}<use href="#s" x="32" width="64" height="64"/>')
        assert (body.position, body.shapes[0].circle) == ((2, 9), 1)

    def test_use_and_symbols(self, read: Read) -> None:
        defs = '<defs><circle id="ball" r="16"/></defs><symbol id="s"><rect width="32" height="32"/></symbol>'
        uses = '<use href="#ball" x="32"/><use xlink:href="#ball" transform="scale(2)"/><use href="#s" y="32"/>'
        one, two, box = bodies(read, defs + uses)
        assert (one.position, two.shapes[0].circle, box.position) == ((1, 10), 1, (0.5, 8.5))


class TestStyles:
    def test_sheets_attributes_and_style_in_their_order(self, read: Read) -> None:
        sheet = "<style>/* a */ circle{fill:red} .b, #c{fill:lime}</style>"
        drawn = bodies(
            read, f'{sheet}<circle r="9" fill="blue"/><circle r="9" class="b"/><circle id="c" r="9" style="fill:#123"/>'
        )
        assert [body.color for body in drawn] == ["#ff0000", "#00ff00", "#112233"]

    @pytest.mark.parametrize(
        ("selector", "fits"),
        [("g circle", True), ("g > circle", True), ("svg > circle", False), ("svg #out .in", True), ("#out>.in", True),
         ("svg g circle.in", True), ("g g circle", False), (".in circle", False), ("#out#in", False), ("g *", True)],
    )  # fmt: skip
    def test_selectors_of_several_parts(self, read: Read, selector: str, fits: bool) -> None:
        sheet = f"<style>{selector} {{ fill: #00ff00 }}</style>"
        (body,) = bodies(read, f'{sheet}<g id="out"><circle class="in" r="9" fill="#ff0000"/></g>')
        assert (body.color == "#00ff00") is fits

    def test_other_selectors_are_counted(self, read: Read) -> None:
        dark = "@charset 'x'; @media print { circle { fill: lime } a { fill: red } }"
        imported = read(
            svg(f"<style>a:hover, [x], b + c, > a {{ fill: red }} {dark}</style><circle r='9' fill='red'/>")
        )
        assert imported.remarks[0].place == "(5)"
        assert imported.scene.bodies[0].color == "#ff0000"

    @pytest.mark.parametrize("text", ["a", "@", "@a{", "@a{x{}", "a{", "/*", "@a ", "g g{fill:red}", "a,"])
    def test_no_sheet_takes_longer_than_it_is_long(self, text: str) -> None:
        started = time.process_time()
        Sheet(text * 10_000)
        assert time.process_time() - started < 5.0  # it was minutes

    def test_what_is_not_seen_is_listed(self, read: Read) -> None:
        imported = read(svg(
            '<rect width="9" height="9" display="none"/><g visibility="hidden"><circle r="9"/></g>'
            '<rect width="9" height="9" fill="none"/><text>hi</text><image/><rect width="320" height="320"/>'
        ))  # fmt: skip
        assert [remark.text for remark in imported.remarks][:-1] == [
            "what is hidden is left out", "what is hidden is left out", "what is neither filled nor drawn is left out",
            "elements of the kind text are left out", "elements of the kind image are left out",
            "a background that fills the drawing is left out",
        ]  # fmt: skip
        assert imported.remarks[3].place == "line 1 <text>"
        assert imported.scene.bodies == ()

    def test_what_is_clear_is_hidden_and_what_is_clipped_is_told(self, read: Read) -> None:
        imported = read(svg(
            '<rect id="a" width="9" height="9" opacity="0"/><rect id="b" width="9" height="9" fill-opacity="0.0"/>'
            '<rect id="c" width="9" height="9" clip-path="url(#x)"><animate/></rect>'
            '<g visibility="hidden"><circle id="d" r="9" visibility="visible"/></g>'
        ))  # fmt: skip
        assert texts(imported) == [
            "what is hidden is left out", "what is neither filled nor drawn is left out",
            "clip paths and masks are left out", "animations are left out",
        ]  # fmt: skip
        assert [body.id for body in imported.scene.bodies] == ["c", "d"]

    def test_a_prefix_may_mean_svg(self, read: Read) -> None:
        spaced = (
            '<ns0:svg xmlns:ns0="http://www.w3.org/2000/svg" width="320" height="320"><ns0:circle r="9"/></ns0:svg>'
        )
        assert len(read(spaced).scene.bodies) == 1


class TestKinds:
    def test_words_say_what_moves(self, read: Read) -> None:
        drawn = bodies(
            read,
            '<g class="static"><rect width="9" height="9"/><rect class="dynamic" width="9" height="9"/></g>'
            '<rect id="kinematic-lift" width="9" height="9"/><circle class="sensor" r="9"/>',
        )
        assert [body.type for body in drawn] == ["static", "dynamic", "kinematic", "static"]
        assert drawn[3].shapes[0].sensor

    def test_a_group_of_the_class_body_is_one(self, read: Read) -> None:
        (body,) = bodies(read, '<g class="body" id="bell"><circle r="16"/><circle cx="64" r="16"/></g>')
        assert (body.id, len(body.shapes), body.position) == ("bell", 2, (1, 10))


class TestHarm:
    def test_entities_that_grow_are_refused(self, read: Read) -> None:
        bomb = "".join(f'<!ENTITY e{k} "{f"&e{k - 1};" * 10}">' for k in range(1, 9))
        text = svg("<text>&e8;</text>", before=f'<!DOCTYPE svg [<!ENTITY e0 "lol">{bomb}]>')
        with pytest.raises(SceneError, match="the entity e1 is refused"):
            read(text)

    def test_nothing_outside_of_the_file_is_read(self, read: Read) -> None:
        text = svg("<text>&x;</text>", before='<!DOCTYPE svg [<!ENTITY x SYSTEM "/etc/passwd">]>')
        with pytest.raises(SceneError, match="what lies outside of the file is not read"):
            read(text)

    def test_short_entities_of_drawing_programs_are_taken(self, read: Read) -> None:
        text = svg('<rect width="9" height="9" fill="&c;"/>', before='<!DOCTYPE svg [<!ENTITY c "#ff0000">]>')
        assert read(text).scene.bodies[0].color == "#ff0000"

    def test_uses_of_uses_end(self, read: Read, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(reader, "MOST_ELEMENTS", 1000)
        ladder = "".join(f'<g id="g{k}">{f"<use href={chr(34)}#g{k - 1}{chr(34)}/>" * 10}</g>' for k in range(1, 9))
        with pytest.raises(SceneError, match="it draws more than 1000 elements"):
            read(svg(f'<defs><g id="g0"/>{ladder}</defs><use href="#g8"/>'))
        assert texts(read(svg('<g id="a"><use href="#a"/></g>')))[0] == "a use of what is not in the file is left out"

    def test_what_is_too_long_is_left_out(self, read: Read) -> None:
        imported = read(svg(f'<path d="M0 0{"h1" * 600_000}"/><rect transform="{"scale(1) " * 600}"/>'))
        assert texts(imported)[:2] == [
            "a path of more than 1000000 characters is left out", "what has a transform that cannot be read is left out"
        ]  # fmt: skip

    @pytest.mark.parametrize("scale", ["1e200", "1e308", "1e-200", "0"])
    def test_scales_without_measure_are_told(self, read: Read, scale: str) -> None:
        path = '<path d="M0 0c9 9 9 0 1 1z"/><path d="M0 0A3 4 5 1 0 9 9z"/>'
        content = f'<g transform="scale({scale})">{path}<circle r="9"/><rect width="9" height="3"/></g>'
        imported = None
        with contextlib.suppress(SceneError):
            imported = read(svg(content))
        assert imported is None or imported.remarks

    def test_deep_nesting_is_refused(self, read: Read) -> None:
        with pytest.raises(SceneError, match="nested deeper than 200 levels"):
            read(svg("<g>" * 300 + "</g>" * 300))

    def test_bad_xml_has_line_and_column(self, read: Read) -> None:
        with pytest.raises(SceneError, match=r"file:2:9: mismatched tag"):
            read(svg("<g>\n<rect></g></rect>"))

    def test_layers_are_of_maps_alone(self, read: Read) -> None:
        with pytest.raises(SceneError, match="layers can be made solid in a map of Tiled alone"):
            read(svg("<circle r='9'/>"), solid=["sea"])

    def test_other_xml_is_told(self, read: Read) -> None:
        with pytest.raises(SceneError, match="in no format that can be imported"):
            read("<html/>")

    def test_a_path_with_a_mistake_is_drawn_up_to_it(self, read: Read) -> None:
        imported = read(svg('<path d="M0 0h32v32z q"/>'))
        assert len(imported.scene.bodies) == 1
        assert imported.remarks[0].text == "a path is drawn up to a mistake in its data"
