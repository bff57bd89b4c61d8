"""In what the environments of a recording and of this run differ."""

from __future__ import annotations

from sandbox._version import __version__
from sandbox.engine.arithmetic_version import ARITHMETIC
from sandbox.replay.recording.environment import environment
from sandbox.replay.recording.recording import Recording
from sandbox.report.markup import Node, node


def environment_differences(recording: Recording) -> list[tuple[str, str, str]]:
    """(what, when it was recorded, now) of the version and of everything that `environment` tells."""
    rows = [
        ("sandbox", recording.version, __version__),
        ("arithmetic of the engine", str(recording.arithmetic), str(ARITHMETIC)),
    ]
    before, now = recording.environment.split(", "), environment().split(", ")
    if len(before) != len(now):
        return [*rows, ("environment", recording.environment or "not said", environment())]
    for old, new in zip(before, now, strict=True):
        what = new.partition(" ")[0]
        # The last part is the system itself, "Linux x86_64".
        named = what == old.partition(" ")[0] and new is not now[-1]
        cut = len(what) + 1 if named else 0
        rows.append((what if named else "system", old[cut:], new[cut:]))
    return rows


def environment_table(recording: Recording) -> Node:
    """The same as a table; what differs is red."""
    head = node("tr", "", *(node("th", "", title) for title in ("", "recorded", "here")))
    rows = []
    for what, before, now in environment_differences(recording):
        cells = node("td", "soft", what), node("td", "", before), node("td", "" if before == now else "other", now)
        rows.append(node("tr", "", *cells))
    return node("div", "wide", node("table", "facts", node("thead", "", head), node("tbody", "", *rows)))
