"""Random numbers in expressions: evenly spread, unlike their neighbours, and the same ones everywhere."""

from __future__ import annotations

import numpy as np
import pytest

from sandbox.scene import loads_scene
from sandbox.scene.authoring.expression import parsed
from tests.scene.scene_helpers import one

KNOWN = [0.8833108082136426, 0.5345422839126993, 0.002598817123781516, 0.6634604186012825, 0.9692977027004345]


def thrown(*numbers: float) -> list[float]:
    return [parsed("=random(x)").value({"x": float(number)}) for number in numbers]


def test_they_are_the_same_on_every_machine() -> None:
    assert thrown(0, 1, 2, -1, 0.1) == KNOWN
    assert thrown(0.0) == thrown(-0.0)


@pytest.mark.parametrize("step", [1.0, 1000.0, 0.25])
def test_they_are_evenly_spread_and_neighbours_have_nothing_in_common(step: float) -> None:
    many = np.array(thrown(*(step * k for k in range(1, 4001))))
    assert ((many >= 0.0) & (many < 1.0)).all()
    counts = np.histogram(many, 20, (0.0, 1.0))[0]
    assert ((counts - 200.0) ** 2 / 200.0).sum() < 43.8  # chi squared of 19 degrees of freedom: one in a thousand
    assert abs(np.corrcoef(many[1:], many[:-1])[0, 1]) < 0.05
    assert len(set(many.tolist())) == len(many)


def test_copies_differ_as_the_seed_says_and_a_wrong_call_is_told() -> None:
    text = """{"vars": {"seed": %s}, "prefabs": {"dot": {"shapes": [{"circle": 0.1}]}}, "generate": [
        {"id": "d", "place": "dot", "count": 20, "at": ["=10*random(i+1000*seed)", "=10*random(-i-1000*seed)"]}]}"""
    places = [[body.position for body in loads_scene(text % seed).flatten().bodies] for seed in (1, 2, 1)]
    assert places[0] == places[2] != places[1]
    assert len(set(places[0])) == 20
    assert one(text % '"=random()"') == '1:28: a number is due before ")"'
