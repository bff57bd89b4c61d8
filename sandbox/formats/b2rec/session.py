"""What a recording has made by the time of its first step: bodies, shapes, chains and joints, by their ids in it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

from sandbox.formats.b2rec.calls import Call
from sandbox.formats.b2rec.made import Made, Values
from sandbox.formats.b2rec.weight import center_of, move_center, push
from sandbox.formats.reading import MisreadError


@dataclass
class Session:
    """The world as far as it has been made; `unused` counts calls before the first step that are not taken over."""

    settings: Values
    bodies: dict[int, Made] = field(default_factory=dict)
    shapes: dict[int, Made] = field(default_factory=dict)
    chains: dict[int, Made] = field(default_factory=dict)
    joints: dict[int, Made] = field(default_factory=dict)
    unused: Counter[str] = field(default_factory=Counter)
    forces: list[tuple[int, Values]] = field(default_factory=list)
    """What pushes bodies during the first step."""

    def on(self, body: int) -> list[Made]:
        """The shapes and chains of a body."""
        return [each for things in (self.shapes, self.chains) for each in things.values() if each.body == body]

    def weighing(self, body: int, change: Callable[[], object]) -> None:
        """Do what changes the mass of a body: that is then the mass of its shapes again."""
        made = self.bodies[body]
        before = center_of(made, self.on(body)) if made.values["angularVelocity"] else None
        change()
        made.values["massData"] = None
        if before is not None:
            move_center(made, before, center_of(made, self.on(body)))

    def finish(self, seconds: float) -> None:
        """What is left to do at the first step, which lasts so long: forces act on bodies during it."""
        for body, force in self.forces:
            if body in self.bodies:
                x, y = force.get("force", (0.0, 0.0))
                impulse, turn = (x * seconds, y * seconds), force.get("torque", 0.0) * seconds
                push(self.bodies[body], self.on(body), impulse, force.get("point"), turn)
        self.forces = []

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
            made = Made(kind, given["def"] | material | geometry, given["body"])
            self.weighing(given["body"], lambda: things.update({given["made"]: made}))

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
                update = partial(made.values.update, given)
                if call.name in _WEIGHING:
                    self.weighing(call.arguments.get("body", made.body), update)
                else:
                    update()
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
    made = _known(session.shapes, call.arguments["shape"], call)
    session.weighing(made.body, lambda: session.shapes.pop(call.arguments["shape"]))


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


def _set_mass(session: Session, call: Call) -> None:
    _known(session.bodies, call.arguments["body"], call).values["massData"] = call.arguments["massData"]


def _weigh_anew(session: Session, call: Call) -> None:
    made = _known(session.bodies, call.arguments["body"], call)
    session.weighing(call.arguments["body"], lambda: made.values.update(massData=None))


def _push(session: Session, call: Call) -> None:
    body, given = call.arguments["body"], call.arguments
    made, impulse = _known(session.bodies, body, call), given["impulse"]
    if call.name == "BodyApplyAngularImpulse":
        push(made, session.on(body), (0.0, 0.0), turn=impulse)
    else:
        push(made, session.on(body), impulse, given.get("point"))


def _force(session: Session, call: Call) -> None:
    _known(session.bodies, call.arguments["body"], call)
    session.forces.append((call.arguments["body"], call.arguments))


def _clear_forces(session: Session, call: Call) -> None:
    session.forces = [each for each in session.forces if each[0] != call.arguments["body"]]


def _surface_of_chain(session: Session, call: Call) -> None:
    made, index = _known(session.chains, call.arguments["chain"], call), call.arguments["materialIndex"]
    materials = made.values["materials"]
    if not 0 <= index < len(materials):
        raise MisreadError((), f"{call.name} speaks of a material that the chain does not have (at byte {call.at})")
    made.values["materials"] = [*materials[:index], call.arguments["material"], *materials[index + 1 :]]


def _enable(session: Session, call: Call) -> None:
    _known(session.bodies, call.arguments["body"], call).values["isEnabled"] = call.name == "BodyEnable"


def _nothing(session: Session, call: Call) -> None:
    """The scene has no such thing, and looks the same without it."""


_ACTIONS: dict[str, Callable[[Session, Call], None]] = {
    "DestroyBody": Session.destroy_body, "DestroyShape": _destroy_shape, "DestroyChain": _destroy_chain,
    "DestroyJoint": _destroy_joint, "BodySetMassData": _set_mass, "BodyDisable": _enable, "BodyEnable": _enable,
    "BodyApplyMassFromShapes": _weigh_anew, "ChainSetSurfaceMaterial": _surface_of_chain,
    "BodyApplyLinearImpulse": _push, "BodyApplyLinearImpulseToCenter": _push, "BodyApplyAngularImpulse": _push,
    "BodyApplyForce": _force, "BodyApplyForceToCenter": _force, "BodyApplyTorque": _force,
    "BodyClearForces": _clear_forces,
    "WorldSetGravity": _setting("gravity"), "WorldEnableSleeping": _setting("sleeping"),
    "WorldSetRestitutionThreshold": _setting("restitutionThreshold"),
    "WorldEnableWarmStarting": _setting("warmStarting"), "WorldEnableSpeculative": _setting("speculative"),
    "WorldSetContactTuning": _setting("contactHertz", "contactDampingRatio", "contactSpeed"),
    "ShapeSetCircle": _reshape, "ShapeSetCapsule": _reshape, "ShapeSetSegment": _reshape, "ShapeSetPolygon": _reshape,
    "ShapeSetChainSegment": _reshape,
} | dict.fromkeys(
    ("WorldRebuildStaticTree", "WorldSetHitEventThreshold", "WorldSetContactRecycleDistance", "BodyWakeTouching",
     "JointWakeBodies", "ShapeSetUserMaterial", "ShapeEnableSensorEvents", "BodyEnableHitEvents",
     "ShapeEnableContactEvents", "ShapeEnablePreSolveEvents", "ShapeEnableHitEvents", "BodyEnableContactEvents",
     "BodyEnableContactRecycling", "JointSetForceThreshold", "JointSetTorqueThreshold"), _nothing
)  # fmt: skip

_WEIGHING = ("BodySetType", "ShapeSetDensity")
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
