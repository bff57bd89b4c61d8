"""Steps along the scrubber, and the marks on it."""

from __future__ import annotations

from sandbox.window.time_marks import TimeMark, TimeMarks, Track


def test_pixels_and_steps_lead_to_each_other() -> None:
    track = Track(10.0, 600.0, 300)
    assert [track.step(track.x(step)) for step in (0, 1, 150, 300)] == [0, 1, 150, 300]
    assert (track.step(-50.0), track.step(5000.0)) == (0, 300)
    assert Track(0.0, 100.0, 0).step(50.0) == 0


def test_a_mark_draws_the_hand_from_a_few_pixels_away() -> None:
    track = Track(0.0, 100.0, 1000)
    marks = [TimeMark(500, "one"), TimeMark(520, "other"), TimeMark(500, "two"), TimeMark(2000, "beyond")]
    assert [mark.tip for mark in track.near(50.5, marks)] == ["one", "two"]
    assert [mark.tip for mark in track.near(52.5, marks)] == ["other"]
    assert track.near(70.0, marks) == []
    assert track.near(100.0, marks) == []


def test_each_owner_replaces_only_his_own_marks() -> None:
    marks = TimeMarks()
    marks.put("a", [TimeMark(9, "late"), TimeMark(2, "early")])
    marks.put("b", [TimeMark(5, "between")])
    assert [mark.tip for mark in marks.all()] == ["early", "between", "late"]
    marks.put("a", ())
    assert [mark.tip for mark in marks.all()] == ["between"]
