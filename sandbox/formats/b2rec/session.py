"""What a recording has made by the time of its first step: bodies, shapes, chains and joints, by their ids in it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from sandbox.formats.b2rec.calls import Call
from sandbox.formats.reading import MisreadError

Values = dict[str, Any]


@dataclass
class Made:
    """Something that was made: what it is, its definition as it is now, and the body that it is on."""

    kind: str
    values: Values
    body: int = 0


@dataclass
class Session:
    """The world as far as it has been made; `unused` counts calls before the first step that are not taken over."""

    settings: Values
    bodies: dict[int, Made] = field(default_factory=dict)
    shapes: dict[int, Made] = field(default_factory=dict)
    chains: dict[int, Made] = field(default_factory=dict)
    joints: dict[int, Made] = field(default_factory=dict)
    unused: Counter[str] = field(default_factory=Counter)

    def apply(self, call: Call) -> None:
        """Do what the call did. Raises `MisreadError` if it speaks of what is not there."""
        action = _ACTIONS.get(call.name)
        if action is not None:
            action(self, call)
        elif call.name.startswith("Create") and "def" in call.arguments:
            self._create(call)
        elif not self._set(call):
            self.unused[call.name] += 1

    def _create(self, call: Call) -> None:
        name, given = call.name.removeprefix("Create"), call.arguments
        if name == "Body":
            self.bodies[given["made"]] = Made(name, given["def"])
        elif name.endswith("Joint"):
            for end in ("bodyA", "bodyB"):
                _known(self.bodies, given["def"][end], call)
            self.joints[given["made"]] = Made(name.removesuffix("Joint").lower(), given["def"])
        else:
            _known(self.bodies, given["body"], call)
            kind = name.removesuffix("Shape").lower()
            geometry = {"geometry": given.get(_argument(kind))}
            material = given["def"].get("material", {})
            things = self.chains if kind == "chain" else self.shapes
            things[given["made"]] = Made(kind, given["def"] | material | geometry, given["body"])

    def _set(self, call: Call) -> bool:
        """Whether the call sets fields of a definition: its arguments are named as they are, or renamed below."""
        for subject, things in (("body", self.bodies), ("shape", self.shapes), ("joint", self.joints)):
            if subject in call.arguments and call.name not in _IGNORED:
                given = {key: value for key, value in call.arguments.items() if key != subject}
                if call.name in _RENAMED:
                    given = dict(zip(_RENAMED[call.name], list(call.arguments.values())[1:], strict=True))
                if call.name == "ShapeSetSurfaceMaterial":
                    given = given["material"]
                made = _known(things, call.arguments[subject], call)
                if not given.keys() <= made.values.keys():
                    return False
                made.values.update(given)
                if call.name in ("BodySetLinearVelocity", "BodySetAngularVelocity"):
                    made.values["ofCenter"] = True  # setters speak of the centre of mass, definitions of the origin
                return True
        return False

    def destroy_body(self, call: Call) -> None:
        """With all that is on it."""
        body = call.arguments["body"]
        _known(self.bodies, body, call)
        del self.bodies[body]
        self.shapes, self.chains = (
            {key: made for key, made in things.items() if made.body != body} for things in (self.shapes, self.chains)
        )
        ends = ("bodyA", "bodyB")
        self.joints = {key: made for key, made in self.joints.items() if body not in map(made.values.get, ends)}


def _known(things: dict[int, Made], key: int, call: Call) -> Made:
    if key not in things:
        raise MisreadError((), f"{call.name} speaks of what was never made (at byte {call.at})")
    return things[key]


def _argument(kind: str) -> str:
    return "chainSegment" if kind == "chainsegment" else kind


def _destroy_shape(session: Session, call: Call) -> None:
    session.shapes.pop(call.arguments["shape"], None)


def _destroy_chain(session: Session, call: Call) -> None:
    session.chains.pop(call.arguments["chain"], None)


def _destroy_joint(session: Session, call: Call) -> None:
    session.joints.pop(call.arguments["joint"], None)


def _setting(*names: str) -> Callable[[Session, Call], None]:
    def act(session: Session, call: Call) -> None:
        session.settings.update(zip(names, list(call.arguments.values())[1:], strict=True))

    return act


def _reshape(session: Session, call: Call) -> None:
    made = _known(session.shapes, call.arguments["shape"], call)
    made.kind = call.name.removeprefix("ShapeSet").lower()
    made.values["geometry"] = call.arguments[_argument(made.kind)]


def _mass(session: Session, call: Call) -> None:
    _known(session.bodies, call.arguments["body"], call).values["massData"] = call.arguments.get("massData")


def _enable(session: Session, call: Call) -> None:
    _known(session.bodies, call.arguments["body"], call).values["isEnabled"] = call.name == "BodyEnable"


def _nothing(session: Session, call: Call) -> None:
    """The scene has no such thing, and looks the same without it."""


_ACTIONS: dict[str, Callable[[Session, Call], None]] = {
    "DestroyBody": Session.destroy_body, "DestroyShape": _destroy_shape, "DestroyChain": _destroy_chain,
    "DestroyJoint": _destroy_joint, "BodySetMassData": _mass, "BodyDisable": _enable, "BodyEnable": _enable,
    "BodyApplyMassFromShapes": _mass,
    "WorldSetGravity": _setting("gravity"), "WorldEnableSleeping": _setting("sleeping"),
    "WorldSetRestitutionThreshold": _setting("restitutionThreshold"),
    "WorldEnableWarmStarting": _setting("warmStarting"), "WorldEnableSpeculative": _setting("speculative"),
    "WorldSetContactTuning": _setting("contactHertz", "contactDampingRatio", "contactSpeed"),
    "ShapeSetCircle": _reshape, "ShapeSetCapsule": _reshape, "ShapeSetSegment": _reshape, "ShapeSetPolygon": _reshape,
} | dict.fromkeys(
    ("WorldRebuildStaticTree", "WorldSetHitEventThreshold", "WorldSetContactRecycleDistance", "BodyWakeTouching",
     "JointWakeBodies", "BodyClearForces", "ShapeSetUserMaterial", "ShapeEnableSensorEvents", "BodyEnableHitEvents",
     "ShapeEnableContactEvents", "ShapeEnablePreSolveEvents", "ShapeEnableHitEvents", "BodyEnableContactEvents",
     "BodyEnableContactRecycling", "JointSetForceThreshold", "JointSetTorqueThreshold"), _nothing
)  # fmt: skip

_IGNORED = ("BodySetTargetTransform",)
_RENAMED: dict[str, tuple[str, ...]] = {
    "BodySetLinearVelocity": ("linearVelocity",), "BodySetAngularVelocity": ("angularVelocity",),
    "BodySetLinearDamping": ("linearDamping",), "BodySetAngularDamping": ("angularDamping",),
    "BodySetGravityScale": ("gravityScale",), "BodySetSleepThreshold": ("sleepThreshold",),
    "BodySetAwake": ("isAwake",), "BodySetBullet": ("isBullet",), "BodyEnableSleep": ("enableSleep",),
    "BodySetMotionLocks": ("motionLocks",), "BodySetSafetyFactor": ("safetyFactor",),
    "JointSetLocalFrameA": ("localFrameA",), "JointSetLocalFrameB": ("localFrameB",),
    "JointSetCollideConnected": ("collideConnected",),
    "JointSetConstraintTuning": ("constraintHertz", "constraintDampingRatio"),
    "DistanceJointSetSpringForceRange": ("lowerSpringForce", "upperSpringForce"),
    "DistanceJointSetMaxMotorForce": ("maxMotorForce",), "PrismaticJointSetMaxMotorForce": ("maxMotorForce",),
    "MotorJointSetLinearVelocity": ("linearVelocity",), "MotorJointSetAngularVelocity": ("angularVelocity",),
    "MotorJointSetMaxVelocityForce": ("maxVelocityForce",), "MotorJointSetMaxVelocityTorque": ("maxVelocityTorque",),
    "MotorJointSetLinearHertz": ("linearHertz",), "MotorJointSetLinearDampingRatio": ("linearDampingRatio",),
    "MotorJointSetAngularHertz": ("angularHertz",), "MotorJointSetAngularDampingRatio": ("angularDampingRatio",),
    "MotorJointSetMaxSpringForce": ("maxSpringForce",), "MotorJointSetMaxSpringTorque": ("maxSpringTorque",),
    "PrismaticJointSetTargetTranslation": ("targetTranslation",), "RevoluteJointSetTargetAngle": ("targetAngle",),
    "PrismaticJointSetLimits": ("lowerTranslation", "upperTranslation"),
    "WheelJointSetLimits": ("lowerTranslation", "upperTranslation"),
    "RevoluteJointSetLimits": ("lowerAngle", "upperAngle"),
    "RevoluteJointSetMaxMotorTorque": ("maxMotorTorque",), "WheelJointSetMaxMotorTorque": ("maxMotorTorque",),
    "WeldJointSetLinearHertz": ("linearHertz",), "WeldJointSetLinearDampingRatio": ("linearDampingRatio",),
    "WeldJointSetAngularHertz": ("angularHertz",), "WeldJointSetAngularDampingRatio": ("angularDampingRatio",),
}  # fmt: skip
