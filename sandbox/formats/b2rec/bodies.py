"""Bodies of a recording as those of a Box2D world."""

from __future__ import annotations

from sandbox.formats.b2rec.made import Made, angle_of
from sandbox.formats.b2rec.shapes import fixture_of
from sandbox.formats.b2rec.weight import weight
from sandbox.formats.box2d.terms import TYPES
from sandbox.formats.box2d.world import Body
from sandbox.formats.reading import MisreadError, place_of
from sandbox.formats.remarks import Remarks

_USUAL_SLEEP = 0.05


def body_of(made: Made, shapes: list[Made], number: int, remarks: Remarks) -> Body:
    """The body with its fixtures. Raises `MisreadError` for a type that Box2D does not have."""
    values = made.values
    place = place_of(("body", number), values["name"])
    if values["type"] not in range(len(TYPES)):
        raise MisreadError((), f"{place} is of the unknown type {values['type']}")
    locks = values["motionLocks"]
    if locks["linearX"] or locks["linearY"]:
        remarks.note(place, "locks of x and y are left out")
    body = Body(
        place=place,
        name=values["name"],
        type=TYPES[values["type"]],
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
        fixtures=[fixture_of(shape, f"{place} shape[{k}]", remarks) for k, shape in enumerate(shapes)],
    )
    if abs(values["sleepThreshold"] - _USUAL_SLEEP) > 1e-6:
        body.sleep_speed = values["sleepThreshold"]
    if body.type == "dynamic":
        _weigh(body, made, shapes, remarks)
    return body


def _weigh(body: Body, made: Made, shapes: list[Made], remarks: Remarks) -> None:
    """Its mass as Box2D 3 has it: rounded polygons weigh more, and a body without mass is not moved by anything."""
    body.mass_data = weight(made, shapes)
    if body.mass_data.mass <= 0.0:
        body.type, body.mass_data = "kinematic", None
        remarks.note(body.place, "a body that weighs nothing moves as a kinematic one, as in Box2D 3")
