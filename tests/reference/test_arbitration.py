"""Who is right: the narrow phase against exact arithmetic, and lies that must be found out."""

from __future__ import annotations

from random import Random

import pytest
from hypothesis import assume, given

from sandbox.reference.answer import Answer
from sandbox.reference.arbitration import arbitrate, faults_of, our_answer, size_and_reach
from sandbox.reference.ask_pymunk import ask_pair
from sandbox.reference.exact_referee import judge
from sandbox.reference.pair import Core, Pair
from sandbox.reference.tolerance import touch_tolerance
from tests.examples import examples
from tests.geometry.shape_families import FAMILIES
from tests.reference.pairs import any_pairs, at, between, box, circle, random_pairs, tied_pairs


@examples(400)
@given(any_pairs)
def test_the_narrow_phase_is_right(pair: Pair) -> None:
    assert faults_of(pair) == []


@examples(300)
@given(random_pairs | tied_pairs)
def test_pymunk_is_right_or_trapped(pair: Pair) -> None:
    """Whatever pymunk gets wrong has a name: a new kind of error, or a wrong referee, would show here."""
    truth, answer = judge(pair), ask_pair(pair)
    assume(abs(truth.separation) > touch_tolerance(*size_and_reach(pair)))
    ruling = arbitrate(pair, our_answer(pair), Answer.theirs(answer))
    assert ruling.faults == ()
    assert not ruling.their_faults or ruling.trap is not None
    assert ruling.their_faults or (answer is not None) == truth.overlap


@pytest.mark.parametrize("numbers", [range(50), pytest.param(range(50, 150), marks=pytest.mark.slow)], ids=str)
@pytest.mark.parametrize("family", FAMILIES)
def test_of_every_family_pymunk_is_right_or_trapped(family: str, numbers: range) -> None:
    for k in numbers:
        pair = between(*FAMILIES[family](Random(f"compare/{family}/{k}")))
        ruling = arbitrate(pair, our_answer(pair), Answer.theirs(ask_pair(pair)))
        assert ruling.faults == (), pair.source()
        assert not ruling.their_faults or ruling.trap is not None, pair.source()


def test_lies_are_found_out() -> None:
    pair = at(box(2, 2), box(2, 2), (1.5, 0.25))
    assert faults_of(pair, Answer.ours(-0.5, (1.0, 0.0))) == []
    assert faults_of(pair, Answer(False))
    assert faults_of(pair, Answer.ours(0.5, (1.0, 0.0)))
    assert faults_of(pair, Answer.ours(-0.5 - 1e-7, (1.0, 0.0)))
    assert faults_of(pair, Answer.ours(-0.5, (0.0, 1.0)))
    assert faults_of(pair, Answer.ours(-0.5, (-1.0, 0.0)))
    apart = at(circle(1), circle(1), (3.0, 0.0))
    assert faults_of(apart, Answer.ours(-0.1, (1.0, 0.0)))


def test_axes_of_equal_depth_are_all_right() -> None:
    pair = at(box(2, 2), box(2, 2), (1.0, 1.0))
    for normal in ((1.0, 0.0), (0.0, 1.0)):
        assert faults_of(pair, Answer.ours(-1.0, normal)) == []


def test_where_shapes_touch_either_verdict_is_right() -> None:
    pair = at(box(2, 2), box(2, 2), (2.0, 0.5))
    contact = Answer.theirs((0.0, (0.0, 0.0)))
    for answer in (Answer(False), Answer.ours(0.0, (1.0, 0.0)), Answer.ours(-1e-13, (1.0, 0.0)), contact):
        assert faults_of(pair, answer) == []
    assert faults_of(pair, Answer.ours(-1e-3, (1.0, 0.0)))


def test_a_gap_is_no_larger_than_the_distance() -> None:
    corners = at(box(2, 2), box(2, 2), (5.0, 6.0))
    assert faults_of(corners, Answer.ours(4.0, (0.0, 1.0))) == []
    assert faults_of(corners, Answer.ours(5.001, (0.6, 0.8)))


def test_a_contact_of_depth_zero_is_a_verdict() -> None:
    contact = Answer.theirs((-0.0, (0.0, 0.0)))
    assert faults_of(at(circle(1), circle(1), (3.0, 0.0)), contact)
    assert faults_of(at(box(1, 1), box(1, 1), (0.0, 0.0)), contact)


def test_source_is_the_same_pair_to_the_bit() -> None:
    pair = at(Core(((0.1, 0.2),), 1 / 3), box(1 / 7, 5e-324), (1e300, -0.1))
    assert eval(pair.source(), {"Core": Core, "Pair": Pair}) == pair
