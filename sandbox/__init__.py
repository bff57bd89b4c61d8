"""A deterministic 2D physics sandbox.

    import sandbox

    world = sandbox.World(sandbox.load_scene("crates.scene.json"))
    world.step(300)
    print(world.body("crate").position, world.digest())

Each public name has one import path, this one, and means one thing. Names are imported on first use (PEP 562), so
`import sandbox` itself costs nothing.

Units are SI. Angles are in radians wherever Python is spoken: worlds, bodies, joints, commands, shapes, queries. What
is written in the words of a scene file has a file's degrees: the models of scenes (`Scene`, `Body`, `BoxShape`,
`Revolute`, `Water`, `Rests` and all others of `sandbox.scene`) and the entries that `Spawn` takes.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from sandbox._names import HOMES
from sandbox._version import __version__
from sandbox.notebook import render_with

if TYPE_CHECKING:
    from sandbox.batch.batch import Batch as Batch
    from sandbox.engine.commands.base import Command as Command
    from sandbox.engine.commands.control import Control as Control
    from sandbox.engine.commands.delete import Delete as Delete
    from sandbox.engine.commands.delete import DeleteJoint as DeleteJoint
    from sandbox.engine.commands.delete import DeleteRegion as DeleteRegion
    from sandbox.engine.commands.drags import EndDrag as EndDrag
    from sandbox.engine.commands.drags import MoveDrag as MoveDrag
    from sandbox.engine.commands.drags import StartDrag as StartDrag
    from sandbox.engine.commands.explode import Explode as Explode
    from sandbox.engine.commands.joint_parts import BreakJoint as BreakJoint
    from sandbox.engine.commands.joint_parts import SetLimits as SetLimits
    from sandbox.engine.commands.joint_parts import SetMotor as SetMotor
    from sandbox.engine.commands.joint_parts import SetSpring as SetSpring
    from sandbox.engine.commands.joint_parts import SetTarget as SetTarget
    from sandbox.engine.commands.motion import SetPose as SetPose
    from sandbox.engine.commands.motion import SetVelocity as SetVelocity
    from sandbox.engine.commands.pushes import ApplyForce as ApplyForce
    from sandbox.engine.commands.pushes import ApplyImpulse as ApplyImpulse
    from sandbox.engine.commands.set_gravity import SetGravity as SetGravity
    from sandbox.engine.commands.set_joint import SetJoint as SetJoint
    from sandbox.engine.commands.set_path import SetPath as SetPath
    from sandbox.engine.commands.set_region import SetRegion as SetRegion
    from sandbox.engine.commands.set_settings import SetSettings as SetSettings
    from sandbox.engine.commands.set_surface import SetSurface as SetSurface
    from sandbox.engine.commands.set_thruster import SetThruster as SetThruster
    from sandbox.engine.commands.spawn import Spawn as Spawn
    from sandbox.engine.events.events import Events as Events
    from sandbox.engine.queries.filter import Filter as Filter
    from sandbox.engine.queries.queries import Queries as Queries
    from sandbox.engine.queries.results import BodyDistance as BodyDistance
    from sandbox.engine.queries.results import CastHit as CastHit
    from sandbox.engine.queries.results import Overlap as Overlap
    from sandbox.engine.queries.results import PointHit as PointHit
    from sandbox.engine.queries.results import RayHit as RayHit
    from sandbox.engine.queries.results import RayHits as RayHits
    from sandbox.engine.views.bodies import Bodies as Bodies
    from sandbox.engine.views.body import BodyView as BodyView
    from sandbox.engine.views.game import ControlState as ControlState
    from sandbox.engine.views.game import Ending as Ending
    from sandbox.engine.views.joint import JointView as JointView
    from sandbox.engine.world import World as World
    from sandbox.errors import ArgumentError as ArgumentError
    from sandbox.errors import CapacityError as CapacityError
    from sandbox.errors import CommandError as CommandError
    from sandbox.errors import FileError as FileError
    from sandbox.errors import MissingDependencyError as MissingDependencyError
    from sandbox.errors import Problem as Problem
    from sandbox.errors import QueryError as QueryError
    from sandbox.errors import ReadOnlyAttributeError as ReadOnlyAttributeError
    from sandbox.errors import RecordingError as RecordingError
    from sandbox.errors import RefusedCommandError as RefusedCommandError
    from sandbox.errors import SandboxError as SandboxError
    from sandbox.errors import SceneError as SceneError
    from sandbox.errors import ShapeError as ShapeError
    from sandbox.errors import SnapshotError as SnapshotError
    from sandbox.errors import UnknownAttributeError as UnknownAttributeError
    from sandbox.errors import UnknownBodyError as UnknownBodyError
    from sandbox.errors import UnknownJointError as UnknownJointError
    from sandbox.errors import UnknownRegionError as UnknownRegionError
    from sandbox.formats.exports import Exported as Exported
    from sandbox.formats.exports import export_scene as export_scene
    from sandbox.formats.imports import Imported as Imported
    from sandbox.formats.imports import import_scene as import_scene
    from sandbox.formats.remarks import Remark as Remark
    from sandbox.geometry.collide import Contact as Contact
    from sandbox.geometry.collide import Distance as Distance
    from sandbox.geometry.collide import collide as collide
    from sandbox.geometry.collide import contains as contains
    from sandbox.geometry.collide import distance as distance
    from sandbox.geometry.sat_rows import SatRow as SatRow
    from sandbox.geometry.sat_table import SatTable as SatTable
    from sandbox.geometry.sat_table import sat_table as sat_table
    from sandbox.geometry.shapes import Box as Box
    from sandbox.geometry.shapes import Capsule as Capsule
    from sandbox.geometry.shapes import Circle as Circle
    from sandbox.geometry.shapes import Polygon as Polygon
    from sandbox.geometry.shapes import Segment as Segment
    from sandbox.geometry.shapes import Shape as Shape
    from sandbox.replay.expectations import Judge as Judge
    from sandbox.replay.expectations import Verdict as Verdict
    from sandbox.replay.golden.divergence import Difference as Difference
    from sandbox.replay.golden.divergence import Divergence as Divergence
    from sandbox.replay.golden.divergence import Drift as Drift
    from sandbox.replay.golden.divergence import Growth as Growth
    from sandbox.replay.golden.rerun import Outcome as Outcome
    from sandbox.replay.golden.rerun import rerun as rerun
    from sandbox.replay.golden.run import Run as Run
    from sandbox.replay.golden.side_by_side import find_divergence as find_divergence
    from sandbox.replay.golden.tolerance import Tolerance as Tolerance
    from sandbox.replay.player import Player as Player
    from sandbox.replay.recording.recorder import Recorder as Recorder
    from sandbox.replay.recording.recorder import record as record
    from sandbox.replay.recording.recording import Recording as Recording
    from sandbox.scene import Above as Above
    from sandbox.scene import Apart as Apart
    from sandbox.scene import Asleep as Asleep
    from sandbox.scene import Attraction as Attraction
    from sandbox.scene import Below as Below
    from sandbox.scene import Blast as Blast
    from sandbox.scene import Body as Body
    from sandbox.scene import BodyPath as BodyPath
    from sandbox.scene import BoxShape as BoxShape
    from sandbox.scene import BreakJoints as BreakJoints
    from sandbox.scene import CapsuleShape as CapsuleShape
    from sandbox.scene import Chain as Chain
    from sandbox.scene import ChainShape as ChainShape
    from sandbox.scene import ChangeGravity as ChangeGravity
    from sandbox.scene import ChangeJoint as ChangeJoint
    from sandbox.scene import ChangeRegion as ChangeRegion
    from sandbox.scene import CircleShape as CircleShape
    from sandbox.scene import Condition as Condition
    from sandbox.scene import Count as Count
    from sandbox.scene import CounterIs as CounterIs
    from sandbox.scene import DeleteBodies as DeleteBodies
    from sandbox.scene import DistanceJoint as DistanceJoint
    from sandbox.scene import Ended as Ended
    from sandbox.scene import Friction as Friction
    from sandbox.scene import Gear as Gear
    from sandbox.scene import Gravity as Gravity
    from sandbox.scene import GravityScale as GravityScale
    from sandbox.scene import Grid as Grid
    from sandbox.scene import InputControl as InputControl
    from sandbox.scene import Inside as Inside
    from sandbox.scene import Lose as Lose
    from sandbox.scene import Material as Material
    from sandbox.scene import Motor as Motor
    from sandbox.scene import MoveAt as MoveAt
    from sandbox.scene import Near as Near
    from sandbox.scene import OnBegin as OnBegin
    from sandbox.scene import OnCount as OnCount
    from sandbox.scene import OnEnd as OnEnd
    from sandbox.scene import OnEnter as OnEnter
    from sandbox.scene import OnEvery as OnEvery
    from sandbox.scene import OnHit as OnHit
    from sandbox.scene import OnJointBreak as OnJointBreak
    from sandbox.scene import OnLeave as OnLeave
    from sandbox.scene import OnPress as OnPress
    from sandbox.scene import OnTime as OnTime
    from sandbox.scene import Place as Place
    from sandbox.scene import PolygonShape as PolygonShape
    from sandbox.scene import Prefab as Prefab
    from sandbox.scene import Prismatic as Prismatic
    from sandbox.scene import Pulley as Pulley
    from sandbox.scene import PushOnce as PushOnce
    from sandbox.scene import PushStep as PushStep
    from sandbox.scene import PutBodies as PutBodies
    from sandbox.scene import Pyramid as Pyramid
    from sandbox.scene import Rests as Rests
    from sandbox.scene import Revolute as Revolute
    from sandbox.scene import Row as Row
    from sandbox.scene import Rule as Rule
    from sandbox.scene import RunPath as RunPath
    from sandbox.scene import Scatter as Scatter
    from sandbox.scene import Scene as Scene
    from sandbox.scene import SegmentShape as SegmentShape
    from sandbox.scene import Senses as Senses
    from sandbox.scene import SetBodySurface as SetBodySurface
    from sandbox.scene import Settings as Settings
    from sandbox.scene import SpawnBody as SpawnBody
    from sandbox.scene import Speeding as Speeding
    from sandbox.scene import Stack as Stack
    from sandbox.scene import Stands as Stands
    from sandbox.scene import SwitchThruster as SwitchThruster
    from sandbox.scene import Target as Target
    from sandbox.scene import Thruster as Thruster
    from sandbox.scene import Touches as Touches
    from sandbox.scene import Turned as Turned
    from sandbox.scene import View as View
    from sandbox.scene import Water as Water
    from sandbox.scene import Weld as Weld
    from sandbox.scene import Wheel as Wheel
    from sandbox.scene import Win as Win
    from sandbox.scene import Wind as Wind
    from sandbox.scene import load_scene as load_scene
    from sandbox.scene import loads_scene as loads_scene
    from sandbox.scene.schema import schema as schema
    from sandbox.sweeps.sweep import sweep as sweep
    from sandbox.sweeps.table import SweepTable as SweepTable
    from sandbox.world.export.copies import copy_of as copy_of
    from sandbox.world.export.copies import paste_of as paste_of
    from sandbox.world.export.scene_now import SceneNow as SceneNow
    from sandbox.world.export.scene_now import scene_of as scene_of

__all__ = [*sorted(HOMES), "__version__"]


def _html_of(value: Any) -> str:
    rendered: str = importlib.import_module("sandbox.report.notebook").html_of(value)
    return rendered


render_with(_html_of)


def __getattr__(name: str) -> object:
    if name not in HOMES:
        raise AttributeError(f"module 'sandbox' has no attribute {name!r}")
    value = getattr(importlib.import_module(HOMES[name]), name)
    globals()[name] = value  # next time without a detour
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
