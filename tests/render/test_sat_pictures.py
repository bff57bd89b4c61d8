"""The separating-axis pictures: what is drawn is where the numbers say."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest

import sandbox
from sandbox.render.number_text import short
from sandbox.render.sat_figure import FIGURES
from sandbox.render.sat_page import Member, SatFigure
from sandbox.render.sat_plane import Plane
from sandbox.render.sat_rails import ROW
from sandbox.render.svg import Svg
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


def test_the_same_table_gives_the_same_file():
    table = SatFigure(sandbox.sat_table(*TWO), NAMES)
    assert FIGURES["whole"](table).to_text() == FIGURES["whole"](table).to_text()
