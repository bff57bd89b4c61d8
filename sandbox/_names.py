"""Every public name, by the module that it lives in; `sandbox/__init__.py` imports one when it is first asked for."""

from __future__ import annotations

_MODULES = {
    "sandbox.batch.batch": "Batch",
    "sandbox.engine.commands.base": "Command",
    "sandbox.engine.commands.control": "Control",
    "sandbox.engine.commands.delete": "Delete DeleteJoint DeleteRegion",
    "sandbox.engine.commands.drags": "EndDrag MoveDrag StartDrag",
    "sandbox.engine.commands.explode": "Explode",
    "sandbox.engine.commands.joint_parts": "BreakJoint SetLimits SetMotor SetSpring SetTarget",
    "sandbox.engine.commands.motion": "SetPose SetVelocity",
    "sandbox.engine.commands.pushes": "ApplyForce ApplyImpulse",
    "sandbox.engine.commands.set_gravity": "SetGravity",
    "sandbox.engine.commands.set_joint": "SetJoint",
    "sandbox.engine.commands.set_path": "SetPath",
    "sandbox.engine.commands.set_region": "SetRegion",
    "sandbox.engine.commands.set_settings": "SetSettings",
    "sandbox.engine.commands.set_surface": "SetSurface",
    "sandbox.engine.commands.set_thruster": "SetThruster",
    "sandbox.engine.commands.spawn": "Spawn",
    "sandbox.engine.events.events": "Events",
    "sandbox.engine.queries.filter": "Filter",
    "sandbox.engine.queries.queries": "Queries",
    "sandbox.engine.queries.results": "BodyDistance CastHit Overlap PointHit RayHit RayHits",
    "sandbox.engine.views.bodies": "Bodies",
    "sandbox.engine.views.body": "BodyView",
    "sandbox.engine.views.game": "ControlState Ending",
    "sandbox.engine.views.joint": "JointView",
    "sandbox.engine.world": "World",
    "sandbox.errors": """
        ArgumentError CapacityError CommandError FileError MissingDependencyError Problem QueryError
        ReadOnlyAttributeError RecordingError RefusedCommandError SandboxError SceneError ShapeError SnapshotError
        UnknownAttributeError UnknownBodyError UnknownJointError UnknownRegionError
    """,
    "sandbox.formats.exports": "Exported export_scene",
    "sandbox.formats.imports": "Imported import_scene",
    "sandbox.formats.remarks": "Remark",
    "sandbox.geometry.collide": "Contact Distance collide contains distance",
    "sandbox.geometry.sat_rows": "SatRow",
    "sandbox.geometry.sat_table": "SatTable sat_table",
    "sandbox.geometry.shapes": "Box Capsule Circle Polygon Segment Shape",
    "sandbox.replay.expectations": "Judge Verdict",
    "sandbox.replay.golden.divergence": "Difference Divergence Drift Growth",
    "sandbox.replay.golden.rerun": "Outcome rerun",
    "sandbox.replay.golden.run": "Run",
    "sandbox.replay.golden.side_by_side": "find_divergence",
    "sandbox.replay.golden.tolerance": "Tolerance",
    "sandbox.replay.player": "Player",
    "sandbox.replay.recording.recorder": "Recorder record",
    "sandbox.replay.recording.recording": "Recording",
    "sandbox.scene": """
        Above Apart Asleep Attraction Below Blast Body BodyPath BoxShape BreakJoints CapsuleShape Chain
        ChainShape ChangeGravity ChangeJoint ChangeRegion CircleShape Condition Count CounterIs DeleteBodies
        DistanceJoint Ended Friction Gear Gravity GravityScale Grid InputControl Inside Lose Material Motor
        MoveAt Near OnBegin OnCount OnEnd OnEnter OnEvery OnHit OnJointBreak OnLeave OnPress OnTime
        Place PolygonShape Prefab Prismatic Pulley PushOnce PushStep PutBodies Pyramid Rests Revolute Row Rule
        RunPath Scatter Scene SegmentShape Senses SetBodySurface Settings SpawnBody Speeding Stack Stands
        SwitchThruster Target Thruster Touches Turned View Water Weld Wheel Win Wind load_scene loads_scene
    """,
    "sandbox.scene.schema": "schema",
    "sandbox.sweeps.sweep": "sweep",
    "sandbox.sweeps.table": "SweepTable",
    "sandbox.world.export.copies": "copy_of paste_of",
    "sandbox.world.export.scene_now": "SceneNow scene_of",
}

HOMES = {name: module for module, names in _MODULES.items() for name in names.split()}
"""Where each public name lives."""
