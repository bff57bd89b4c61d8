"""Joints of Box2D as joints of a scene.

There, anchors stand in the frames of both bodies, and angles and slides count from a reference; here a joint has one
anchor in the world, and both count from the pose that the scene starts with. Where anchors stand apart at the start
along the axis of a slide, limits and rests are shifted by that; elsewhere Box2D would pull them together.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from sandbox.formats.box2d.pose import Pose, in_world, mobility, turning
from sandbox.formats.box2d.world import Body, Joint, Spring
from sandbox.formats.numbers import degrees, tidy, tidy_point
from sandbox.formats.outlines import Words
from sandbox.formats.remarks import Remarks

_APART = 0.005
"""Anchors that stand further apart (m) are worth a remark: what Box2D itself lets be (`b2_linearSlop`)."""
_ASKEW = math.radians(2.0)
"""The same of angles (`b2_angularSlop`), rad."""
_BOUNDLESS = 1e6
"""A limit (m or rad) so far away is none."""
_STAYS_TURNED = "its bodies stay turned against each other as at the start; Box2D would turn them to the reference"


def joint_words(joint: Joint, a: Body, b: Body, remarks: Remarks) -> Words | None:
    """The joint without its id and bodies; None, with a remark, for a kind that a scene does not have."""
    make = _KINDS.get(joint.kind)
    if make is None:
        remarks.note(joint.place, f'a joint of the type "{joint.kind[:40]}" is left out')
        return None
    words = make(Pose(joint, a, b, remarks))
    return words | ({"collide": True} if joint.collide else {})


def _revolute(pose: Pose) -> Words:
    held = _limits(pose, pose.angle, degrees) | _resting(pose, pose.angle, degrees)
    return {"type": "revolute", "anchor": _anchor(pose), **held, **_turning_motor(pose.joint)}


def _prismatic(pose: Pose) -> Words:
    words: Words = {"type": "prismatic", "anchor": _on_axis(pose), "axis": tidy_point(pose.axis)}
    words |= _limits(pose, pose.slide, tidy) | _resting(pose, pose.slide, tidy)
    if abs(pose.angle) > _ASKEW:
        pose.note(_STAYS_TURNED, f"{degrees(pose.angle):.3g} degrees")
    if pose.joint.motor_speed is not None:
        words |= {"motor_speed": tidy(pose.joint.motor_speed), "max_force": tidy(pose.joint.max_motor)}
    return words


def _wheel(pose: Pose) -> Words:
    words: Words = {"type": "wheel", "anchor": _on_axis(pose), "axis": tidy_point(pose.axis)}
    words |= _limits(pose, pose.slide, tidy)
    spring = _spring_words(pose, _straight(pose))
    words |= spring or {"hertz": None}
    if spring and tidy(pose.slide):
        words["rest"] = tidy(-pose.slide)
    return words | _turning_motor(pose.joint)


def _distance(pose: Pose) -> Words:
    away = math.dist(pose.at_a, pose.at_b)
    words: Words = {"type": "distance", "anchors": [tidy_point(pose.at_a), tidy_point(pose.at_b)]}
    if not math.isclose(away, pose.joint.length, rel_tol=1e-6, abs_tol=1e-6):
        words["length"] = tidy(max(pose.joint.length, 0.0))
    if pose.joint.lower is not None and pose.joint.upper is not None:
        words |= {"min": tidy(pose.joint.lower), "max": tidy(pose.joint.upper)}
    return words | _spring_words(pose, _straight(pose))


def _rope(pose: Pose) -> Words:
    anchors = [tidy_point(pose.at_a), tidy_point(pose.at_b)]
    return {"type": "distance", "anchors": anchors, "max": tidy(max(pose.joint.length, 0.0))}


def _weld(pose: Pose) -> Words:
    if abs(pose.angle) > _ASKEW:
        pose.note(_STAYS_TURNED, f"{degrees(pose.angle):.3g} degrees")
    words: Words = {"type": "weld", "anchor": _anchor(pose)}
    spring = _spring_words(pose, sum(turning(body) for body in (pose.a, pose.b)))
    words |= {f"angular_{key}": value for key, value in spring.items()}
    # In Box2D 2 a soft weld gives way to turning only.
    place = pose.joint.linear_spring
    soft = {"hertz": tidy(place.hertz), "damping_ratio": tidy(place.damping_ratio)}
    return words | (soft if place.hertz > 0.0 else {})


def _friction(pose: Pose) -> Words:
    joint = pose.joint
    return {
        "type": "friction", "anchor": _anchor(pose),
        "max_force": tidy(joint.max_force), "max_torque": tidy(joint.max_torque),
    }  # fmt: skip


def _motor(pose: Pose) -> Words:
    joint, a, b = pose.joint, pose.a, pose.b
    x, y = in_world(a, joint.offset)
    hertz = tidy(max(joint.correction, 0.0) * 60.0 / (2.0 * math.pi))
    pose.note("a motor joint's correction factor is the stiffness of a critically damped spring")
    return {
        "type": "motor", "anchor": tidy_point(b.position),
        "offset": tidy_point((x - b.position[0], y - b.position[1])),
        "angle": degrees(joint.angle - (b.angle - a.angle)), "hertz": hertz, "angular_hertz": hertz,
        "max_force": tidy(joint.max_force), "max_torque": tidy(joint.max_torque),
    }  # fmt: skip


def _drive(pose: Pose) -> Words:
    """The motor joint of Box2D 3: springs that pull the two frames together."""
    joint, (ax, ay), (bx, by) = pose.joint, pose.at_a, pose.at_b
    return {
        "type": "motor", "anchor": tidy_point((bx, by)), "offset": tidy_point((ax - bx, ay - by)),
        "angle": degrees(-pose.angle), "hertz": tidy(joint.linear_spring.hertz),
        "damping_ratio": tidy(joint.linear_spring.damping_ratio), "angular_hertz": tidy(joint.spring.hertz),
        "angular_damping_ratio": tidy(joint.spring.damping_ratio),
        "max_force": tidy(joint.max_force), "max_torque": tidy(joint.max_torque),
    }  # fmt: skip


def _filter(pose: Pose) -> Words:
    """Keeps its bodies from colliding, and does nothing else: friction without force."""
    return {"type": "friction", "anchor": tidy_point(pose.at_b), "max_force": 0}


def _target(pose: Pose) -> Words:
    words: Words = {"type": "target", "anchor": tidy_point(pose.at_b), "target": tidy_point(pose.joint.target)}
    spring = _spring_words(pose, _straight(pose))
    return words | (spring or {"hertz": 0}) | {"max_force": tidy(pose.joint.max_force)}


def _pulley(pose: Pose) -> Words:
    joint = pose.joint
    stands = tuple(math.dist(wheel, end) for wheel, end in zip(joint.ground, (pose.at_a, pose.at_b), strict=True))
    if joint.lengths is not None:
        rope = joint.lengths[0] + joint.ratio * joint.lengths[1]
        if abs(stands[0] + joint.ratio * stands[1] - rope) > _APART:
            pose.note("the rope of a pulley is as long as it is at the start")
    anchors = [tidy_point(pose.at_a), tidy_point(pose.at_b)]
    wheels = [tidy_point(wheel) for wheel in joint.ground]
    return {"type": "pulley", "anchors": anchors, "wheels": wheels, "ratio": tidy(joint.ratio)}


_KINDS: dict[str, Callable[[Pose], Words]] = {
    "revolute": _revolute, "prismatic": _prismatic, "wheel": _wheel, "distance": _distance, "rope": _rope,
    "weld": _weld, "friction": _friction, "motor": _motor, "mouse": _target, "pulley": _pulley,
    "drive": _drive, "filter": _filter,
}  # fmt: skip


def _anchor(pose: Pose) -> list[float]:
    apart = math.dist(pose.at_a, pose.at_b)
    if apart > _APART:
        pose.note("its anchors stand apart: it holds where that of the second body is", f"{apart:.3g} m")
    return tidy_point(pose.at_b)


def _on_axis(pose: Pose) -> list[float]:
    (ax, ay), (bx, by), (x, y) = pose.at_a, pose.at_b, pose.axis
    beside = abs(x * (by - ay) - y * (bx - ax))
    if beside > _APART:
        text = "its anchors stand apart across the axis: it slides where that of the second body is"
        pose.note(text, f"{beside:.3g} m")
    return tidy_point(pose.at_b)


def _limits(pose: Pose, start: float, unit: Callable[[float], float]) -> Words:
    lower, upper = pose.joint.lower, pose.joint.upper
    if lower is None or upper is None:
        return {}
    if lower > upper:
        pose.note("its limits are left out: the lower one is greater than the upper one")
        return {}
    found = {"lower": lower, "upper": upper}
    return {key: unit(value - start) for key, value in found.items() if abs(value) < _BOUNDLESS}


def _resting(pose: Pose, start: float, unit: Callable[[float], float]) -> Words:
    """The spring of a hinge or slide."""
    joint, spring = pose.joint, pose.joint.spring
    if joint.rest is None or spring.hertz <= 0.0:
        return {}
    words: Words = {"hertz": tidy(spring.hertz), "damping_ratio": tidy(spring.damping_ratio)}
    return words | {"rest": unit(joint.rest - start)}


def _turning_motor(joint: Joint) -> Words:
    if joint.motor_speed is None:
        return {}
    return {"motor_speed": degrees(joint.motor_speed), "max_torque": tidy(max(joint.max_motor, 0.0))}


def _straight(pose: Pose) -> float:
    """How easily both bodies together are pushed, 1/kg."""
    return mobility(pose.a) + mobility(pose.b)


def _spring_words(pose: Pose, mobility: float) -> Words:
    """hertz and damping_ratio of a spring that acts on this mobility (1/kg or 1/(kg m^2)); nothing if it is rigid."""
    spring: Spring = pose.joint.spring
    hertz, ratio = spring.hertz, spring.damping_ratio
    if spring.stiffness > 0.0 and mobility > 0.0:
        omega = math.sqrt(spring.stiffness * mobility)
        hertz, ratio = omega / (2.0 * math.pi), spring.damping * mobility / (2.0 * omega)
    return {"hertz": tidy(hertz), "damping_ratio": tidy(max(ratio, 0.0))} if hertz > 0.0 else {}
