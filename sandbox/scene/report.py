"""From findings to the error a user sees: in file order, with line, column and excerpt."""

from __future__ import annotations

from sandbox.errors import Problem, SceneError
from sandbox.scene.excerpt import excerpt, line_column
from sandbox.scene.finding import Finding
from sandbox.scene.limits import MAX_PROBLEMS
from sandbox.scene.locate import Span, locate


def scene_error(source: str, findings: list[Finding], text: str | None) -> SceneError:
    """The error for `findings`; `text` is the file's, or None for a scene built in Python."""
    if text is None:
        problems = [finding.problem() for finding in findings]
    else:
        problems = _placed(findings, text)
    if len(problems) > MAX_PROBLEMS:
        more = f"and at least {len(problems) - MAX_PROBLEMS} more mistakes"
        problems = [*problems[:MAX_PROBLEMS], Problem(more)]
    return SceneError(source, problems)


def syntax_error(source: str, text: str, span: Span, message: str, hint: str = "") -> SceneError:
    """The error for text that is no JSON, at `span`."""
    return SceneError(source, [_problem(Finding((), message, hint), text, span)])


def _placed(findings: list[Finding], text: str) -> list[Problem]:
    found = locate(text, {finding.path for finding in findings})
    places = [found[f.path].key_span if f.on_key else found[f.path].value_span for f in findings]
    pairs = sorted(zip(places, findings, strict=True), key=lambda pair: pair[0][0])
    shown, rest = pairs[:MAX_PROBLEMS], pairs[MAX_PROBLEMS:]
    return [_problem(finding, text, span) for span, finding in shown] + [f.problem() for _, f in rest]


def _problem(finding: Finding, text: str, span: Span) -> Problem:
    return finding.problem(*line_column(text, span[0]), excerpt(text, *span))
