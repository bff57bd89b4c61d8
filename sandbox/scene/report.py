"""From findings to the error a user sees: in file order, with line, column and excerpt."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace

from sandbox.errors import Problem, SceneError
from sandbox.scene.excerpt import excerpt, line_column
from sandbox.scene.finding import Finding
from sandbox.scene.limits import MAX_ALIKE, MAX_PROBLEMS
from sandbox.scene.locate import Place, Span, locate

_VARYING = re.compile(r'"[^"]*"|[0-9.]+')
"""What differs among mistakes of one sort: names and numbers."""


def scene_error(source: str, findings: list[Finding], text: str | None) -> SceneError:
    """The error for `findings`; `text` is the file's, or None for a scene built in Python."""
    if text is None:
        return SceneError(source, told(findings))
    found = locate(text, {finding.path for finding in findings})
    places = [_span(finding, found[finding.path], text) for finding in findings]
    pairs = sorted(zip(places, findings, strict=True), key=lambda pair: pair[0][0])
    spans = {id(finding): span for span, finding in pairs}
    return SceneError(source, told([f for _, f in pairs], lambda f: _problem(f, text, spans[id(f)])))


def sort_of(finding: Finding) -> str:
    """The message without names and numbers: equal for mistakes of one sort."""
    return _VARYING.sub("", finding.message)


def told(findings: Iterable[Finding], problem: Callable[[Finding], Problem] = Finding.problem) -> list[Problem]:
    """What an error says of `findings`: the first of each sort, not more than a person reads, and how many more."""
    shown: list[Problem] = []
    alike: Counter[str] = Counter()
    first: dict[str, str] = {}
    for finding, is_repeated in _once(list(findings)):
        sort = sort_of(finding)
        alike[sort] += 1
        if alike[sort] <= MAX_ALIKE and len(shown) < MAX_PROBLEMS:
            shown.append(_with_places(problem(finding), is_repeated))
            first.setdefault(sort, shown[-1].message.rstrip(":"))
    left = {sort: count - MAX_ALIKE for sort, count in alike.items() if sort in first and count > MAX_ALIKE}
    shown += [Problem(f"and at least {count} more like this: {first[sort]}") for sort, count in left.items()]
    others = alike.total() - sum(left.values()) - (len(shown) - len(left))
    return [*shown, Problem(f"and at least {others} more mistakes")] if others else shown


def _once(findings: Sequence[Finding]) -> Iterator[tuple[Finding, bool]]:
    """The findings, and whether they are told of other places too: a wrong name is one mistake wherever it is."""
    places = Counter((finding.message, finding.hint) for finding in findings if finding.lacks or finding.once)
    for finding in findings:
        is_name = finding.lacks or finding.once
        count = places.pop((finding.message, finding.hint), 0) if is_name else 1
        if count:
            yield finding, count > 1


def _with_places(problem: Problem, is_repeated: bool) -> Problem:
    return replace(problem, message=f"{problem.message}, here and elsewhere") if is_repeated else problem


def syntax_error(source: str, text: str, span: Span, message: str, hint: str = "") -> SceneError:
    """The error for text that is no JSON, at `span`."""
    return SceneError(source, [_problem(Finding((), message, hint), text, span)])


def _span(finding: Finding, place: Place, text: str) -> Span:
    """Which characters to point at; a part of a text is found as long as nothing before it is escaped."""
    if finding.on_key:
        return place.key_span
    start, end = place.value_span
    if finding.within is None or text[start : start + 1] != '"' or "\\" in text[start:end]:
        return place.value_span
    return start + 1 + finding.within[0], start + 1 + finding.within[1]


def _problem(finding: Finding, text: str, span: Span) -> Problem:
    return finding.problem(*line_column(text, span[0]), excerpt(text, *span))
