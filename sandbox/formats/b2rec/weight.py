"""What a body of a recording weighs, and how pushes move it, as Box2D 3 has it (source: `src/body.c`)."""

from __future__ import annotations

from sandbox.formats.b2rec.made import Made, angle_of
from sandbox.formats.b2rec.shapes import outline_of, weighed
from sandbox.formats.box2d.mass import central_inertia, mass_of
from sandbox.formats.box2d.world import Body, Fixture, MassData
from sandbox.formats.numbers import Vec, turned

_DYNAMIC = 2


def weight(made: Made, shapes: list[Made]) -> MassData:
    """As it was set, else of the shapes."""
    given = made.values.get("massData")
    if given is not None:
        (x, y), mass = given["center"], given["mass"]
        return MassData(mass, (x, y), given["rotationalInertia"] + mass * (x * x + y * y))
    solid = (shape for shape in shapes if shape.kind != "chain" and shape.values["density"] > 0.0)
    fixtures = [Fixture("", weighed(outline_of(shape)), shape.values["density"]) for shape in solid]
    return mass_of(Body("", "", "kinematic", fixtures=fixtures))


def center_of(made: Made, shapes: list[Made]) -> Vec:
    """The centre of mass in the world; what cannot be pushed has it at its origin."""
    local = weight(made, shapes).center if made.values["type"] == _DYNAMIC else (0.0, 0.0)
    x, y = turned(local, angle_of(made.values["rotation"]))
    px, py = made.values["position"]
    return px + x, py + y


def move_center(made: Made, before: Vec, after: Vec) -> None:
    """The velocity goes with the centre of mass, which has moved because the mass has changed."""
    (vx, vy), spin = made.values["linearVelocity"], made.values["angularVelocity"]
    made.values["linearVelocity"] = (vx - spin * (after[1] - before[1]), vy + spin * (after[0] - before[0]))


def push(made: Made, shapes: list[Made], impulse: Vec, point: Vec | None = None, turn: float = 0.0) -> None:
    """An impulse (N s) at a point, None: the centre of mass, and one that turns (N m s)."""
    values = made.values
    if values["type"] != _DYNAMIC or not values["isEnabled"]:
        return
    data, (cx, cy), (vx, vy) = weight(made, shapes), center_of(made, shapes), values["linearVelocity"]
    if point is not None:
        turn += (point[0] - cx) * impulse[1] - (point[1] - cy) * impulse[0]
    if data.mass > 0.0:
        values["linearVelocity"] = (vx + impulse[0] / data.mass, vy + impulse[1] / data.mass)
    if (inertia := central_inertia(data)) > 0.0 and not values["motionLocks"]["angularZ"]:
        values["angularVelocity"] += turn / inertia
