"""Lengths that look like pixels, in a scene that does not say so: what counts as slow or near is meant in metres."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.lint.rule import Rule
from sandbox.lint.subject import Subject
from sandbox.scene.finding import Finding

LARGE = 15.0
"""Least extent (units of length): few scenes have nothing smaller in motion that are in metres."""
FEW = 3
"""So many bodies without gravity may well be ships or planets."""


def check(subject: Subject) -> Iterator[Finding]:
    """The smallest dynamic body, where a unit counts as a metre."""
    if subject.flat.settings.units_per_meter != 1.0 or "units_per_meter" in subject.scene.settings.given():
        return
    boxes = [subject.boxes[body.id] for body in subject.flat.bodies if body.type == "dynamic" and body.shapes]
    sizes = [max(right - left, top - bottom) for left, bottom, right, top in boxes]
    enough = 0 if any(subject.flat.gravity) else FEW
    if len(sizes) > enough and min(sizes) > LARGE:
        text = f"nothing that moves is smaller than {min(sizes):.3g} m, as if lengths were pixels"
        yield Finding(("settings",), text, 'say how many make a metre, as "units_per_meter": 100, or 1')


RULE = Rule("pixels", "lengths that are no metres", check)
