"""The calls that a recording of Box2D may hold: opcode, name, and arguments as `name:tag`.

Source: `src/recording_ops.inl` of Box2D, format 3.4. `made` is the id that a call returned. Queries have results behind
their arguments.
"""

from __future__ import annotations

from typing import NamedTuple

from sandbox.formats.b2rec.layouts import Fields, fields_of


class Op(NamedTuple):
    """A kind of call: its name in Box2D without `b2`, and its arguments."""

    name: str
    fields: Fields


_TABLE = """
01 DestroyWorld world:WORLDID
02 WorldEnableSleeping world:WORLDID flag:BOOL
03 WorldEnableContinuous world:WORLDID flag:BOOL
04 WorldSetRestitutionThreshold world:WORLDID value:F32
05 WorldSetHitEventThreshold world:WORLDID value:F32
06 WorldSetGravity world:WORLDID gravity:VEC2
07 WorldExplode world:WORLDID def:EXPLOSIONDEF
08 WorldSetContactTuning world:WORLDID hertz:F32 dampingRatio:F32 pushSpeed:F32
09 WorldSetContactRecycleDistance world:WORLDID recycleDistance:F32
0A WorldSetMaximumLinearSpeed world:WORLDID maximumLinearSpeed:F32
0B WorldEnableWarmStarting world:WORLDID flag:BOOL
0C WorldRebuildStaticTree world:WORLDID
0D WorldEnableSpeculative world:WORLDID flag:BOOL
10 CreateBody world:WORLDID def:BODYDEF made:BODYID
11 DestroyBody body:BODYID
20 BodySetTransform body:BODYID position:POSITION rotation:ROT
21 BodySetLinearVelocity body:BODYID v:VEC2
22 BodySetType body:BODYID type:I32
23 BodySetName body:BODYID name:STR
24 BodySetAngularVelocity body:BODYID w:F32
25 BodySetTargetTransform body:BODYID target:WORLDXF timeStep:F32 wake:BOOL
26 BodyApplyForce body:BODYID force:VEC2 point:POSITION wake:BOOL
27 BodyApplyForceToCenter body:BODYID force:VEC2 wake:BOOL
28 BodyApplyTorque body:BODYID torque:F32 wake:BOOL
29 BodyClearForces body:BODYID
2A BodyApplyLinearImpulse body:BODYID impulse:VEC2 point:POSITION wake:BOOL
2B BodyApplyLinearImpulseToCenter body:BODYID impulse:VEC2 wake:BOOL
2C BodyApplyAngularImpulse body:BODYID impulse:F32 wake:BOOL
2D BodySetMassData body:BODYID massData:MASSDATA
2E BodyApplyMassFromShapes body:BODYID
2F BodySetLinearDamping body:BODYID damping:F32
30 BodySetAngularDamping body:BODYID damping:F32
31 BodySetGravityScale body:BODYID scale:F32
32 BodySetAwake body:BODYID awake:BOOL
33 BodyWakeTouching body:BODYID
34 BodyEnableSleep body:BODYID flag:BOOL
35 BodySetSleepThreshold body:BODYID threshold:F32
36 BodyDisable body:BODYID
37 BodyEnable body:BODYID
38 BodySetMotionLocks body:BODYID locks:LOCKS
39 BodySetBullet body:BODYID flag:BOOL
3A BodyEnableContactRecycling body:BODYID flag:BOOL
3B BodyEnableContactEvents body:BODYID flag:BOOL
3C BodyEnableHitEvents body:BODYID flag:BOOL
3D BodySetSafetyFactor body:BODYID value:F32
40 CreateCircleShape body:BODYID def:SHAPEDEF circle:CIRCLE made:SHAPEID
41 CreateCapsuleShape body:BODYID def:SHAPEDEF capsule:CAPSULE made:SHAPEID
42 CreateSegmentShape body:BODYID def:SHAPEDEF segment:SEGMENT made:SHAPEID
43 CreatePolygonShape body:BODYID def:SHAPEDEF polygon:POLYGON made:SHAPEID
44 CreateChainSegmentShape body:BODYID def:SHAPEDEF chainSegment:CHAINSEG made:SHAPEID
45 DestroyShape shape:SHAPEID updateBodyMass:BOOL
50 ShapeSetDensity shape:SHAPEID density:F32 updateBodyMass:BOOL
51 ShapeSetFriction shape:SHAPEID friction:F32
52 ShapeSetRestitution shape:SHAPEID restitution:F32
53 ShapeSetUserMaterial shape:SHAPEID material:U64
54 ShapeSetSurfaceMaterial shape:SHAPEID material:MATERIAL
55 ShapeSetFilter shape:SHAPEID filter:FILTER
56 ShapeEnableSensorEvents shape:SHAPEID flag:BOOL
57 ShapeEnableContactEvents shape:SHAPEID flag:BOOL
58 ShapeEnablePreSolveEvents shape:SHAPEID flag:BOOL
59 ShapeEnableHitEvents shape:SHAPEID flag:BOOL
5A ShapeSetCircle shape:SHAPEID circle:CIRCLE
5B ShapeSetCapsule shape:SHAPEID capsule:CAPSULE
5C ShapeSetSegment shape:SHAPEID segment:SEGMENT
5D ShapeSetPolygon shape:SHAPEID polygon:POLYGON
5E ShapeSetChainSegment shape:SHAPEID chainSegment:CHAINSEG
5F ShapeApplyWind shape:SHAPEID wind:VEC2 drag:F32 lift:F32 wake:BOOL
70 CreateChain body:BODYID def:CHAINDEF made:CHAINID
71 DestroyChain chain:CHAINID
72 ChainSetSurfaceMaterial chain:CHAINID material:MATERIAL materialIndex:I32
80 Step world:WORLDID dt:F32 subStepCount:I32
90 DestroyJoint joint:JOINTID
91 JointSetLocalFrameA joint:JOINTID localFrame:XF
92 JointSetLocalFrameB joint:JOINTID localFrame:XF
93 JointSetCollideConnected joint:JOINTID shouldCollide:BOOL
94 JointWakeBodies joint:JOINTID
95 JointSetConstraintTuning joint:JOINTID hertz:F32 dampingRatio:F32
96 JointSetForceThreshold joint:JOINTID threshold:F32
97 JointSetTorqueThreshold joint:JOINTID threshold:F32
98 CreateDistanceJoint world:WORLDID def:DISTANCEJOINTDEF made:JOINTID
99 DistanceJointSetLength joint:JOINTID length:F32
9A DistanceJointEnableSpring joint:JOINTID enableSpring:BOOL
9B DistanceJointSetSpringForceRange joint:JOINTID lowerForce:F32 upperForce:F32
9C DistanceJointSetSpringHertz joint:JOINTID hertz:F32
9D DistanceJointSetSpringDampingRatio joint:JOINTID dampingRatio:F32
9E DistanceJointEnableLimit joint:JOINTID enableLimit:BOOL
9F DistanceJointSetLengthRange joint:JOINTID minLength:F32 maxLength:F32
A0 DistanceJointEnableMotor joint:JOINTID enableMotor:BOOL
A1 DistanceJointSetMotorSpeed joint:JOINTID motorSpeed:F32
A2 DistanceJointSetMaxMotorForce joint:JOINTID force:F32
A3 CreateFilterJoint world:WORLDID def:FILTERJOINTDEF made:JOINTID
A4 CreateMotorJoint world:WORLDID def:MOTORJOINTDEF made:JOINTID
A5 MotorJointSetLinearVelocity joint:JOINTID velocity:VEC2
A6 MotorJointSetAngularVelocity joint:JOINTID velocity:F32
A7 MotorJointSetMaxVelocityForce joint:JOINTID maxForce:F32
A8 MotorJointSetMaxVelocityTorque joint:JOINTID maxTorque:F32
A9 MotorJointSetLinearHertz joint:JOINTID hertz:F32
AA MotorJointSetLinearDampingRatio joint:JOINTID damping:F32
AB MotorJointSetAngularHertz joint:JOINTID hertz:F32
AC MotorJointSetAngularDampingRatio joint:JOINTID damping:F32
AD MotorJointSetMaxSpringForce joint:JOINTID maxForce:F32
AE MotorJointSetMaxSpringTorque joint:JOINTID maxTorque:F32
AF CreateMoverJoint world:WORLDID def:MOVERJOINTDEF made:JOINTID
B0 MoverJointSetLinearVelocity joint:JOINTID velocity:VEC2
B1 MoverJointSetMaxVelocityForce joint:JOINTID maxForce:VEC2
B2 CreatePogoJoint world:WORLDID def:POGOJOINTDEF made:JOINTID
B3 PogoJointSetRestLength joint:JOINTID length:F32
B4 PogoJointSetSpringHertz joint:JOINTID hertz:F32
B5 PogoJointSetSpringDampingRatio joint:JOINTID dampingRatio:F32
B6 CreatePrismaticJoint world:WORLDID def:PRISMATICJOINTDEF made:JOINTID
B7 PrismaticJointEnableSpring joint:JOINTID enableSpring:BOOL
B8 PrismaticJointSetSpringHertz joint:JOINTID hertz:F32
B9 PrismaticJointSetSpringDampingRatio joint:JOINTID dampingRatio:F32
BA PrismaticJointSetTargetTranslation joint:JOINTID translation:F32
BB PrismaticJointEnableLimit joint:JOINTID enableLimit:BOOL
BC PrismaticJointSetLimits joint:JOINTID lower:F32 upper:F32
BD PrismaticJointEnableMotor joint:JOINTID enableMotor:BOOL
BE PrismaticJointSetMotorSpeed joint:JOINTID motorSpeed:F32
BF PrismaticJointSetMaxMotorForce joint:JOINTID force:F32
C0 CreateRevoluteJoint world:WORLDID def:REVOLUTEJOINTDEF made:JOINTID
C1 RevoluteJointEnableSpring joint:JOINTID enableSpring:BOOL
C2 RevoluteJointSetSpringHertz joint:JOINTID hertz:F32
C3 RevoluteJointSetSpringDampingRatio joint:JOINTID dampingRatio:F32
C4 RevoluteJointSetTargetAngle joint:JOINTID angle:F32
C5 RevoluteJointEnableLimit joint:JOINTID enableLimit:BOOL
C6 RevoluteJointSetLimits joint:JOINTID lower:F32 upper:F32
C7 RevoluteJointEnableMotor joint:JOINTID enableMotor:BOOL
C8 RevoluteJointSetMotorSpeed joint:JOINTID motorSpeed:F32
C9 RevoluteJointSetMaxMotorTorque joint:JOINTID torque:F32
CA CreateWeldJoint world:WORLDID def:WELDJOINTDEF made:JOINTID
CB WeldJointSetLinearHertz joint:JOINTID hertz:F32
CC WeldJointSetLinearDampingRatio joint:JOINTID dampingRatio:F32
CD WeldJointSetAngularHertz joint:JOINTID hertz:F32
CE WeldJointSetAngularDampingRatio joint:JOINTID dampingRatio:F32
CF CreateWheelJoint world:WORLDID def:WHEELJOINTDEF made:JOINTID
D0 WheelJointEnableSpring joint:JOINTID enableSpring:BOOL
D1 WheelJointSetSpringHertz joint:JOINTID hertz:F32
D2 WheelJointSetSpringDampingRatio joint:JOINTID dampingRatio:F32
D3 WheelJointEnableLimit joint:JOINTID enableLimit:BOOL
D4 WheelJointSetLimits joint:JOINTID lower:F32 upper:F32
D5 WheelJointEnableMotor joint:JOINTID enableMotor:BOOL
D6 WheelJointSetMotorSpeed joint:JOINTID motorSpeed:F32
D7 WheelJointSetMaxMotorTorque joint:JOINTID torque:F32
E0 QueryOverlapAABB world:WORLDID origin:POSITION aabb:AABB filter:QUERYFILTER
E1 QueryOverlapShape world:WORLDID origin:POSITION proxy:SHAPEPROXY filter:QUERYFILTER
E2 QueryCastRay world:WORLDID origin:POSITION translation:VEC2 filter:QUERYFILTER
E3 QueryCastShape world:WORLDID origin:POSITION proxy:SHAPEPROXY
E4 QueryCollideMover world:WORLDID origin:POSITION mover:CAPSULE filter:QUERYFILTER
E5 QueryCastRayClosest world:WORLDID origin:POSITION translation:VEC2 filter:QUERYFILTER
E6 QueryCastMover world:WORLDID origin:POSITION mover:CAPSULE
E7 ShapeTestPoint shape:SHAPEID point:POSITION
E8 ShapeRayCast shape:SHAPEID origin:POSITION translation:VEC2
F1 StateHash world:WORLDID hash:U64
F2 RecordingBounds bounds:AABB
"""


def _parsed() -> dict[int, Op]:
    rows = (line.split(" ", 2) for line in _TABLE.strip().splitlines())
    return {int(code, 16): Op(name, fields_of(arguments)) for code, name, arguments in rows}


OPS = _parsed()
"""By opcode."""
