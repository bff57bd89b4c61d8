"""Bodies of Box2D as bodies of a scene."""

from __future__ import annotations

from sandbox.formats.box2d.mass import mass_words
from sandbox.formats.box2d.world import Body, Fixture, Outline
from sandbox.formats.numbers import Vec, degrees, tidy, tidy_point, tidy_points
from sandbox.formats.outlines import Words, chain_words, convex_hull, polygon_words, without_repeats
from sandbox.formats.remarks import Remarks
from sandbox.scene.quantities import MAX_BOUNCE

_STAND_IN: Words = {"circle": 0.05, "sensor": True, "mask": 0}


def body_words(body: Body, remarks: Remarks) -> Words | None:
    """The body without its id, or None if it has no shape and cannot move; such a one is part of the world."""
    shapes = [words for fixture in body.fixtures for words in _shape_words(fixture, remarks)]
    if not shapes and body.type == "static":
        return None
    if not shapes:
        remarks.note(body.place, "a body without shapes stands as a sensor that feels nothing")
        shapes = [dict(_STAND_IN)]
    words: Words = {} if body.type == "dynamic" else {"type": body.type}
    words |= {"position": tidy_point(body.position), "shapes": shapes}
    if degrees(body.angle):
        words["angle"] = degrees(body.angle)
    if body.type != "static":
        words |= _motion_words(body, remarks)
    return words


def _motion_words(body: Body, remarks: Remarks) -> Words:
    velocity = tidy_point(body.velocity)
    words: Words = {"velocity": velocity} if any(velocity) else {}
    values = {
        "angular_velocity": degrees(body.spin), "linear_damping": body.linear_damping,
        "angular_damping": body.angular_damping,
    }  # fmt: skip
    words |= {key: tidied for key, value in values.items() if (tidied := tidy(value))}
    if body.type == "dynamic":
        words |= mass_words(body)
        if body.gravity_scale != 1.0:
            words["gravity_scale"] = tidy(body.gravity_scale)
        if body.bullet:
            words["bullet"] = True
    if not body.allow_sleep:
        words["sleep_speed"] = 0
    elif body.sleep_speed is not None:
        words["sleep_speed"] = tidy(max(body.sleep_speed, 0.0))
    if not body.awake:
        remarks.note(body.place, "a sleeping body begins awake")
    return words


def _shape_words(fixture: Fixture, remarks: Remarks) -> list[Words]:
    surface = _surface_words(fixture, remarks)
    return [words | surface for words in _geometry_words(fixture.outline, remarks, fixture.place)]


def _geometry_words(outline: Outline, remarks: Remarks, place: str) -> list[Words]:
    if outline.kind == "circle":
        return _circle_words(outline, remarks, place)
    if outline.kind == "capsule":
        return [{"capsule": tidy_points(outline.points), "radius": tidy(outline.radius)}]
    if outline.kind == "polygon" and len(outline.points) > 2:
        hull = convex_hull(outline.points)
        if len(hull) < len(without_repeats(outline.points)):
            remarks.note(place, "a polygon that is not convex is its hull, as in Box2D")
        words = polygon_words(hull, remarks, place)
        rounding: Words = {"radius": tidy(outline.radius)} if outline.radius > 0.0 else {}
        return [words | rounding] if words else []
    found = _line_words(outline, remarks, place)
    if outline.one_sided:
        found = [words | {"one_sided": True} for words in found]
    return found


def _line_words(outline: Outline, remarks: Remarks, place: str) -> list[Words]:
    found = chain_words(outline.points, outline.closed, remarks, place)
    if outline.closed or not found or (outline.before is None and outline.after is None):
        return found
    return _with_ghosts(found, outline, remarks, place)


def _with_ghosts(found: list[Words], outline: Outline, remarks: Remarks, place: str) -> list[Words]:
    if outline.before is None or outline.after is None or len(found) > 1:
        remarks.note(place, "ghost vertices are left out: a scene has them for both ends of one chain, or not at all")
        return found
    ends = {"ghosts": tidy_points([outline.before, outline.after])}
    (words,) = found
    return [{"chain": words["segment"], **ends} if "segment" in words else words | ends]


def _circle_words(outline: Outline, remarks: Remarks, place: str) -> list[Words]:
    if outline.radius < 1e-6:
        remarks.note(place, "a circle without a radius is left out")
        return []
    words: Words = {"circle": tidy(outline.radius)}
    center: Vec = outline.points[0]
    return [words | ({"at": tidy_point(center)} if center != (0.0, 0.0) else {})]


def _surface_words(fixture: Fixture, remarks: Remarks) -> Words:
    bounce = _bounded(fixture.restitution, MAX_BOUNCE, "restitution", fixture, remarks)
    density = fixture.density
    if 0.0 < density < 1e-6 or density > 1e9:
        density = min(max(density, 1e-6), 1e9)
        remarks.note(fixture.place, f"a density past the limits of a scene is {density:g} kg/m^2")
    friction = _bounded(fixture.friction, 1e3, "friction", fixture, remarks)
    values = {"density": (max(density, 0.0), 1.0), "friction": (friction, 0.5), "restitution": (bounce, 0.0)}
    words: Words = {key: tidy(value) for key, (value, usual) in values.items() if value != usual}
    if bounce > 1.0:
        words["bumper"] = True
    if fixture.sensor:
        words["sensor"] = True
    if fixture.rolling_resistance > 0.0:
        words["rolling_resistance"] = tidy(fixture.rolling_resistance)
    if fixture.surface_speed:
        words["surface_speed"] = tidy(fixture.surface_speed)
    return words | filter_words(fixture.category, fixture.mask, fixture.group, fixture.everything)


def filter_words(category: int, mask: int, group: int, everything: int = 0xFFFF) -> Words:
    """A filter of Box2D; its groups mean the same here, and a mask of all the bits that it has there is everything."""
    words: Words = {}
    if category != 1:
        words["category"] = category & 0xFFFFFFFF
    if mask & 0xFFFFFFFF not in (everything, 0xFFFFFFFF):
        words["mask"] = mask & 0xFFFFFFFF
    if group:
        words["group"] = group
    return words


def _bounded(value: float, most: float, what: str, fixture: Fixture, remarks: Remarks) -> float:
    kept = min(max(value, 0.0), most)
    if kept != value:
        remarks.note(fixture.place, f"a {what} of {value:g} is {kept:g}: a scene has 0 to {most:g}")
    return kept
