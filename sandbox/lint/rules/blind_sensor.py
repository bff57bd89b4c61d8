"""A sensor that feels nobody: no shape of another body passes its filter."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.meeting import can_feel
from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject, path_to
from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat import FlatBody, FlatShape


def check(subject: Subject) -> Iterator[Finding]:
    """Each sensor against all other bodies, those that may come included."""
    others = _unlike([*subject.flat.bodies, *subject.spawned])
    for body in subject.flat.bodies:
        sensors = [shape for shape in body.shapes if shape.sensor]
        blind = [sensor for sensor in sensors if not any(can_feel(sensor, body, other) for other in others)]
        if blind:
            which = "the sensor" if len(blind) == len(sensors) else "a sensor"
            text = f"{which} of {quoted(body.id)} can feel no other body"
            mend = "look at its mask and category; static bodies do not feel static ones"
            yield Finding(path_to(body), text, mend)


def _unlike(bodies: list[FlatBody]) -> list[FlatBody]:
    """Two bodies of each sort that filters can tell apart, as none feels itself."""
    kept: dict[tuple[object, ...], list[FlatBody]] = {}
    for body in bodies:
        sort = kept.setdefault((body.type, *sorted(map(_filter, body.shapes))), [])
        if len(sort) < 2:
            sort.append(body)
    return [body for sort in kept.values() for body in sort]


def _filter(shape: FlatShape) -> tuple[int, int, int, bool]:
    return shape.category, shape.mask, shape.group, shape.sensor


RULE = Rule("blind-sensor", "sensors that no filter lets feel anything", check)
