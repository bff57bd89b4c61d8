"""The report of a set of replays: a table of all, and everything that helps with those that did not pass."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TypeAlias

from sandbox._atomic_write import write_text
from sandbox._version import __version__
from sandbox.errors import SandboxError
from sandbox.replay.golden.examine import Report
from sandbox.replay.recording.environment import environment
from sandbox.report.failure import Failure, failure_of
from sandbox.report.filming import MOST_POSES
from sandbox.report.markup import Node, node, text_of, whole_page
from sandbox.report.section import Entry, section

SHOWN = 20
"""Failures that get a player; the others are told in words."""
LEAST_POSES = 40_000
"""Poses that a film may have however many there are; together they share twice those of one."""
_ORDER = ("unusable", "diverged", "stale", "missing", "orphaned", "passed")


Filming: TypeAlias = Callable[[Report, int], Failure | None]
"""Makes the failure behind a report, with so many poses at most. Raises `SandboxError` or `OSError`."""


def write_report(
    path: Path,
    entries: Sequence[Entry],
    seconds: float,
    on_failure: Callable[[str], None] | None = None,
    filming: Filming = failure_of,
) -> None:
    """Write the report as one HTML file that needs nothing else. Raises `OSError`.

    `on_failure` hears the name of each failure before it is run again for its film, by `filming`.
    """
    write_text(path, report_page(entries, seconds, on_failure, filming))


def report_page(
    entries: Sequence[Entry],
    seconds: float,
    on_failure: Callable[[str], None] | None = None,
    filming: Filming = failure_of,
) -> str:
    """The HTML of the report."""
    failed = [entry for entry in entries if not entry.report.fine]
    filmed = [entry for entry in failed if entry.report.outcome and entry.report.outcome.divergence][:SHOWN]
    most = max(LEAST_POSES, min(MOST_POSES, 2 * MOST_POSES // max(len(filmed), 1)))
    body = [text_of(_head(entries, seconds)), text_of(_table(entries, failed))]
    for number, entry in enumerate(failed):
        if on_failure is not None:
            on_failure(entry.report.case.replay.name)
        found, trouble = _found(entry, most, filming) if entry in filmed else (None, "")
        body += section(entry, number, found, trouble)
    return whole_page("sandbox replay", body, "report")


def _found(entry: Entry, most: int, filming: Filming) -> tuple[Failure | None, str]:
    try:
        return filming(entry.report, most), ""
    except (SandboxError, OSError) as error:  # the files may have changed since
        return None, str(error)


def _head(entries: Sequence[Entry], seconds: float) -> Node:
    count = Counter(str(entry.report.verdict) for entry in entries)
    parts: list[Node | str] = []
    for word in (word for word in reversed(_ORDER) if count[word]):
        parts += [" · ", node("span", word, f"{count[word]} {word}")]
    steps = sum(entry.report.outcome.steps for entry in entries if entry.report.outcome)
    plural = "" if len(entries) == 1 else "s"
    facts = f"{steps:,} steps in {seconds:.1f} s · sandbox {__version__} · {environment()}"
    title = node("h1", "", f"{len(entries)} replay{plural}", *parts)
    return node("header", "", title, node("p", "soft", facts))


def _table(entries: Sequence[Entry], failed: Sequence[Entry]) -> Node:
    titles = ("recording", "number:steps", "number:seconds", "verdict", "first difference")
    head = [node("th", kind, name) for kind, _, name in (title.rpartition(":") for title in titles)]
    ordered = sorted(entries, key=lambda entry: (entry.report.fine, _ORDER.index(entry.report.verdict)))
    places = {id(entry): f"#case-{number}" for number, entry in enumerate(failed)}
    rows = [_row(entry, places.get(id(entry))) for entry in ordered]
    table = node("table", "scenes", node("thead", "", node("tr", "", *head)), node("tbody", "", *rows))
    return node("div", "scroll", table)


def _row(entry: Entry, place: str | None) -> Node:
    report = entry.report
    name = report.case.replay.as_posix()
    outcome = report.outcome
    verdict = report.action or report.verdict
    said = f"{report.verdict}, {report.action}" if report.action else report.verdict
    divergence = outcome.divergence if outcome else None
    first = f"step {divergence.step}: {divergence.group}" if divergence and not report.fine else ""
    return node(
        "tr", "",
        node("td", "", node("a", "", name, href=place) if place else name),
        node("td", "number", str(outcome.steps) if outcome else "–"),
        node("td", "number", f"{outcome.seconds:.2f}" if outcome else "–"),
        node("td", "", node("span", f"verdict {verdict}", said)),
        node("td", "soft", first),
    )  # fmt: skip
