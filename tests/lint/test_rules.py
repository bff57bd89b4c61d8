"""Every rule finds what it is for, keeps still at what is near it, and finds nothing in the shipped scenes."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given

from sandbox.lint.registry import RULES
from sandbox.lint.run import lint
from sandbox.resources import scenes_dir
from sandbox.scene import loads_scene
from tests.examples import examples
from tests.lint.cases import CASES, Case, scene
from tests.scene.scene_strategies import scenes
from tests.shipped import FILES, shipped

EACH = [pytest.param(name, case, id=f"{name}-{k}") for name, cases in CASES.items() for k, case in enumerate(cases)]


@pytest.mark.parametrize(("name", "case"), EACH)
def test_it_finds_what_is_silly_and_nothing_beside_it(name: str, case: Case) -> None:
    rules = [RULES[name]]
    (found,) = lint(loads_scene(json.dumps(case.silly, indent=1)), rules)
    assert found.rule == name
    assert case.words in f"{found.problem.message}: {found.problem.hint}"
    assert found.problem.line > 0
    assert lint(loads_scene(json.dumps(case.fine)), rules) == []


def test_every_rule_has_its_cases() -> None:
    assert CASES.keys() == RULES.keys()


def test_the_guide_lists_the_rules() -> None:
    guide = (scenes_dir().parent / "sandbox" / "cli" / "README.md").read_text(encoding="utf-8")
    rows = [f"| `{name}` | {rule.finds} |\n" for name, rule in RULES.items()]
    assert "".join(rows) in guide


def test_shipped_scenes_are_not_silly() -> None:
    found = {name: [f"{each.rule}: {each.problem.message}" for each in lint(shipped(name))] for name in FILES}
    assert {name: said for name, said in found.items() if said} == {}


def test_a_scene_keeps_a_rule_away_by_its_name() -> None:
    silly = scene(expect=[], materials={"wood": {}})
    assert [found.rule for found in lint(loads_scene(json.dumps(silly)))] == ["no-expect", "unused"]
    spared = loads_scene(json.dumps({**silly, "lint": {"ignore": ["unused", "no-expct"]}}))
    said = [(found.rule, found.problem.message) for found in lint(spared)]
    assert said[0][0] == "no-expect"
    assert said[1] == ("unknown-rule", "there is no rule 'no-expct'; did you mean \"no-expect\"?")


def test_findings_are_in_the_order_of_the_file_and_ten_of_a_rule() -> None:
    text = json.dumps(scene(prefabs={f"p{k}": {"shapes": [{"circle": 1}]} for k in range(15)}, expect=[]), indent=1)
    found = lint(loads_scene(text))
    lines = [each.problem.line for each in found]
    assert lines == sorted(lines)
    assert len(found) == 12
    assert found[-1].problem.message == "and 5 more like this"


@given(scenes())
@examples(8)
def test_any_scene_can_be_looked_at(data: dict[str, Any]) -> None:
    for found in lint(loads_scene(json.dumps(data))):
        assert found.rule in RULES
        assert found.problem.line > 0
