"""What a body of Box2D weighs, and what is to be said of it in a scene (source: `b2Body::ResetMassData`, Box2D 2.4)."""

from __future__ import annotations

import math
from collections.abc import Iterable

from sandbox.formats.box2d.world import Body, Fixture, MassData
from sandbox.formats.numbers import tidy, tidy_point
from sandbox.formats.outlines import Words, convex_hull
from sandbox.geometry.mass import Moments, moments

_NEAR = 1e-4
"""Share by which masses may differ that come of numbers of 32 bits."""


def mass_of(body: Body) -> MassData:
    """As given in the file, else of the fixtures; a dynamic body weighs 1 kg at least and does not turn then."""
    found = body.mass_data or _of_fixtures(body.fixtures)
    if body.type == "dynamic" and found.mass <= 0.0:
        return MassData(1.0, (0.0, 0.0), 0.0)
    return found


def central_inertia(data: MassData) -> float:
    """About the centre of mass, kg m^2."""
    return data.inertia - data.mass * (data.center[0] ** 2 + data.center[1] ** 2)


def mass_words(body: Body) -> Words:
    """Fields of a scene's body, where its shapes alone would weigh something else: sensors have a mass in Box2D."""
    wanted = mass_of(body)
    own = _of_fixtures(fixture for fixture in body.fixtures if not fixture.sensor)
    inertia = central_inertia(wanted)
    turns = inertia > 1e-12 and not body.fixed_rotation
    words: Words = {} if turns else {"fixed_rotation": True}
    if own.mass <= 0.0 or not _alike(wanted, own):
        words["mass"] = tidy(wanted.mass) or wanted.mass
        if turns:
            words["inertia"] = tidy(inertia) or inertia
        if wanted.center != (0.0, 0.0) or own.mass > 0.0:
            words["center"] = tidy_point(wanted.center)
    return words


def _alike(one: MassData, two: MassData) -> bool:
    size = math.sqrt(max(two.inertia, 0.0) / two.mass)
    return (
        math.isclose(one.mass, two.mass, rel_tol=_NEAR)
        and math.isclose(one.inertia, two.inertia, rel_tol=_NEAR)
        and math.dist(one.center, two.center) <= _NEAR * size
    )


def _of_fixtures(fixtures: Iterable[Fixture]) -> MassData:
    total = Moments(0.0, 0.0, 0.0, 0.0)
    for fixture in fixtures:
        total = total.plus(_moments(fixture))
    if total.area <= 0.0:
        return MassData(0.0, (0.0, 0.0), 0.0)
    return MassData(total.area, (total.first_x / total.area, total.first_y / total.area), total.second)


def _moments(fixture: Fixture) -> Moments:
    """Times the density; lines weigh nothing."""
    outline = fixture.outline
    core = convex_hull(outline.points) if outline.kind == "polygon" else outline.points
    flat = outline.kind == "polygon" and len(core) < 3
    if flat or outline.kind == "chain" or fixture.density <= 0.0 or not core:
        return Moments(0.0, 0.0, 0.0, 0.0)
    return Moments(*(fixture.density * value for value in moments(core, outline.radius)))
