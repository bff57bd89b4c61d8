"""An expectation that holds whatever happens, and so says nothing."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject
from sandbox.scene.expect import Above, Apart, Below, CounterIs, Ended, Expectation, Inside, Stands
from sandbox.scene.finding import Finding
from sandbox.scene.flat_rules import FlatEnd

_ABOUT_BODIES = ("rests", "stands", "asleep", "of")


def check(subject: Subject) -> Iterator[Finding]:
    """Each expectation by its kind; whether it holds is for `sandbox check` to say."""
    for number, expectation in enumerate(subject.scene.expect):
        why = _why(subject, expectation)
        if why:
            mend = "expect something that could go wrong, or take it out"
            yield Finding(("expect", number), f"this cannot change while the scene runs: {why}", mend)


def _why(subject: Subject, expectation: Expectation) -> str:
    match expectation:
        case Ended(outcome="open"):
            return "" if any(isinstance(a, FlatEnd) for a in subject.actions) else "nothing wins or loses the game"
        case CounterIs(counter=name):
            return "" if subject.changes(name) else f'nothing changes the counter "{name}"'
        case Apart(apart=(one, two)):
            return "" if _can_meet(subject, one, two) else "neither of the two can move"
        case Stands() if expectation.at == 0 or (expectation.within and expectation.within[0] == 0):
            return "at step 0 everybody stands where it started"
    return _of_static(subject, expectation)


def _of_static(subject: Subject, expectation: Expectation) -> str:
    ids = next((found for name in _ABOUT_BODIES if (found := getattr(expectation, name, None)) is not None), None)
    if ids is None:
        about_all = isinstance(expectation, (Above, Below, Inside))
        return "there is no dynamic body" if about_all and not _has_dynamic(subject) else ""
    meant = [subject.bodies[name] for name in subject.named(ids)]
    still = meant and all(body.type == "static" and not subject.is_played(body.id) for body in meant)
    return "it speaks of static bodies alone" if still else ""


def _has_dynamic(subject: Subject) -> bool:
    return any(body.type == "dynamic" for body in (*subject.flat.bodies, *subject.spawned))


def _can_meet(subject: Subject, one: str, two: str) -> bool:
    """Filters are not asked: an expectation that they keep two apart says that they stay as they are."""
    found = [[subject.bodies[name] for name in subject.named(ids)] for ids in (one, two)]
    return not all(found) or any(body.type != "static" for bodies in found for body in bodies)


RULE = Rule("never-fails", "expectations that hold whatever happens", check)
