"""A joint or path that is off from the start, and that nothing ever switches on."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, may_mean, path_to
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat_rules import FlatSetting


def check(subject: Subject) -> Iterator[Finding]:
    """What is not enabled, in scenes whose rules and controls leave it so."""
    for joint in subject.flat.joints:
        if not joint.enabled and not subject.is_driven(joint):
            yield Finding(path_to(joint), f"{quoted(joint.id)} is off, and nothing switches it on", _mend("joint"))
    for body in subject.flat.bodies:
        if body.path is not None and not body.path.enabled and not _is_let_go(subject, body.id):
            text = f"the path of {quoted(body.id)} is off, and nothing lets it go"
            yield Finding(path_to(body), text, _mend("path"))


def _is_let_go(subject: Subject, name: str) -> bool:
    settings = (action for action in subject.actions if isinstance(action, FlatSetting) and action.what == "path")
    return any(may_mean(action, name) for action in settings)


def _mend(what: str) -> str:
    return f'a rule or control does, as {{"{what}": ..., "enabled": true}}; or leave "enabled" out'


RULE = Rule("left-off", "joints and paths that are off, and that nothing switches on", check)
