"""The reports as a JUnit file, which CI servers read."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree

from sandbox._atomic_write import write_bytes
from sandbox._printable import printable
from sandbox.cli.replay_messages import advice, reasons
from sandbox.replay.golden.examine import Report


def write_junit(path: Path, reports: Sequence[Report], seconds: float) -> None:
    """Write one test case a report. Raises `OSError` if the file cannot be written."""
    suite = ElementTree.Element("testsuite", name="sandbox replay", time=f"{seconds:.3f}")
    suite.set("tests", str(len(reports)))
    suite.set("errors", str(sum(report.verdict == "unusable" for report in reports)))
    suite.set("failures", str(sum(not report.fine and report.verdict != "unusable" for report in reports)))
    for report in reports:
        suite.append(_case(report))
    root = ElementTree.Element("testsuites")
    root.append(suite)
    ElementTree.indent(root)
    write_bytes(path, ElementTree.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n")


def _case(report: Report) -> ElementTree.Element:
    taken = report.outcome.seconds if report.outcome else 0.0
    path = report.case.replay
    name = printable(path.name)
    case = ElementTree.Element("testcase", classname=printable(path.parent.as_posix()), name=name)
    case.set("time", f"{taken:.3f}")
    if not report.fine:
        kind = "error" if report.verdict == "unusable" else "failure"
        lines = [*reasons(report), *advice(report)]
        trouble = ElementTree.SubElement(case, kind, type=report.verdict, message=printable(lines[0]))
        trouble.text = "\n".join(printable(line) for line in lines)
    return case
