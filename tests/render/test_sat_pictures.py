"""The separating-axis pictures: what is drawn is where the numbers say."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest
from hypothesis import given

import sandbox
from sandbox.geometry.decompose import decompose
from sandbox.render.number_text import short
from sandbox.render.sat_figure import FIGURES
from sandbox.render.sat_page import Member, SatFigure, Whole
from sandbox.render.sat_plane import Plane
from sandbox.render.sat_rails import ROW
from sandbox.render.sat_tilt import strip_of
from sandbox.render.svg import Svg
from tests.examples import examples
from tests.geometry.convex_cases import numbers, polygons
from tests.geometry.tutorial_cases import SQUARE_ONE, SQUARE_TWO, TRIANGLE_ONE, TRIANGLE_TWO

NAMES = ("square", "triangle")
ONE = sandbox.Polygon(SQUARE_ONE), sandbox.Polygon(TRIANGLE_ONE)
TWO = sandbox.Polygon(SQUARE_TWO), sandbox.Polygon(TRIANGLE_TWO)


def draw(figure: str, pair, names=NAMES, **more) -> ElementTree.Element:
    svg = FIGURES[figure](SatFigure(sandbox.sat_table(*pair), names, **more))
    return ElementTree.fromstring(re.sub(r' xmlns="[^"]+"', "", svg.to_text()))


def of_class(root: ElementTree.Element, tag: str, kind: str) -> list[ElementTree.Element]:
    return [element for element in root.iter(tag) if element.get("class") == kind]


def words(root: ElementTree.Element) -> list[str]:
    return ["".join(element.itertext()) for element in root.iter("text")]


def spans(root: ElementTree.Element, kind: str) -> list[tuple[float, float, float]]:
    """(left, right, height) of the level bars."""
    return [tuple(float(bar.get(name)) for name in ("x1", "x2", "y1")) for bar in of_class(root, "line", f"{kind} bar")]


def test_each_row_has_two_bars_to_one_scale_of_metres():
    root = draw("whole", TWO)
    a, b = spans(root, "a"), spans(root, "b")
    rows = sandbox.sat_table(*TWO).rows
    assert len(a) == len(b) == len(rows) == 7
    scale = (a[0][1] - a[0][0]) / ((rows[0].amax - rows[0].amin) / rows[0].length)
    for row, mine, other in zip(rows, a, b, strict=True):
        assert mine[1] - mine[0] == pytest.approx((row.amax - row.amin) / row.length * scale, abs=0.02)
        assert other[1] - other[0] == pytest.approx((row.bmax - row.bmin) / row.length * scale, abs=0.02)
        assert other[0] - mine[0] == pytest.approx((row.bmin - row.amin) / row.length * scale, abs=0.02)
    assert scale > 10
    assert a[1][2] - a[0][2] == pytest.approx(ROW)


def test_the_four_numbers_of_each_row_are_written_beside_it():
    shown = words(draw("whole", ONE))
    for text in ("42", "91", "70", "105", "-70", "-21", "-126", "-77", "gap 1 m", "the test stops here"):
        assert text in shown
    assert shown.count("not needed") == 5


def test_gap_and_overlap_are_marked_between_the_intervals():
    root = draw("whole", ONE)
    (gap,), (overlap,) = of_class(root, "rect", "gap band"), of_class(root, "rect", "out band")
    a, b = spans(root, "a"), spans(root, "b")
    assert (float(gap.get("x")), float(gap.get("width"))) == pytest.approx((b[1][1], a[1][0] - b[1][1]), abs=0.02)
    assert (float(overlap.get("x")), float(overlap.get("width"))) == pytest.approx(
        (b[0][0], a[0][1] - b[0][0]), abs=0.02
    )


def test_the_way_out_runs_from_the_near_end_of_b_to_the_end_of_a():
    root = draw("whole", (sandbox.Box(8, 6), sandbox.Box(1, 1, at=(2, 0.5))))
    a, b = spans(root, "a")[1], spans(root, "b")[1]
    shaft = next(line for line in of_class(root, "line", "mtv axis") if a[2] < float(line.get("y1")) < b[2])
    head = next(p for p in of_class(root, "polygon", "mtv axis head")).get("points").split()[1].split(",")
    assert float(shaft.get("x1")) == pytest.approx(b[1], abs=0.02)
    assert float(head[0]) == pytest.approx(a[0], abs=0.02)


def test_the_ghost_lies_one_translation_vector_away():
    root = draw("mtv", TWO)
    (shape,), (ghost,) = of_class(root, "path", "b shape"), of_class(root, "path", "b ghost")
    before, after = ([float(n) for n in re.findall(r"-?[\d.]+", path.get("d"))] for path in (shape, ghost))
    shift = [q - p for p, q in zip(before, after, strict=True)]
    assert shift[0::2] == pytest.approx([0] * len(shift[0::2]), abs=0.02)
    scale = -shift[1]
    assert shift[1::2] == pytest.approx([-scale] * len(shift[1::2]), abs=0.02)
    square = [float(n) for n in re.findall(r"-?[\d.]+", of_class(root, "path", "a shape")[0].get("d"))]
    assert max(square[0::2]) - min(square[0::2]) == pytest.approx(7 * scale, abs=0.1)


def test_separated_shapes_get_a_line_between_them():
    root = draw("mtv", ONE)
    (line,) = of_class(root, "line", "gap line")
    assert line.get("y1") == line.get("y2")
    lowest = max(float(n) for n in re.findall(r"-?[\d.]+", of_class(root, "path", "b shape")[0].get("d"))[1::2])
    highest = min(float(n) for n in re.findall(r"-?[\d.]+", of_class(root, "path", "a shape")[0].get("d"))[1::2])
    assert lowest < float(line.get("y1")) < highest


def test_a_plane_shows_what_it_was_asked_to_hold():
    svg = Svg(300, 200, "t", "")
    plane = Plane(svg, (10, 20), (280, 160), [(0, 0), (4, 2)], margin=20)
    assert plane.pixel((2, 1)) == (150, 100)
    assert plane.scale == pytest.approx(60)
    assert plane.shows((4, 2))
    assert not plane.shows((9, 1))


def test_a_small_shape_on_a_huge_one_is_seen_large():
    root = draw("clipping", (sandbox.Box(400, 1, at=(0, -0.5)), sandbox.Box(1, 1, at=(50, 0.45))))
    path = of_class(root, "path", "b shape")[0].get("d")
    xs = [float(n) for n in re.findall(r"-?[\d.]+", path)][0::2]
    assert max(xs) - min(xs) > 80
    assert len(of_class(root, "circle", "mtv dot")) == 2


def test_long_names_are_cut_and_markup_is_harmless():
    name = "a<b>&" + "x" * 40
    shown = words(draw("whole", ONE, names=(name, "t")))
    assert f"edge 1 of {name[:10]}…" in shown
    assert any(text.startswith(name) for text in shown)


@pytest.mark.parametrize(
    ("value", "text"),
    [(91.0, "91"), (-0.0, "0"), (-0.352644, "-0.3526"), (1338.22, "1338"), (-192532.4, "-192532"), (3e7, "3e+07")],
)
def test_numbers_beside_a_rail_are_short(value: float, text: str):
    assert short(value) == text


def test_many_axes_make_a_long_list_but_not_an_endless_one():
    disc = [(x, x * x) for x in range(-32, 32)]
    shown = words(draw("whole", (sandbox.Polygon(disc), sandbox.Box(1, 1, at=(-100, 0)))))
    assert any(re.fullmatch(r"and \d+ more", text) for text in shown)
    assert shown.count("not needed") <= 8


def test_the_scene_figure_counts_pairs_of_boxes():
    boxes = [sandbox.Box(1, 1, at=(2 * k, 0)) for k in range(4)] + [sandbox.Box(20, 1, at=(0, -0.9))]
    scene_shapes = tuple(Member(box, k, k < 4) for k, box in enumerate(boxes))
    root = draw("scene", (boxes[4], boxes[0]), scene_shapes=scene_shapes)
    assert any("5 shapes make 10 pairs; only the 4 whose boxes overlap are tested" in text for text in words(root))
    assert len(of_class(root, "line", "gap edge")) == 4


def ends(line: ElementTree.Element) -> tuple[float, float, float, float]:
    return tuple(float(line.get(name)) for name in ("x1", "y1", "x2", "y2"))


def test_every_vertex_has_its_dot_product_at_its_foot_on_the_axis():
    root = draw("dot", TWO, row=sandbox.sat_table(*TWO).rows[3])
    shown = words(root)
    for text in ("35", "5 m", "21", "3 m", "-7", "-1 m"):
        assert text in shown
    (start,) = of_class(root, "circle", "a dot")
    ahead, behind = of_class(root, "circle", "gap dot"), of_class(root, "circle", "out dot")
    assert {dot.get("cx") for dot in (*ahead, *behind)} == {start.get("cx")}, "the axis is upright"
    heights = [float(start.get("cy")) - float(dot.get("cy")) for dot in (*ahead, *behind)]
    assert heights == pytest.approx([heights[0] * k for k in (1, 5 / 3, -1 / 3)], abs=0.02)


def test_the_strip_is_turned_onto_the_nearest_edge():
    corners = sandbox.Polygon(((4, 4), (4, 0), (0, 0), (0, 4))), sandbox.Polygon(((6, 5), (7, 9), (9, 6)))
    root = draw("tilt", corners)
    assert "nearest points 2.236 m apart; turned to edge 1 of square, 2 m are left" in words(root)
    left, right = (ends(line) for line in of_class(root, "line", "gap line"))
    corner, tip = (float(of_class(root, "circle", kind)[0].get("cx")) for kind in ("a dot", "b dot"))
    assert (left[0], left[2], right[0], right[2]) == (corner, corner, tip, tip), "both borders are upright"


def test_the_strip_needs_no_turn_where_an_edge_is_nearest():
    root = draw("tilt", ONE)
    assert "nearest points 1.671 m apart, straight across edge 2 of triangle" in words(root)
    assert of_class(root, "path", "mtv axis") == []


def test_beside_a_disc_nothing_may_be_left_of_the_strip():
    block, disc = sandbox.Polygon(((0, 0), (4, 0), (4, 3), (0, 3))), sandbox.Circle((4.7, 3.8), 1)
    root = draw("tilt", (block, disc), ("block", "disc"))
    assert "nearest points 0.06301 m apart; turned to edge 3 of block, nothing is left" in words(root)
    assert "nearest points 4.748 m apart, and no edge to turn to" in words(
        draw("tilt", (disc, sandbox.Circle((9, 9), 1)))
    )
    assert of_class(draw("tilt", TWO), "line", "mtv line") == [], "where two overlap there is no strip"


@given(polygons(), polygons(), numbers, numbers)
@examples(200)
def test_the_turned_strip_is_the_gap_of_an_axis(a, b, x, y):
    """What the lesson argues: wherever two polygons are apart, the axis of an edge has a gap."""
    pair = sandbox.Polygon(a), sandbox.Polygon(tuple((px + x, py + y) for px, py in b))
    table = sandbox.sat_table(*pair, all_axes=True)
    strip = strip_of(SatFigure(table, NAMES))
    if strip is None or strip.before < 1e-6:
        return
    gaps = {f"edge {row.edge} of {NAMES[row.owner == 'b']}": row.separation for row in table.rows}
    assert 0.0 < strip.after <= strip.before + 1e-12
    assert gaps[strip.edge] == pytest.approx(strip.after, rel=1e-6, abs=1e-9)


CUP = ((2, 0), (8, 0), (10, 7), (8, 7), (7, 2), (3, 2), (2, 7), (0, 7))


def test_parts_show_the_gaps_that_the_rubber_band_hides():
    parts = tuple(sandbox.Polygon(part.vertices) for part in decompose(CUP).parts)
    stone = sandbox.Polygon(((4, 6), (6, 5), (5, 3)))
    wholes = Whole(parts, decompose(CUP).rings), Whole((stone,))
    root = draw("parts", (parts[0], stone), ("cup", "stone"), wholes=wholes)
    assert "no straight line goes between the two, but each of the 3 pairs of convex parts has a gap" in words(root)
    assert len(of_class(root, "path", "a shape")) == 1 + 3
    assert len(of_class(root, "line", "gap line")) == 3
    (mouth,) = of_class(root, "line", "out line")
    assert mouth.get("y1") == mouth.get("y2"), "level, from rim to rim"


def test_parts_of_shapes_that_overlap_are_counted():
    assert "pairs of convex parts that overlap: 1 of 1" in words(draw("parts", TWO))
    assert "one gap is enough" in words(draw("parts", ONE))


def test_the_same_table_gives_the_same_file():
    table = SatFigure(sandbox.sat_table(*TWO), NAMES)
    assert FIGURES["whole"](table).to_text() == FIGURES["whole"](table).to_text()
