"""What an author writes: the models of a scene file, loading, checking, and the flat form for a world.

The models speak as a file does: their fields are a file's keys, and their angles are in degrees.
"""

from sandbox.scene.body import Body
from sandbox.scene.expect import (
    Above,
    Apart,
    Asleep,
    Below,
    CounterIs,
    Ended,
    Inside,
    Near,
    Rests,
    Senses,
    Speeding,
    Stands,
    Touches,
    Turned,
)
from sandbox.scene.flat import FlatBody, FlatScene, FlatSettings, FlatShape
from sandbox.scene.generators import Chain, Grid, Place, Pyramid, Row, Scatter, Stack
from sandbox.scene.joints.drives import Friction, Motor, Target
from sandbox.scene.joints.gear import Gear
from sandbox.scene.joints.revolute import Revolute, Weld
from sandbox.scene.joints.ropes import DistanceJoint, Pulley
from sandbox.scene.joints.slides import Prismatic, Wheel
from sandbox.scene.load import load_scene, loads_scene
from sandbox.scene.material import Material
from sandbox.scene.play.actions import (
    Blast,
    BreakJoints,
    ChangeGravity,
    Count,
    DeleteBodies,
    Lose,
    MoveAt,
    PushOnce,
    PushStep,
    PutBodies,
    SpawnBody,
    Win,
)
from sandbox.scene.play.control import InputControl
from sandbox.scene.play.path import BodyPath
from sandbox.scene.play.rule import Condition, Rule
from sandbox.scene.play.setting_actions import ChangeJoint, ChangeRegion, RunPath, SetBodySurface, SwitchThruster
from sandbox.scene.play.triggers import (
    OnBegin,
    OnCount,
    OnEnd,
    OnEnter,
    OnEvery,
    OnHit,
    OnJointBreak,
    OnLeave,
    OnPress,
    OnTime,
)
from sandbox.scene.prefab import Prefab
from sandbox.scene.regions import Attraction, Gravity, GravityScale, Water, Wind
from sandbox.scene.scene import Scene
from sandbox.scene.schema import schema
from sandbox.scene.settings import Settings, View
from sandbox.scene.shapes import BoxShape, CapsuleShape, ChainShape, CircleShape, PolygonShape, SegmentShape
from sandbox.scene.thruster import Thruster

__all__ = [
    "Above",
    "Apart",
    "Asleep",
    "Attraction",
    "Below",
    "Blast",
    "Body",
    "BodyPath",
    "BoxShape",
    "BreakJoints",
    "CapsuleShape",
    "Chain",
    "ChainShape",
    "ChangeGravity",
    "ChangeJoint",
    "ChangeRegion",
    "CircleShape",
    "Condition",
    "Count",
    "CounterIs",
    "DeleteBodies",
    "DistanceJoint",
    "Ended",
    "FlatBody",
    "FlatScene",
    "FlatSettings",
    "FlatShape",
    "Friction",
    "Gear",
    "Gravity",
    "GravityScale",
    "Grid",
    "InputControl",
    "Inside",
    "Lose",
    "Material",
    "Motor",
    "MoveAt",
    "Near",
    "OnBegin",
    "OnCount",
    "OnEnd",
    "OnEnter",
    "OnEvery",
    "OnHit",
    "OnJointBreak",
    "OnLeave",
    "OnPress",
    "OnTime",
    "Place",
    "PolygonShape",
    "Prefab",
    "Prismatic",
    "Pulley",
    "PushOnce",
    "PushStep",
    "PutBodies",
    "Pyramid",
    "Rests",
    "Revolute",
    "Row",
    "Rule",
    "RunPath",
    "Scatter",
    "Scene",
    "SegmentShape",
    "Senses",
    "SetBodySurface",
    "Settings",
    "SpawnBody",
    "Speeding",
    "Stack",
    "Stands",
    "SwitchThruster",
    "Target",
    "Thruster",
    "Touches",
    "Turned",
    "View",
    "Water",
    "Weld",
    "Wheel",
    "Win",
    "Wind",
    "load_scene",
    "loads_scene",
    "schema",
]
