"""Makes a scene of a world at this moment, which begins as the world is now."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from sandbox.scene.flat import FlatSettings
from sandbox.scene.generators import body_count
from sandbox.scene.scene import Scene
from sandbox.scene.settings import Settings
from sandbox.scene.units import guessed_units
from sandbox.world.export.body_words import written
from sandbox.world.export.joint_words import lasting, written_joint
from sandbox.world.export.numbers import pair
from sandbox.world.export.play_words import play_words
from sandbox.world.export.present import AnyWorld, Present
from sandbox.world.export.region_words import written_region


@dataclass(frozen=True)
class SceneNow:
    """A `scene` that begins as a world was, and `remarks`: what it could not carry over, a line for each reason."""

    scene: Scene
    remarks: tuple[str, ...]


def scene_of(world: AnyWorld, scene: Scene | None = None) -> SceneNow:
    """The scene that begins as `world` is now; `scene` is the one that the world was made of, if it does not know it.

    The author's words stay where they still hold: entries of what has not changed, materials, prefabs, and generators
    all of whose bodies are as they made them; the others are written out as bodies. Regions, thrusters and rules count
    their time from now. What lies asleep begins awake, and contacts begin without the impulses that they had. Raises
    `ArgumentError` if the world was not made of a `Scene`, and for what is no world.
    """
    present = Present("scene_of", world, scene)
    author = present.scene
    joints = lasting(present)
    kept = _kept(present, joints)
    census = present.state.census
    update: dict[str, Any] = {
        "gravity": _gravity(present),
        "settings": _settings(present),
        "bodies": tuple(written(present, k) for k, body in enumerate(census.bodies.items) if body.pointer not in kept),
        "generate": tuple(each for k, each in enumerate(author.generate) if f"/generate/{k}" in kept),
        "joints": tuple(written_joint(present, k) for k in joints if census.joints.items[k].pointer not in kept),
        "regions": tuple(written_region(present, k) for k in range(len(present.state.regions))),
        **play_words(present, joints),
        "expect": _expectations(present),
    }
    changed = {name: value for name, value in update.items() if value != getattr(author, name)}
    _note_hands(present)
    return SceneNow(author.model_copy(update=changed) if changed else author, present.remarks.lines())


def _kept(present: Present, joints: list[int]) -> set[str]:
    """The pointers of the generators all of whose bodies and hinges are there and as they were made."""
    census, scene = present.state.census, present.state.census.scene
    hinges = Counter(joint.pointer for joint in scene.joints)
    as_made = Counter(body.pointer for row, body in enumerate(census.bodies.items) if not present.changed[row])
    as_made.update(census.joints.items[row].pointer for row in joints if not present.rejoined[row])
    wanted = {f"/generate/{k}": body_count(each) for k, each in enumerate(present.scene.generate)}
    return {pointer for pointer, count in wanted.items() if as_made[pointer] == count + hinges[pointer]}


def _gravity(present: Present) -> tuple[float, float]:
    setting, first = present.state.settings[0], present.start.settings[0]
    if (setting.gravity_x, setting.gravity_y) == (first.gravity_x, first.gravity_y):
        return present.scene.gravity
    x, y = pair(setting.gravity_x, setting.gravity_y)
    return x, y


def _settings(present: Present) -> Settings:
    setting, first = present.state.settings[0], present.start.settings[0]
    names = [item.name for item in fields(FlatSettings) if item.name != "step_rate"]
    changed = {name: setting[name].item() for name in names if setting[name] != first[name]}
    if (present.scene.settings.units_per_meter or guessed_units(_gravity(present))) != setting.units_per_meter:
        changed["units_per_meter"] = float(setting.units_per_meter)  # which gravity no longer tells
    if not changed:
        return present.scene.settings
    kinds = {name: type(getattr(FlatSettings(), name)) for name in changed}
    return Settings(**present.scene.settings.given() | {name: kinds[name](value) for name, value in changed.items()})


def _expectations(present: Present) -> tuple[Any, ...]:
    """Those of the author, as long as nothing that they may speak of has moved or gone."""
    expect, census = present.scene.expect, present.state.census
    everybody = len(census.scene.bodies), len(census.scene.joints), len(census.scene.regions)
    there = [sum(serial < count for serial in ledger.serials) for ledger, count in zip(census, everybody, strict=True)]
    if not expect or (present.now == 0 and tuple(there) == everybody and not present.in_motion.any()):
        return expect
    present.remarks.note("expectations are left out: they speak of the scene as it began")
    return ()


def _note_hands(present: Present) -> None:
    """What holds or pushes bodies from outside has no words."""
    state = present.state
    for row in state.drags.body[state.drags.body >= 0].tolist():
        present.remarks.note("dragged bodies are let go", state.names[row])
    bodies = state.bodies
    for row in np.flatnonzero((bodies.force_x != 0.0) | (bodies.force_y != 0.0) | (bodies.torque != 0.0)).tolist():
        present.remarks.note("forces of the coming step are left out", state.names[row])
