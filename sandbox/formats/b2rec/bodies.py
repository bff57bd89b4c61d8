"""Bodies and shapes of a recording as those of a Box2D world."""

from __future__ import annotations

import math
from dataclasses import replace

from sandbox.formats.b2rec.session import Made, Values
from sandbox.formats.box2d.mass import mass_of
from sandbox.formats.box2d.world import Body, BodyType, Fixture, MassData, Outline
from sandbox.formats.numbers import Vec, turned
from sandbox.formats.reading import MisreadError, place_of
from sandbox.formats.remarks import Remarks

_TYPES: tuple[BodyType, ...] = ("static", "kinematic", "dynamic")
_ALL_BITS = 0xFFFFFFFF
_CORNERS = 8
_USUAL_SLEEP = 0.05


def body_of(made: Made, shapes: list[Made], number: int, remarks: Remarks) -> Body:
    """The body with its fixtures. Raises `MisreadError` for a type that Box2D does not have."""
    values = made.values
    place = place_of(("body", number), values["name"])
    if values["type"] not in range(len(_TYPES)):
        raise MisreadError((), f"{place} is of the unknown type {values['type']}")
    locks = values["motionLocks"]
    if locks["linearX"] or locks["linearY"]:
        remarks.note(place, "locks of x and y are left out")
    body = Body(
        place=place,
        name=values["name"],
        type=_TYPES[values["type"]],
        position=values["position"],
        angle=angle_of(values["rotation"]),
        velocity=values["linearVelocity"],
        spin=values["angularVelocity"],
        linear_damping=values["linearDamping"],
        angular_damping=values["angularDamping"],
        gravity_scale=values["gravityScale"],
        fixed_rotation=locks["angularZ"],
        bullet=values["isBullet"],
        allow_sleep=values["enableSleep"],
        awake=values["isAwake"],
        active=values["isEnabled"],
        fixtures=[_fixture(shape, f"{place} shape[{k}]", remarks) for k, shape in enumerate(shapes)],
    )
    if abs(values["sleepThreshold"] - _USUAL_SLEEP) > 1e-6:
        body.sleep_speed = values["sleepThreshold"]
    if body.type == "dynamic":
        _weigh(body, values, remarks)
    return body


def angle_of(rotation: Vec) -> float:
    """Of cosine and sine, rad."""
    return math.atan2(rotation[1], rotation[0])


def _weigh(body: Body, values: Values, remarks: Remarks) -> None:
    """Its mass as Box2D 3 has it: rounded polygons weigh more, and a body without mass is not moved by anything.

    The velocity of a definition is that of the origin; a scene has that of the centre of mass.
    """
    given = values.get("massData")
    solid = [replace(each, outline=_weighed(each.outline)) for each in body.fixtures]
    body.mass_data = mass_of(replace(body, type="kinematic", fixtures=solid))
    center = body.mass_data.center
    if given is not None:
        (x, y), mass = given["center"], given["mass"]
        body.mass_data = MassData(mass, (x, y), given["rotationalInertia"] + mass * (x * x + y * y))
    if body.mass_data.mass <= 0.0:
        body.type, body.mass_data = "kinematic", None
        remarks.note(body.place, "a body that weighs nothing moves as a kinematic one, as in Box2D 3")
    elif not values.get("ofCenter"):
        x, y = turned(center, body.angle)
        body.velocity = (body.velocity[0] - body.spin * y, body.velocity[1] + body.spin * x)


def _weighed(outline: Outline) -> Outline:
    """What a shape weighs as: `b2ComputePolygonMass` moves rounded corners outwards by root 2 of the radius."""
    if outline.kind != "polygon" or outline.radius <= 0.0:
        return outline
    corners, moved = outline.points, []
    for k, (x, y) in enumerate(corners):
        (ax, ay), (bx, by) = _normal(corners[k - 1], (x, y)), _normal((x, y), corners[(k + 1) % len(corners)])
        length = math.hypot(ax + bx, ay + by) or 1.0
        reach = math.sqrt(2.0) * outline.radius / length
        moved.append((x + reach * (ax + bx), y + reach * (ay + by)))
    return Outline("polygon", moved)


def _normal(a: Vec, b: Vec) -> Vec:
    length = math.dist(a, b) or 1.0
    return (b[1] - a[1]) / length, (a[0] - b[0]) / length


def _fixture(made: Made, place: str, remarks: Remarks) -> Fixture:
    values, is_chain = made.values, made.kind == "chain"
    surface = values["materials"][0] if is_chain and values["materials"] else values
    if is_chain and any(each != surface for each in values["materials"]):
        remarks.note(place, "a chain of several materials has the first one all along")
    outline = _outline(made, place)
    filters = values["filter"]
    if filters["categoryBits"] > _ALL_BITS or filters["maskBits"] not in (2**64 - 1, filters["maskBits"] & _ALL_BITS):
        remarks.note(place, "of 64 bits of a filter the lower 32 are kept")
    rolling = surface["rollingResistance"]
    if rolling > 0.0 and outline.radius <= 0.0:
        remarks.note(place, "rolling resistance of a shape that is not round is left out")
    return Fixture(
        place=place,
        outline=outline,
        density=values.get("density", 0.0),
        friction=surface["friction"],
        restitution=surface["restitution"],
        sensor=values.get("isSensor", False),
        category=filters["categoryBits"],
        mask=filters["maskBits"],
        group=filters["groupIndex"],
        everything=_ALL_BITS,
        rolling_resistance=rolling * outline.radius,
        surface_speed=surface["tangentSpeed"],
    )


def _outline(made: Made, place: str) -> Outline:
    values, shape = made.values, made.values["geometry"]
    if made.kind == "circle":
        return Outline("circle", [shape["center"]], shape["radius"])
    if made.kind == "capsule":
        return Outline("capsule", [shape["center1"], shape["center2"]], shape["radius"])
    if made.kind == "segment":
        return Outline("chain", [shape["point1"], shape["point2"]])
    if made.kind == "chainsegment":
        ends = [shape["point2"], shape["point1"]]
        return Outline("chain", ends, before=shape["ghost2"], after=shape["ghost1"], one_sided=True)
    if made.kind == "chain":
        # There it is solid from the right of it.
        points = values["points"][::-1]
        if values["isLoop"] or len(points) < 4:
            return Outline("chain", points, closed=values["isLoop"], one_sided=True)
        return Outline("chain", points[1:-1], before=points[0], after=points[-1], one_sided=True)
    if not 3 <= shape["count"] <= _CORNERS:
        raise MisreadError((), f"{place} is a polygon of {shape['count']} corners; it can have 3 to {_CORNERS}")
    flat = shape["vertices"]
    return Outline("polygon", [(flat[2 * k], flat[2 * k + 1]) for k in range(shape["count"])], shape["radius"])
