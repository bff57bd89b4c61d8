"""Which rings lie in which: found among those nearby, as if all were looked at."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.formats.numbers import Vec
from sandbox.formats.svg import rings as module
from tests.examples import examples

PLACES = st.floats(-1e6, 1e6) | st.integers(-8, 8).map(float)
EXTENTS = st.floats(0.0, 1e6) | st.integers(0, 16).map(float) | st.just(1e-12)


@examples(200)
@given(st.lists(st.tuples(PLACES, PLACES, EXTENTS, EXTENTS), max_size=12), st.lists(st.tuples(PLACES, PLACES)))
def test_no_box_around_a_point_is_missed(given_boxes: list[tuple[float, ...]], points: list[Vec]) -> None:
    boxes = [(x, y, x + width, y + height) for x, y, width, height in given_boxes]
    asked = [*points, *((box[2], box[3]) for box in boxes), *((box[0], box[1]) for box in boxes)]
    found = module._boxes_around(asked, boxes)
    assert found == [[k for k, box in enumerate(boxes) if module._covers(box, point)] for point in asked]


@pytest.mark.parametrize(("width", "height"), [(2.0, 2.0), (5000.0, 0.01), (0.01, 5000.0)])
def test_many_rings_side_by_side_are_not_held_against_all(
    monkeypatch: pytest.MonkeyPatch, width: float, height: float
) -> None:
    asked, usual = [], module._covers

    def noted(box: module.Box, point: Vec) -> bool:
        asked.append(box)
        return usual(box, point)

    monkeypatch.setattr(module, "_covers", noted)
    side = 20
    corners = [(k % side * width * 1.5, k // side * height * 1.5) for k in range(side * side)]
    rings = [[(x, y), (x + width, y), (x + width, y + height), (x, y + height)] for x, y in corners]
    assert len(module.outlines(rings, even_odd=True)) == len(rings)
    assert len(asked) < 9 * len(rings)
