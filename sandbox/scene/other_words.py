"""Words that authors bring from elsewhere, other engines and everyday speech, and what is meant by them here."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sandbox.scene.effort import Effort
from sandbox.scene.near_names import nearest

OURS: Mapping[str, str] = {
    "angle": "rotation rot orientation heading theta",
    "angular_velocity": "omega spin angular_speed turn_rate",
    "velocity": "linear_velocity vel",
    "position": "pos location place translation x y",
    "near": "position location",
    "at": "offset position pos translation x y time step",
    "shapes": "shape fixture fixtures collider colliders geometry",
    "fixed_rotation": "lock_rotation no_rotation",
    "bullet": "ccd continuous",
    "type": "static dynamic kinematic body_type",
    "id": "name label",
    "title": "name",
    "mass": "weight",
    "color": "fill tint",
    "circle": "ball disc disk round",
    "box": "rect rectangle square cuboid",
    "polygon": "poly vertices triangle hull",
    "segment": "line edge",
    "capsule": "pill",
    "chain": "polyline linestrip",
    "restitution": "bounce bounciness elasticity",
    "friction": "mu roughness",
    "sensor": "is_sensor is_trigger trigger",
    "surface_speed": "surface_velocity tangent_speed conveyor",
    "category": "layer category_bits",
    "mask": "mask_bits collides_with",
    "bodies": "body_a body_b a b objects entities",
    "joints": "constraints",
    "anchor": "pivot",
    "anchors": "anchor_a anchor_b",
    "hertz": "stiffness frequency frequency_hz",
    "motor_speed": "target_velocity",
    "lower": "lower_angle lower_limit lower_translation",
    "upper": "upper_angle upper_limit upper_translation",
    "collide": "collide_connected",
    "vars": "variables constants parameters",
    "expect": "assert asserts assertions checks tests",
    "step_rate": "fps hz dt timestep time_step",
    "substeps": "iterations velocity_iterations",
    "view": "camera",
    "when": "on event trigger",
    "do": "then action actions",
    "revolute": "hinge pin pivot",
    "prismatic": "slider slide rail",
    "distance": "spring rope rod",
    "weld": "fixed glue rigid",
    "target": "mouse",
    "static": "fixed immovable",
    "kinematic": "animated kinetic",
    "dynamic": "rigid movable",
    "press": "key input",
    "begin": "touch collide collision contact",
    "impulse": "push kick",
}
"""By our word theirs, each with `_` between its words; of several that an object knows, the first is meant."""


def _plain(name: str) -> str:
    """A word however it is written: `bodyA`, `body_a` and `BODY-A` are one."""
    return name.casefold().replace("_", "").replace("-", "")


_THEIRS: dict[str, list[str]] = {}
for _ours, _words in OURS.items():
    for _word in _words.split():
        _THEIRS.setdefault(_plain(_word), []).append(_ours)


def meant_by(name: str, known: Iterable[str]) -> str | None:
    """The one of the `known` names that a word from elsewhere stands for; None where it is none, or known itself."""
    there = set(known)
    wanted = () if name in there else _THEIRS.get(_plain(str(name)), ())
    return next((ours for ours in wanted if ours in there), None)


def nearest_word(name: str, known: Iterable[str], left: Effort | None = None) -> str | None:
    """The one of the `known` names that is meant by `name`, or else most like it, if any is."""
    listed = list(known)
    return None if name in listed else meant_by(name, listed) or nearest(name, listed, left)


def did_you_mean_word(name: str, known: Iterable[str]) -> str:
    """The hint with that name, empty if there is none."""
    near = nearest_word(name, known)
    return f'did you mean "{near}"?' if near else ""
