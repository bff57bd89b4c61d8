"""From findings to the error a user sees: in file order, with line, column and excerpt."""

from __future__ import annotations

from sandbox.errors import Problem, SceneError
from sandbox.scene.excerpt import excerpt, line_column
from sandbox.scene.finding import Finding
from sandbox.scene.limits import MAX_PROBLEMS
from sandbox.scene.locate import Span, duplicate_keys, locate


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


def repeated_keys(text: str) -> list[tuple[Span, Finding]]:
    """A finding for every key given twice, with its place (a path would lead to the last one only)."""
    return [
        (span, Finding(path, f'"{path[-1]}" is given twice in one object', on_key=True))
        for path, span in duplicate_keys(text)
    ]


def _placed(findings: list[Finding], text: str) -> list[Problem]:
    found = locate(text, {finding.path for finding in findings})
    spans = [
        (found[f.path].key_span if f.on_key else found[f.path].value_span, f) for f in findings
    ] + repeated_keys(text)
    spans.sort(key=lambda pair: pair[0][0])
    return [_problem(finding, text, span) for span, finding in spans[: MAX_PROBLEMS + 1]] + [
        finding.problem() for _, finding in spans[MAX_PROBLEMS + 1 :]
    ]


def _problem(finding: Finding, text: str, span: Span) -> Problem:
    return finding.problem(*line_column(text, span[0]), excerpt(text, *span))
