"""How values stand in a recording of Box2D: fields of each structure in their order, as `name:tag`.

Source: the functions `b2RecW_...` in `src/recording.c` of Box2D, format 3.4; little-endian, without padding. Shapes are
images of the structures in `collision.h`.
"""

from __future__ import annotations

Fields = tuple[tuple[str, str], ...]
"""Name and tag of each field; a tag is a primitive, or a structure of `LAYOUTS`."""

PRIMITIVES = {
    "BOOL": "?", "U8": "B", "U16": "H", "U32": "I", "U64": "Q", "I32": "i", "F32": "f", "F64": "d",
    "WORLDID": "I", "BODYID": "Q", "SHAPEID": "Q", "CHAINID": "Q", "JOINTID": "Q",
    "VEC2": "2f", "ROT": "2f", "POLYPOINTS": "16f",
}  # fmt: skip
"""As `struct` writes them. A rotation is cosine and sine."""

_BASE = (
    "userData:U64 bodyA:BODYID bodyB:BODYID localFrameA:XF localFrameB:XF forceThreshold:F32 torqueThreshold:F32 "
    "constraintHertz:F32 constraintDampingRatio:F32 drawScale:F32 collideConnected:BOOL "
)
_SPRING = "enableSpring:BOOL hertz:F32 dampingRatio:F32 "
_SLIDE = "enableLimit:BOOL lowerTranslation:F32 upperTranslation:F32 enableMotor:BOOL "

_STRUCTURES = {
    "XF": "p:VEC2 q:ROT",
    "WORLDXF": "p:POSITION q:ROT",
    "AABB": "lowerBound:VEC2 upperBound:VEC2",
    "CIRCLE": "center:VEC2 radius:F32",
    "CAPSULE": "center1:VEC2 center2:VEC2 radius:F32",
    "SEGMENT": "point1:VEC2 point2:VEC2",
    "POLYGON": "vertices:POLYPOINTS normals:POLYPOINTS centroid:VEC2 radius:F32 count:I32",
    "CHAINSEG": "ghost1:VEC2 point1:VEC2 point2:VEC2 ghost2:VEC2 chainId:I32",
    "FILTER": "categoryBits:U64 maskBits:U64 groupIndex:I32",
    "MATERIAL": (
        "friction:F32 restitution:F32 rollingResistance:F32 tangentSpeed:F32 userMaterialId:U64 customColor:U32"
    ),
    "MASSDATA": "mass:F32 center:VEC2 rotationalInertia:F32",
    "LOCKS": "linearX:BOOL linearY:BOOL angularZ:BOOL",
    "EXPLOSIONDEF": "maskBits:U64 position:POSITION radius:F32 falloff:F32 impulsePerLength:F32",
    "BODYDEF": (
        "type:I32 position:POSITION rotation:ROT linearVelocity:VEC2 angularVelocity:F32 linearDamping:F32 "
        "angularDamping:F32 gravityScale:F32 sleepThreshold:F32 safetyFactor:F32 name:STR userData:U64 "
        "motionLocks:LOCKS enableSleep:BOOL isAwake:BOOL isBullet:BOOL isEnabled:BOOL allowFastRotation:BOOL "
        "enableContactRecycling:BOOL"
    ),
    "SHAPEDEF": (
        "userData:U64 material:MATERIAL density:F32 filter:FILTER enableCustomFiltering:BOOL isSensor:BOOL "
        "enableSensorEvents:BOOL enableContactEvents:BOOL enableHitEvents:BOOL enablePreSolveEvents:BOOL "
        "invokeContactCreation:BOOL updateBodyMass:BOOL"
    ),
    "CHAINDEF": (
        "userData:U64 points:LIST-VEC2 materials:LIST-MATERIAL filter:FILTER isLoop:BOOL enableSensorEvents:BOOL"
    ),
    "DISTANCEJOINTDEF": _BASE + (
        "length:F32 enableSpring:BOOL lowerSpringForce:F32 upperSpringForce:F32 hertz:F32 dampingRatio:F32 "
        "enableLimit:BOOL minLength:F32 maxLength:F32 enableMotor:BOOL maxMotorForce:F32 motorSpeed:F32"
    ),
    "FILTERJOINTDEF": _BASE,
    "MOTORJOINTDEF": _BASE + (
        "linearVelocity:VEC2 maxVelocityForce:F32 angularVelocity:F32 maxVelocityTorque:F32 linearHertz:F32 "
        "linearDampingRatio:F32 maxSpringForce:F32 angularHertz:F32 angularDampingRatio:F32 maxSpringTorque:F32"
    ),
    "MOVERJOINTDEF": _BASE + "linearVelocity:VEC2 maxVelocityForce:VEC2",
    "POGOJOINTDEF": _BASE + (
        "normal:VEC2 hertz:F32 dampingRatio:F32 restLength:F32 maxTensionForce:F32 maxCompressionForce:F32 "
        "impulse:F32 velocity:F32"
    ),
    "PRISMATICJOINTDEF": _BASE + _SPRING + "targetTranslation:F32 " + _SLIDE + "maxMotorForce:F32 motorSpeed:F32",
    "REVOLUTEJOINTDEF": _BASE + "targetAngle:F32 " + _SPRING + (
        "enableLimit:BOOL lowerAngle:F32 upperAngle:F32 enableMotor:BOOL maxMotorTorque:F32 motorSpeed:F32"
    ),
    "WELDJOINTDEF": _BASE + "linearHertz:F32 angularHertz:F32 linearDampingRatio:F32 angularDampingRatio:F32",
    "WHEELJOINTDEF": _BASE + _SPRING + _SLIDE + "maxMotorTorque:F32 motorSpeed:F32",
}  # fmt: skip


def fields_of(text: str) -> Fields:
    """A table row as fields."""
    pairs = (each.partition(":") for each in text.split())
    return tuple((name, tag) for name, _, tag in pairs)


LAYOUTS = {tag: fields_of(text) for tag, text in _STRUCTURES.items()}
"""Fields of each structure."""
