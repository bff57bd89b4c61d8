"""What a report shows of one case that did not pass."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass

from sandbox.replay.golden.examine import Report
from sandbox.report.environment_table import environment_table
from sandbox.report.failure import Failure
from sandbox.report.film_data import film_data, packed
from sandbox.report.markup import Node, film_script, node, text_of
from sandbox.report.sat_panel import sat_panel


@dataclass(frozen=True)
class Entry:
    """A report, why it did not pass, and the commands that show and accept it."""

    report: Report
    reasons: Sequence[str] = ()
    advice: Sequence[str] = ()


def section(entry: Entry, number: int, failure: Failure | None, trouble: str) -> list[str]:
    """The HTML of case `number`, in parts; `trouble` says why there is no failure to show, if it could not be had."""
    report = entry.report
    title = node("h2", "", report.case.replay.as_posix(), node("span", f"verdict {report.verdict}", report.verdict))
    parts = [title]
    if report.scene:
        parts.append(node("p", "soft", f"of {report.scene}"))
    parts.append(node("ul", "reasons", *(node("li", "", line) for line in entry.reasons)))
    if trouble:
        parts.append(node("p", "soft", f"It could not be filmed: {trouble}"))
    films: list[Node] = []
    if failure is not None:
        parts += _player(failure, number)
        films = _films(failure, number)
        parts += [node("h3", "", _pair_title(failure)), *sat_panel(failure.pair)] if failure.pair else []
    if entry.advice:
        parts += [node("h3", "", "what to do"), node("pre", "", "\n".join(entry.advice))]
    if failure is not None and failure.recording is not None:
        parts += [node("h3", "", "environment"), environment_table(failure.recording)]
    return [text_of(part) for part in (node("section", "failure", *parts, id=f"case-{number}"), *films)]


def _player(failure: Failure, number: int) -> list[Node]:
    data = {"data-got": f"got-{number}", "data-parted": str(failure.parted)}
    if failure.pair is not None:
        data["data-names"] = json.dumps(failure.pair.names)
    if failure.expected is not None:
        data["data-expected"] = f"expected-{number}"
        said = f"In colour what was got, as a ghost what is expected: the run with {failure.origin}."
    elif failure.ends is not None:
        data |= {"data-expected": f"expected-{number}", "data-end-only": ""}
        said = "In colour what was got. The recorded run cannot be had again here; the ghost is where it ended."
    else:
        said = "What was got. The recorded run cannot be had again here."
    return [node("p", "soft", said), node("div", "player", **data)]


def _films(failure: Failure, number: int) -> list[Node]:
    other = failure.expected or failure.ends
    got = film_data(failure.got)
    if failure.expected is None and failure.recording is not None:
        rows = failure.recording.checkpoints
        got["checkpoints"] = [asdict(row) for row in rows if failure.got.start <= row.step <= failure.got.end]
    films = [film_script(f"got-{number}", packed(got))]
    return [*films, film_script(f"expected-{number}", packed(film_data(other)))] if other is not None else films


def _pair_title(failure: Failure) -> str:
    if failure.expected is not None:
        return "separating-axis test of the first pair that differs"
    return "separating-axis test at the body that ended farthest off"
