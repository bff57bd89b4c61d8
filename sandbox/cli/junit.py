"""What became of files as a JUnit report, which CI servers read."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal
from xml.etree import ElementTree

from sandbox._atomic_write import write_bytes
from sandbox._printable import printable


@dataclass(frozen=True)
class JUnitCase:
    """One file: the seconds that it took, and if it is not fine, what kind of trouble there is, in a word and lines."""

    path: Path
    seconds: float
    trouble: Literal["", "failure", "error"] = ""
    verdict: str = ""
    lines: Sequence[str] = ()


def write_junit(path: Path, name: str, cases: Sequence[JUnitCase], seconds: float) -> None:
    """Write one suite called `name`. Raises `OSError` if the file cannot be written."""
    suite = ElementTree.Element("testsuite", name=name, time=f"{seconds:.3f}")
    suite.set("tests", str(len(cases)))
    suite.set("errors", str(sum(case.trouble == "error" for case in cases)))
    suite.set("failures", str(sum(case.trouble == "failure" for case in cases)))
    suite.extend(map(_element, cases))
    root = ElementTree.Element("testsuites")
    root.append(suite)
    ElementTree.indent(root)
    write_bytes(path, ElementTree.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n")


def _element(case: JUnitCase) -> ElementTree.Element:
    folder, name = printable(case.path.parent.as_posix()), printable(case.path.name)
    made = ElementTree.Element("testcase", classname=folder, name=name, time=f"{case.seconds:.3f}")
    if case.trouble:
        first = printable(case.lines[0].strip())
        trouble = ElementTree.SubElement(made, case.trouble, type=case.verdict, message=first)
        trouble.text = "\n".join(printable(line) for line in case.lines)
    return made
