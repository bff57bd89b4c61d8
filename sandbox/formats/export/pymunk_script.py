"""A scene as a Python program that needs nothing but pymunk."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sandbox._printable import printable
from sandbox.formats.export.common import mass_of, note_foreign, note_settings
from sandbox.formats.export.pymunk_joints import KINDS, joint_lines
from sandbox.formats.remarks import Remarks
from sandbox.scene.flat import FlatBody, FlatJoint, FlatScene, FlatShape
from sandbox.scene.scene import Scene

_HEAD = '''\
"""{title}

Made by `sandbox export`. Run it, or import `space` and `bodies` from it.
"""

import math

import pymunk

STATIC, KINEMATIC, DYNAMIC = pymunk.Body.STATIC, pymunk.Body.KINEMATIC, pymunk.Body.DYNAMIC
STEPS, STEP = {steps}, 1 / {rate}

space = pymunk.Space()
space.gravity = {gravity}
bodies = {{}}


def add_body(name, kind, position, angle, velocity=(0, 0), spin=0, mass=0, moment=0, center=(0, 0)):
    """A body; `moment` is about its centre of mass."""
    body = bodies[name] = pymunk.Body(body_type=kind)
    if kind == DYNAMIC:
        body.mass, body.moment, body.center_of_gravity = mass, moment, center
    body.angle = angle  # first: pymunk turns a body about its centre of mass, which moves the origin
    body.position = position
    if kind != STATIC:
        body.velocity, body.angular_velocity = velocity, spin
    space.add(body)
    return body


def add_shape(shape, friction, bounce, category=1, mask=0xFFFFFFFF, group=0, sensor=False):
    """A shape with its surface. pymunk multiplies the frictions of a pair: hence their roots."""
    shape.friction, shape.elasticity = math.sqrt(friction), bounce
    shape.filter = pymunk.ShapeFilter(group, category, mask)
    shape.sensor = sensor
    space.add(shape)


def move_its_own_way(body, gravity_scale, linear_damping, angular_damping):
    """Gravity scale and damping (1/s) of one body."""

    def update(body, gravity, damping, step):
        spin = body.angular_velocity
        pymunk.Body.update_velocity(body, gravity * gravity_scale, math.exp(-linear_damping * step), step)
        body.angular_velocity = spin * math.exp(-angular_damping * step)

    body.velocity_func = update


def add_joint(joint, collide):
    """A constraint; `collide`: its two bodies collide with each other."""
    joint.collide_bodies = collide
    space.add(joint)
'''
_TAIL = """\

if __name__ == "__main__":
    for _ in range(STEPS):
        space.step(STEP)
    for name, body in bodies.items():
        print(name, *body.position, body.angle)
"""


def pymunk_text(scene: Scene, remarks: Remarks) -> str:
    """The program."""
    flat = scene.flatten()
    note_foreign(flat, remarks)
    note_settings(scene, remarks, {"step_rate", "units_per_meter"})
    _note(flat, remarks)
    settings = scene.settings
    title = printable(scene.title).replace("\\", "/").replace('"', "'") or "A scene"
    gravity = (float(flat.gravity[0]), float(flat.gravity[1]))
    head = _HEAD.format(title=title, steps=settings.steps, rate=repr(settings.step_rate), gravity=gravity)
    lines = [line for body in flat.bodies for line in _body_lines(body)]
    lines += [line for joint in flat.joints for line in _joint(joint, flat, remarks)]
    return head + "\n\n" + "\n".join(lines) + "\n" + _TAIL


def _note(flat: FlatScene, remarks: Remarks) -> None:
    for body in flat.bodies:
        if any(shape.restitution for shape in body.shapes):
            remarks.note(body.id, "pymunk multiplies the restitutions of a pair; here the larger one holds")
        if any(shape.group > 0 for shape in body.shapes):
            remarks.note(body.id, "pymunk has no groups that always collide")
        if body.bullet:
            remarks.note(body.id, "pymunk has no bullets")


def _body_lines(body: FlatBody) -> Iterator[str]:
    words = [repr(body.id), body.type.upper(), _point(body.position), repr(float(body.angle))]
    if body.type != "static" and (body.velocity != (0.0, 0.0) or body.angular_velocity):
        words += [f"velocity={_point(body.velocity)}", f"spin={body.angular_velocity!r}"]
    if body.type == "dynamic":
        data = mass_of(body)
        moment = "math.inf" if body.fixed_rotation else repr(data.inertia)
        words += [f"mass={data.mass!r}", f"moment={moment}", f"center={_point(data.center)}"]
    yield f"body = add_body({', '.join(words)})"
    if body.type != "static" and (body.gravity_scale != 1.0 or body.linear_damping or body.angular_damping):
        yield f"move_its_own_way(body, {body.gravity_scale!r}, {body.linear_damping!r}, {body.angular_damping!r})"
    for shape in body.shapes:
        yield f"add_shape({_shape(shape)}{_surface(shape)})"


def _shape(shape: FlatShape) -> str:
    corners = [_point(corner) for corner in shape.vertices]
    if len(corners) == 1:
        return f"pymunk.Circle(body, {shape.radius!r}, {corners[0]})"
    if len(corners) == 2:
        return f"pymunk.Segment(body, {corners[0]}, {corners[1]}, {shape.radius!r})"
    radius = f", radius={shape.radius!r}" if shape.radius else ""
    return f"pymunk.Poly(body, [{', '.join(corners)}]{radius})"


def _surface(shape: FlatShape) -> str:
    words = f", {shape.friction!r}, {shape.restitution!r}"
    usual = {"category": 1, "mask": 0xFFFFFFFF, "group": 0, "sensor": False}
    given = {"category": shape.category, "mask": shape.mask, "group": max(0, -shape.group), "sensor": shape.sensor}
    return words + "".join(f", {key}={value!r}" for key, value in given.items() if value != usual[key])


def _joint(joint: FlatJoint, flat: FlatScene, remarks: Remarks) -> Iterator[str]:
    if joint.kind not in KINDS or not joint.enabled:
        what = f"a joint of the type {joint.kind}" if joint.enabled else "a joint that is switched off"
        remarks.note(joint.id, f"{what} is left out")
        return
    by_id = {body.id: body for body in flat.bodies if body.id in (joint.body_a, joint.body_b)}
    a, b = by_id.get(str(joint.body_a)), by_id.get(str(joint.body_b))
    ends = ", ".join(f"bodies[{body.id!r}]" if body else "space.static_body" for body in (a, b))
    for kind, arguments, strength in joint_lines(joint, a, b):
        yield f"joint = pymunk.{kind}({ends}, {arguments})"
        if math.isfinite(strength):
            yield f"joint.max_force = {strength!r}"
        yield f"add_joint(joint, {joint.collide})"


def _point(point: tuple[float, float]) -> str:
    return f"({float(point[0])!r}, {float(point[1])!r})"
