from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from sandbox.window.card_grid import Row, card_rows, move

themes = st.lists(st.integers(1, 9), min_size=1, max_size=8).map(
    lambda counts: [f"theme {i}" for i, count in enumerate(counts) for _ in range(count)]
)


@given(themes, st.integers(1, 5))
def test_rows_hold_every_card_once_in_order_each_theme_under_its_heading(names: list[str], columns: int) -> None:
    rows = card_rows(names, columns)
    assert [card for row in rows for card in row.cards] == list(range(len(names)))
    assert [theme for row in rows for _, theme in row.headings] == list(dict.fromkeys(names))
    for row in rows:
        assert len(row.cards) <= columns
        for column, theme in row.headings:
            assert names[row.cards[column]] == theme
            assert row.cards[column] == names.index(theme)


def test_small_themes_share_a_row_and_what_has_no_theme_has_no_heading() -> None:
    assert card_rows(["a", "b", "b", "c", "c", "c"], 4) == [
        Row((0, 1, 2), ((0, "a"), (1, "b"))), Row((3, 4, 5), ((0, "c"),)),
    ]  # fmt: skip
    assert card_rows([""] * 3, 2) == [Row((0, 1), ()), Row((2,), ())]


@given(themes, st.integers(1, 5), st.data())
def test_moves_stay_among_the_cards(names: list[str], columns: int, data: st.DataObject) -> None:
    rows = card_rows(names, columns)
    card = data.draw(st.integers(0, len(names) - 1))
    right, down = data.draw(st.tuples(st.integers(-200, 200), st.integers(-9, 9)))
    assert 0 <= move(rows, card, right, down) < len(names)
    assert move(rows, card, 1, 0) == min(card + 1, len(names) - 1)


def test_down_keeps_the_column_where_the_next_row_is_long_enough() -> None:
    rows = card_rows(["a"] * 5 + ["b"] * 3, 3)  # 0 1 2 | 3 4 | 5 6 7
    assert move(rows, 1, 0, 1) == 4
    assert move(rows, 2, 0, 1) == 4
    assert move(rows, 4, 0, 1) == 6
    assert move(rows, 6, 0, 1) == 6
    assert move(rows, 6, 0, -2) == 1
