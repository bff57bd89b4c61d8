"""Rules at work on a scene: findings with their places, in the order of the file."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from sandbox.errors import Problem
from sandbox.lint.registry import RULES, unknown_rule
from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject
from sandbox.scene import Scene
from sandbox.scene.excerpt import excerpt, line_column
from sandbox.scene.finding import Finding
from sandbox.scene.limits import MAX_ALIKE
from sandbox.scene.locate import Span, locate

UNKNOWN = "unknown-rule"
"""What a scene is told that ignores a rule which does not exist."""


@dataclass(frozen=True)
class Lint:
    """A finding of a rule, with its place in the file of the scene: what brought it, if it comes from elsewhere."""

    rule: str
    problem: Problem


def lint(scene: Scene, rules: Iterable[Rule] = tuple(RULES.values())) -> list[Lint]:
    """What rules find in a scene, but for those that it asks to be spared. Raises what `World` raises.

    Of one rule the first ten findings are told, and how many more there are.
    """
    subject, spared = Subject(scene), scene.lint.ignore
    found = [
        (UNKNOWN, Finding(("lint", "ignore", number), unknown_rule(name)))
        for number, name in enumerate(spared)
        if name not in RULES
    ]
    for rule in rules:
        if rule.name not in spared:
            found += _shortened(rule.name, list(rule.check(subject)))
    return _placed(scene, found)


def _shortened(rule: str, findings: list[Finding]) -> list[tuple[str, Finding]]:
    more = len(findings) - MAX_ALIKE
    told = [(rule, finding) for finding in findings[:MAX_ALIKE]]
    if more > 0:
        told.append((rule, Finding(findings[MAX_ALIKE].path, f"and {more} more like this")))
    return told


def _placed(scene: Scene, found: list[tuple[str, Finding]]) -> list[Lint]:
    if scene.text is None:
        return [Lint(rule, finding.problem()) for rule, finding in found]
    found = [(rule, replace(finding, path=scene.entry(finding.path))) for rule, finding in found]
    places = locate(scene.text, {finding.path for _, finding in found})
    spans: list[Span] = [
        places[f.path].key_span if f.on_key else places[f.path].value_span for _, f in found
    ]  # fmt: skip
    order = sorted(range(len(found)), key=lambda k: spans[k][0])
    return [Lint(found[k][0], _problem(scene.text, found[k][1], spans[k])) for k in order]


def _problem(text: str, finding: Finding, span: Span) -> Problem:
    return finding.problem(*line_column(text, span[0]), excerpt(text, *span))
