"""A heavy body on a light one: beyond a ratio of a thousand, joints need many substeps to hold."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to
from sandbox.scene.finding import Finding, quoted

MOST = 1000.0


def check(subject: Subject) -> Iterator[Finding]:
    """The masses of the two bodies of each joint."""
    if not subject.flat.joints:
        return
    for joint in subject.flat.joints:
        ends = sorted((subject.masses[body.id], body.id) for body, _ in subject.ends(joint) if body.type == "dynamic")
        if len(ends) == 2 and ends[1][0] > MOST * ends[0][0]:
            (light, one), (heavy, two) = ends
            text = f"{quoted(joint.id)} joins {quoted(two)} to {quoted(one)}, of {heavy / light:.3g} times less mass"
            yield Finding(path_to(joint), text, f"stay below {MOST:g} times: mind the densities")


RULE = Rule("mass-ratio", "joints between bodies of very unlike masses", check)
