"""The rules between the fields of a region, and of a thruster."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any

from sandbox.scene import plain
from sandbox.scene.finding import Finding, Path, quoted
from sandbox.scene.known import Known
from sandbox.scene.limits import MAX_FINDINGS, MAX_REGIONS

_AREAS = ("inside", "disc", "outline")


def field_rules(data: dict[str, Any], known: Known) -> Iterator[Finding]:
    """A finding for every region with two areas or an id that is taken, and for all that ends before it begins."""
    seen: set[str] = set()
    for path, region in islice(plain.children(data.get("regions"), ("regions",)), MAX_REGIONS):
        name = region.get("id")
        if isinstance(name, str):
            if name in seen or name in known.regions:
                yield Finding((*path, "id"), f"the id {quoted(name)} is taken by another region")
            seen.add(name)
        given = [key for key in _AREAS if region.get(key) is not None]
        if len(given) > 1:
            listed = " and ".join(f'"{key}"' for key in given)
            yield Finding((*path, given[-1]), f"a region has one area, and this one has {listed}", on_key=True)
        yield from _schedule(path, region)
    for path, body in plain.patterns(data):
        for place, thruster in islice(plain.children(body.get("thrusters"), (*path, "thrusters")), MAX_FINDINGS):
            yield from _schedule(place, thruster)
        if body.get("thrusters") and body.get("type") in ("static", "kinematic"):
            yield Finding((*path, "thrusters"), f"a {body['type']} body cannot be pushed", "make it dynamic")


def _schedule(path: Path, field: dict[str, Any]) -> Iterator[Finding]:
    start, end = field.get("start", 0), field.get("end")
    if plain.is_number(start) and plain.is_number(end) and end <= start:
        yield Finding((*path, "end"), f'"end" must be later than "start" ({start:g} s)')
