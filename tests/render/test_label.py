from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from sandbox.render.label import CELL, Label, place_labels
from tests.examples import examples

SIZE = (300, 200)
places = st.tuples(st.floats(-20, 320), st.floats(-20, 220))
labels = st.builds(
    Label, st.text("abc0", min_size=1, max_size=8), places, st.just((1.0, 1.0, 1.0)), st.floats(9, 20),
    st.sampled_from(["left", "middle", "right"]), st.sampled_from([0.0, 6.0]), st.floats(0, 1),
)  # fmt: skip


@examples(200)
@given(st.lists(labels, max_size=30))
def test_labels_overlap_neither_each_other_nor_what_is_taken_nor_the_edge(given_labels: list[Label]) -> None:
    taken = (100.0, 80.0, 180.0, 120.0)
    boxes = [label.box for label in place_labels(given_labels, SIZE, [taken])]
    for k, (left, top, right, bottom) in enumerate(boxes):
        assert 0.0 <= left <= right <= SIZE[0]
        assert 0.0 <= top <= bottom <= SIZE[1]
        for other in [taken, *boxes[:k]]:
            assert right <= other[0] or left >= other[2] or bottom <= other[1] or top >= other[3]


@examples(100)
@given(labels)
def test_a_label_alone_is_placed_if_it_fits(label: Label) -> None:
    left, top, right, bottom = label.box
    fits = left >= 0 and top >= 0 and right <= SIZE[0] and bottom <= SIZE[1]
    if label.gap == 0.0:
        assert place_labels([label], SIZE) == ((label,) if fits else ())


def test_the_higher_rank_comes_first_and_the_other_finds_room_beside_it() -> None:
    low, high = (
        Label(text, (150.0, 100.0), (1.0, 1.0, 1.0), gap=6.0, rank=rank) for text, rank in (("low", 0), ("high", 1))
    )
    assert [label.text for label in place_labels([low, high], SIZE)] == ["high"]
    away = Label("low", (150.0, 100.0 + 2 * CELL), (1.0, 1.0, 1.0), gap=6.0)
    first, second = place_labels([away, high], SIZE)
    assert (first.text, first.anchor, second.text) == ("high", "left", "low")
    assert second.anchor != "left"


def test_no_more_than_so_many() -> None:
    many = [Label("x", (40.0 * (k % 7) + 10, 30.0 * (k // 7) + 15), (1.0, 1.0, 1.0)) for k in range(35)]
    assert len(place_labels(many, SIZE)) == 35
    assert len(place_labels(many, SIZE, most=9)) == 9
