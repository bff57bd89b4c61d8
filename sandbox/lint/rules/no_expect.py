"""A scene that expects nothing: a check of it says only that it runs."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject
from sandbox.scene.finding import Finding


def check(subject: Subject) -> Iterator[Finding]:
    """Whether there is an expectation at all."""
    if not subject.scene.expect:
        mend = 'say what must hold, such as {"always": true, "inside": [-20, -1, 20, 20]}'
        yield Finding((), "the scene expects nothing, so that sandbox check has nothing to judge", mend)


RULE = Rule("no-expect", "scenes that expect nothing", check)
