"""From a flat scene to the records of a world."""

from __future__ import annotations

from sandbox.scene.flat import FlatScene
from sandbox.tables import Records
from sandbox.world import records
from sandbox.world.body_rows import body_tables
from sandbox.world.build_fields import build_regions, build_thrusters
from sandbox.world.build_joints import build_joints
from sandbox.world.build_rules import build_paths, build_rules
from sandbox.world.census import Census
from sandbox.world.flush import join_tiles, with_room_for_tiles
from sandbox.world.roster import Roster
from sandbox.world.snapshot import origin
from sandbox.world.state import State

_DRAGS = 8


def build_state(scene: FlatScene) -> State:
    """A new state at step 0, all bodies awake. Bodies, shapes and vertices keep the order of the scene."""
    bodies, shapes, vertices, sides, seams = body_tables(scene.bodies)
    seams = with_room_for_tiles(bodies, shapes, seams)
    join_tiles(bodies, shapes, vertices, seams)
    paths = build_paths(scene.bodies, bodies, scene.settings.step_rate)  # joints count from where it leaves bodies
    drags = records.DRAG.zeros(_DRAGS)
    drags.body = -1
    regions, edges = build_regions(scene.regions, scene.settings.step_rate)
    played = build_rules(scene)
    census = Census(Roster.of(scene))
    rows = {name: row for row, name in enumerate(census.bodies.names)}
    joint_rows = {name: row for row, name in enumerate(census.joints.names)}
    return State(
        bodies=bodies,
        shapes=shapes,
        vertices=vertices,
        outlines=sides,
        seams=seams,
        contacts=records.CONTACT.zeros(max(16, 4 * len(shapes))),
        joints=build_joints(scene.joints, bodies, rows.__getitem__, joint_rows.__getitem__),
        drags=drags,
        regions=regions,
        edges=edges,
        thrusters=build_thrusters(scene.bodies, bodies, scene.settings.step_rate),
        settings=_settings(scene),
        counters=records.COUNTERS.zeros(1),
        controls=played.controls,
        tallies=played.tallies,
        rules=played.rules,
        spawners=played.spawners,
        sensings=played.sensings,
        outcome=played.outcome,
        paths=paths,
        census=census,
        origin=origin(scene, shapes, vertices),
    )


def _settings(scene: FlatScene) -> Records:
    table = records.SETTINGS.zeros(1)
    row = table[0]
    settings = scene.settings
    row.step_seconds, row.substeps = 1.0 / settings.step_rate, settings.substeps
    row.gravity_x, row.gravity_y = scene.gravity
    row.contact_hertz = settings.contact_hertz
    row.contact_damping_ratio = settings.contact_damping_ratio
    row.push_out_speed = settings.push_out_speed
    row.restitution_threshold = settings.restitution_threshold
    row.units_per_meter = settings.units_per_meter
    row.sleeping = int(settings.sleeping)
    row.warm_starting, row.accumulate = int(settings.warm_starting), int(settings.accumulate)
    row.soft, row.relax, row.speculative = int(settings.soft), int(settings.relax), int(settings.speculative)
    return table
