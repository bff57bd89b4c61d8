"""Calls every entry point once, for the sake of compiling it."""

from __future__ import annotations

import numpy as np

from sandbox.engine.commands.explode import Explode
from sandbox.engine.compile_step import compile_parts
from sandbox.engine.events.sensors import SensorOverlaps
from sandbox.engine.joints.elimination import FEW_JOINTS, minimum_degree
from sandbox.engine.joints.net_lanes import color_joints
from sandbox.engine.lanes.advance import Rows
from sandbox.engine.lanes.lane_world import LaneWorld
from sandbox.engine.stepper import Stepper
from sandbox.engine.world import World
from sandbox.geometry.exact_axes import Axis
from sandbox.geometry.pair import pair_of
from sandbox.geometry.shapes import Box
from sandbox.reference.arbitration import our_answer
from sandbox.reference.pair import Core, Pair
from sandbox.scene.flat import FlatBody, FlatPath, FlatRegion, FlatScene, FlatShape
from sandbox.world.build import build_state


def call_every_entry_point() -> None:
    """All that Python calls in the engine, in the geometry and in the comparison with other engines."""
    compile_parts()
    _share_a_step()
    _step_a_batch()
    lay_out_many_joints()
    _ask_about(_windy_world())
    _look_at_a_pair()


def _share_a_step() -> None:
    """What the second worker runs."""
    ball = FlatBody("ball", "dynamic", (FlatShape("circle", ((0.0, 0.0),), 0.5),))
    Stepper(build_state(FlatScene((ball,))), workers=2).bind_workers()


def _step_a_batch() -> None:
    """What steps the rows of a batch."""
    ball = FlatBody("ball", "dynamic", (FlatShape("circle", ((0.0, 0.0),), 0.5),))
    lane = LaneWorld(FlatScene((ball,)))
    no_rows, none = np.zeros((0, 1), np.int64), np.zeros(0, np.int64)
    lane.call(Rows(no_rows, no_rows, none, none), np.zeros(2, np.int64))()


def lay_out_many_joints() -> None:
    """What lays out so many joints that Python would take too long."""
    minimum_degree(np.full((FEW_JOINTS + 1, 4), -1), np.ones(FEW_JOINTS + 1, np.int64), 1)
    none = np.zeros(0, np.int64)
    color_joints(none, none, none, none, none)


def _windy_world() -> World:
    """Two balls and a lift on its path in the wind of everywhere, after a step and an explosion."""
    shape = FlatShape("circle", ((0.0, 0.0),), 0.5)
    bodies = (
        FlatBody("ball", "dynamic", (shape,)),
        FlatBody("other", "dynamic", (shape,), (2.0, 0.0)),
        FlatBody(
            "lift", "kinematic", (shape,), (9.0, 0.0), path=FlatPath(((0.0, 0.0, 0.0), (0.0, 5.0, 0.0)), (0.0, 5.0))
        ),
    )
    world = World(FlatScene(bodies, regions=(FlatRegion("wind", flow=(1.0, 0.0), density=1.0),)))
    world.step()
    world.apply(Explode((0.0, 0.0), 1.0, 1.0))
    return world


def _ask_about(world: World) -> None:
    SensorOverlaps(world.state).update()
    ask = world.query
    ask.ray((-2.0, 0.0), (4.0, 0.0))
    ask.ray_all((-2.0, 0.0), (4.0, 0.0))
    ask.nearest((0.0, 0.0))
    ask.point((0.0, 0.0))
    ask.distance("ball", "other")


def _look_at_a_pair() -> None:
    pair = pair_of(Box(1.0, 1.0), Box(1.0, 1.0, (2.0, 0.0)))
    pair.manifold(0.0)
    pair.nearest()
    pair.manifold_on(Axis(0, 1, 0, 1, 0, 0))
    our_answer(Pair(Core(((0.0, 0.0),)), Core(((1.0, 0.0),))))
