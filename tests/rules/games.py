"""Small scenes in which something is played."""

from __future__ import annotations

from typing import Any

from sandbox.engine.world import World
from sandbox.scene import Scene

BALL = {"id": "ball", "shapes": [{"circle": 0.2, "restitution": 1, "friction": 0}]}
WALL = {"type": "static", "shapes": [{"box": [4, 0.4], "restitution": 1, "friction": 0}]}


def game(rules: Any = (), *, bodies: Any = (BALL,), **fields: Any) -> World:
    """A world without gravity, with a counter called n."""
    fields = {"gravity": (0, 0), "counters": {"n": 0}, **fields}
    return World(Scene(bodies=bodies, rules=rules, **fields))


def ball(**fields: Any) -> dict[str, Any]:
    """The ball, somewhere."""
    return {**BALL, **fields}


def wall(name: str, y: float, **fields: Any) -> dict[str, Any]:
    """A level wall in the ball's way."""
    return {**WALL, "id": name, "position": [0, y], **fields}


def told(world: World, *kinds: str) -> list[dict[str, Any]]:
    """The events of the last step of some kinds."""
    return [event for event in world.events if event["event"] in kinds]


def add(value: float = 1) -> dict[str, Any]:
    """Count one more."""
    return {"counter": "n", "add": value}


BREAKOUT: dict[str, Any] = {
    "gravity": [0, 0],
    "materials": {"lively": {"restitution": 1, "friction": 0}},
    "prefabs": {
        "brick": {"type": "static", "material": "lively", "shapes": [{"box": [0.9, 0.4]}]},
        "ball": {"material": "lively", "fixed_rotation": True, "shapes": [{"circle": 0.15}]},
    },
    "bodies": [
        {"id": "cup", "type": "static", "material": "lively", "shapes": [
            {"box": [0.5, 10], "at": [-4, 0]}, {"box": [0.5, 10], "at": [4, 0]}, {"box": [8, 0.5], "at": [0, 5]},
        ]},
        {"id": "pit", "type": "static", "position": [0, -5], "shapes": [{"box": [20, 1], "sensor": True}]},
        {"id": "paddle", "position": [0, -3], "material": "lively", "mass": 5, "fixed_rotation": True,
         "shapes": [{"box": [1.6, 0.3]}]},
        {"id": "lift", "type": "kinematic", "position": [-3, -1], "shapes": [{"box": [0.6, 0.2]}],
         "path": {"to": [[6, 0]], "speed": 2, "pause": 0.2, "mode": "ping-pong", "easing": "smooth"}},
        {"id": "ball-0", "prefab": "ball", "position": [0, -1], "velocity": [2, 5]},
    ],
    "generate": [{"id": "brick", "grid": "brick", "columns": 6, "rows": 3, "at": [-2.5, 2], "spacing": [1, 0.5]}],
    "joints": [{"id": "rail", "type": "prismatic", "bodies": ["paddle"], "anchor": [0, -3], "axis": [1, 0],
                "lower": -3, "upper": 3, "motor_speed": 0, "max_force": 500}],
    "counters": {"score": 0, "balls": 1},
    "controls": [
        {"id": "move", "keys": ["right"], "minus": ["left"],
         "hold": [{"joint": "rail", "motor_speed": 8}], "release": [{"joint": "rail", "motor_speed": 0}]},
        {"id": "serve", "keys": ["space"], "mouse": ["left"],
         "press": [{"spawn": {"id": "ball", "prefab": "ball", "position": [0, 0.5], "velocity": [0, 4]}, "at": "paddle",
                    "limit": 4, "every": 0.25}]},
        {"id": "nudge", "mouse": ["move"],
         "hold": [{"force": [3, 0], "of": "ball-*", "along": "@pointer", "reach": 1}]},
    ],
    "rules": [
        {"id": "break", "when": {"hit": ["ball-*", "brick-*"]},
         "do": [{"delete": "@second"}, {"counter": "score", "add": 1}]},
        {"when": {"enter": ["pit", "ball-*"]}, "do": [{"delete": "@second"}, {"counter": "balls", "add": -1}]},
        {"when": {"press": "serve"}, "if": {"counter": "balls", "most": 3}, "do": [{"counter": "balls", "add": 1}]},
        {"when": {"count": "score", "reaches": 4}, "do": [{"win": "four"}]},
        {"when": {"every": 0.4}, "do": [{"surface": {"friction": 0.1}, "of": "ball-*"}], "limit": 3},
        {"when": {"begin": ["ball-*", "lift"]}, "cooldown": 0.3, "do": [{"path": "lift", "enabled": False}]},
        {"when": {"end": ["ball-*", "lift"]}, "do": [{"path": "lift", "enabled": True}]},
        {"when": {"leave": ["pit", "*"]}, "do": [{"lose": "never"}]},
    ],
}  # fmt: skip
"""A game with most of what there is, in which much happens."""


def breakout(**fields: Any) -> World:
    """A world of that game."""
    return World(Scene(**{**BREAKOUT, **fields}))
