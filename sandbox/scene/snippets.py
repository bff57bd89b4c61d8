"""What an editor offers where an entry of a list is wanted: `defaultSnippets`, as VS Code reads them from a schema.

`${1:text}` is a place to fill in, the first one first; a text that begins with ^ goes in without its quotes.
"""

from __future__ import annotations

from typing import Any

_X, _Y = "^${2:0}", "^${3:0}"
_ID, _POINT = "${1:id}", [_X, _Y]
_PAIR = ["${2:a}", "${3:b}"]
_PINNED = {"bodies": _PAIR, "anchor": ["^${4:0}", "^${5:0}"]}
_TIED = {"bodies": _PAIR, "anchors": [["^${4:0}", "^${5:0}"], ["^${6:1}", "^${7:0}"]]}
_AT, _ALWAYS, _WITHIN = {"at": "^${1:300}"}, {"always": True}, {"within": ["^${1:0}", "^${2:300}"]}

BODIES: dict[str, Any] = {
    "crate": {"id": _ID, "position": _POINT, "shapes": [{"box": ["^${4:1}", "^${5:1}"]}]},
    "ball": {"id": _ID, "position": _POINT, "shapes": [{"circle": "^${4:0.5}"}]},
    "ground": {"id": "ground", "type": "static", "position": [0, -0.5], "shapes": [{"box": ["^${1:40}", 1]}]},
    "body of a prefab": {"id": _ID, "prefab": "${4:prefab}", "position": _POINT},
    "lift on a path": {
        "id": _ID, "type": "kinematic", "position": _POINT, "shapes": [{"box": [2, 0.2]}],
        "path": {"to": [["^${4:0}", "^${5:4}"]], "speed": "^${6:1}", "pause": 1, "mode": "ping-pong"},
    },
}  # fmt: skip
"""Bodies, by what they are called in the editor's list."""

KINDS: dict[str, dict[str, Any]] = {
    "shape": {
        "circle": {"circle": "^${1:0.5}"},
        "box": {"box": ["^${1:1}", "^${2:1}"]},
        "capsule": {"capsule": [["^${1:-1}", 0], ["^${2:1}", 0]], "radius": "^${3:0.5}"},
        "segment": {"segment": [["^${1:-9}", 0], ["^${2:9}", 0]]},
        "polygon": {"polygon": [["^${1:0}", "^${2:0}"], ["^${3:2}", "^${4:0}"], ["^${5:0}", "^${6:1}"]]},
        "chain": {"chain": [["^${1:-9}", 1], ["^${2:0}", 0], ["^${3:9}", 1]]},
    },
    "joint": {
        "distance": {"id": _ID, "type": "distance", **_TIED},
        "revolute": {"id": _ID, "type": "revolute", **_PINNED},
        "prismatic": {"id": _ID, "type": "prismatic", **_PINNED, "axis": ["^${6:1}", "^${7:0}"]},
        "weld": {"id": _ID, "type": "weld", **_PINNED},
        "wheel": {"id": _ID, "type": "wheel", **_PINNED, "motor_speed": "^${6:-360}", "max_torque": "^${7:10}"},
        "gear": {"id": _ID, "type": "gear", "joints": _PAIR, "ratio": "^${4:1}"},
        "pulley": {"id": _ID, "type": "pulley", **_TIED, "wheels": [["^${8:0}", "^${9:5}"], ["^${10:1}", "^${11:5}"]]},
        "motor": {"id": _ID, "type": "motor", **_PINNED, "max_force": "^${6:100}"},
        "target": {
            "id": _ID, "type": "target", "bodies": ["${2:a}"], "anchor": ["^${3:0}", "^${4:0}"],
            "target": ["^${5:0}", "^${6:5}"],
        },
        "friction": {"id": _ID, "type": "friction", **_PINNED, "max_force": "^${6:10}"},
    },
    "generator": {
        "place": {"id": _ID, "place": "${2:prefab}", "at": ["^${3:0}", "^${4:0}"]},
        "row": {"id": _ID, "row": "${2:prefab}", "count": "^${3:5}", "at": ["^${4:0}", "^${5:0}"]},
        "stack": {"id": _ID, "stack": "${2:prefab}", "count": "^${3:5}", "at": ["^${4:0}", "^${5:0.5}"]},
        "grid": {
            "id": _ID, "grid": "${2:prefab}", "columns": "^${3:5}", "rows": "^${4:3}", "at": ["^${5:0}", "^${6:0.5}"],
        },
        "pyramid": {"id": _ID, "pyramid": "${2:prefab}", "rows": "^${3:5}", "at": ["^${4:0}", "^${5:0.5}"]},
        "scatter": {
            "id": _ID, "scatter": "${2:prefab}", "count": "^${3:20}",
            "inside": ["^${4:-5}", "^${5:2}", "^${6:5}", "^${7:9}"], "seed": "^${8:1}",
        },
        "chain": {
            "id": _ID, "chain": "${2:prefab}", "count": "^${3:8}", "at": ["^${4:0}", "^${5:5}"],
            "pin": "${6|none,start,end,both|}",
        },
    },
    "expectation": {
        "rests": {**_AT, "rests": "${2:id}"},
        "stands": {**_AT, "stands": "${2:wall-*}"},
        "inside": {**_ALWAYS, "inside": ["^${1:-20}", "^${2:-1}", "^${3:20}", "^${4:20}"]},
        "above": {**_ALWAYS, "above": "^${1:0}", "of": "${2:id}"},
        "below": {**_AT, "below": "^${2:5}", "of": "${3:id}"},
        "touches": {**_WITHIN, "touches": ["${3:a}", "${4:b}"]},
        "apart": {**_ALWAYS, "apart": ["${1:a}", "${2:b}"]},
        "senses": {**_WITHIN, "senses": ["${3:sensor}", "${4:body}"]},
        "asleep": {**_AT, "asleep": "${2:id}"},
        "near": {**_AT, "near": ["^${2:0}", "^${3:0}"], "of": "${4:id}"},
        "speed": {**_AT, "speed": ["^${2:0}", "^${3:1}"], "of": "${4:id}"},
        "angle": {**_AT, "angle": ["^${2:-5}", "^${3:5}"], "of": "${4:id}"},
        "counter": {**_AT, "counter": "${2:score}", "least": "^${3:1}"},
        "outcome": {**_AT, "outcome": "${2|won,lost,open|}"},
    },
    "region": {
        "water": {"water": "^${1:1}", "surface": "^${2:0}", "inside": ["^${3:-10}", "^${4:-5}", "^${5:10}", "^${6:2}"]},
        "wind": {"wind": ["^${1:8}", "^${2:0}"], "inside": ["^${3:-10}", "^${4:-5}", "^${5:10}", "^${6:2}"]},
    },
}  # fmt: skip
"""Entries by the union they are of (`sandbox.scene.union.UNIONS`) and their kind."""


def snippets(bodies: dict[str, Any]) -> list[dict[str, Any]]:
    """What `defaultSnippets` takes, of entries by their names."""
    return [{"label": label, "body": body} for label, body in bodies.items()]
