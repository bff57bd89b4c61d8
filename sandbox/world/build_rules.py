"""From the controls, counters, rules and paths of a flat scene to their records."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from sandbox._jit import interpreted
from sandbox.geometry.trig import cos_sin
from sandbox.scene.flat import FlatBody, FlatScene
from sandbox.scene.flat_rules import FlatAction, FlatEnd, FlatSpawn
from sandbox.tables import Records
from sandbox.world import rule_records as records

_cos_sin = interpreted(cos_sin)


class RuleTables(NamedTuple):
    """Tables of a state: what its rules know, but for paths, which belong to bodies."""

    controls: Records
    tallies: Records
    rules: Records
    spawners: Records
    sensings: Records
    outcome: Records


def build_rules(scene: FlatScene) -> RuleTables:
    """The tables of what rules know at the start."""
    tallies = records.TALLY.zeros(len(scene.counters))
    tallies.value = [counter.value for counter in scene.counters]
    rules, spawners = records.RULE.zeros(len(scene.rules)), records.SPAWNER.zeros(len(spawned_names(scene)))
    rules.last_step = spawners.last_step = -1
    outcome = records.OUTCOME.zeros(1 if scene.rules or scene.counters or scene.controls else 0)
    outcome.step = -1
    controls, sensings = records.CONTROL.zeros(len(scene.controls)), records.SENSING.zeros(0)
    return RuleTables(controls, tallies, rules, spawners, sensings, outcome)


def build_paths(scene_bodies: Sequence[FlatBody], bodies: Any, step_rate: float) -> Records:
    """The paths of all bodies that have one, from where `bodies` (rows of the body table) are now.

    Those that have gone along theirs already are put to where they are then.
    """
    found = [(row, body.path) for row, body in enumerate(scene_bodies) if body.path is not None]
    table = records.PATH.zeros(len(found))
    for row, (index, path) in zip(table, found, strict=True):
        body = bodies[index]
        row.body = index
        row.origin_x, row.origin_y, row.origin_angle = body["position_x"], body["position_y"], body["angle"]
        row.enabled = int(path.enabled)
        row.steps = round(path.time * step_rate)
        if row.steps > 0:
            _put(body, (row.origin_x, row.origin_y, row.origin_angle), path.after(int(row.steps) * (1.0 / step_rate)))
    return table


def _put(body: Any, origin: tuple[float, float, float], place: tuple[float, float, float]) -> None:
    """Put a body to a place of its path, as `engine/bodies/paths.py` does."""
    x, y, angle = (begin + way for begin, way in zip(origin, place, strict=True))
    cosine, sine = _cos_sin(angle)
    center_x, center_y = body["local_center_x"], body["local_center_y"]
    body["position_x"], body["position_y"], body["angle"] = x, y, angle
    body["rotation_cos"], body["rotation_sin"] = cosine, sine
    body["center_x"] = x + (cosine * center_x - sine * center_y)
    body["center_y"] = y + (sine * center_x + cosine * center_y)


def all_actions(scene: FlatScene) -> Iterator[FlatAction]:
    """The actions of a scene, in its order: those of the rules, then those of the controls."""
    for rule in scene.rules:
        yield from rule.do
    for control in scene.controls:
        for actions in (control.press, control.hold, control.release):
            yield from actions


def spawned_names(scene: FlatScene) -> list[str]:
    """The ids that rules and controls bring bodies under, each once, in the order of the spawner table."""
    names = (action.body.id for action in all_actions(scene) if isinstance(action, FlatSpawn) and action.body)
    return list(dict.fromkeys(names))


def outcome_texts(scene: FlatScene) -> list[str]:
    """The texts of all outcomes, each once, as the outcome table numbers them."""
    return list(dict.fromkeys(action.text for action in all_actions(scene) if isinstance(action, FlatEnd)))
