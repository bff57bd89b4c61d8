"""For each rule a scene that it finds fault with, and one that is near it and fine."""

from __future__ import annotations

from typing import Any, NamedTuple

Words = dict[str, Any]
GROUND = {"id": "ground", "type": "static", "position": [0, -0.5], "shapes": [{"box": [40, 1]}]}
CRATE = {"id": "crate", "position": [0, 0.5], "shapes": [{"box": [1, 1]}]}
BALL = {"id": "ball", "position": [3, 3], "shapes": [{"circle": 0.5}]}
KEPT = {"always": True, "inside": [-20, -1, 20, 20]}


class Case(NamedTuple):
    """Fields of a scene with a fault and of one without, and words of what is said of the first."""

    silly: Words
    fine: Words
    words: str


def scene(**fields: Any) -> Words:
    return {"bodies": [GROUND, CRATE], "expect": [KEPT], **fields}


def pinned(kind: str, **fields: Any) -> Words:
    return scene(
        bodies=[GROUND, CRATE, BALL],
        joints=[{"id": "j", "type": kind, "bodies": ["crate", "ball"], "anchor": [1.5, 1.5], **fields}],
    )


def falling(body: Words, **fields: Any) -> Words:
    return scene(bodies=[GROUND, {**BALL, **body}], expect=[{"at": 9, "touches": ["ball", "ground"]}], **fields)


def in_pixels(shapes: Any = ({"box": [40, 30]},), count: int = 4, **fields: Any) -> Words:
    bodies = [{"id": f"b{k}", "position": [50 * k, 15], "shapes": list(shapes)} for k in range(count)]
    floor = {**GROUND, "shapes": [{"box": [1000, 1]}]}
    return scene(bodies=[floor, *bodies], expect=[{"always": True, "inside": [-500, -1, 500, 500]}]) | fields


def over(chain: list[list[float]], **fields: Any) -> Words:
    """A ball above a chain that is solid from its left."""
    floor = {"id": "ground", "type": "static", "shapes": [{"chain": chain, "one_sided": True}], **fields}
    return scene(bodies=[floor, BALL], expect=[{"at": 9, "touches": ["ball", "ground"]}])


def turned(angle: float | str) -> Words:
    return scene(bodies=[GROUND, {**CRATE, "position": [0, 5], "angle": angle}])


WEDGE = [[6, 0], [7, 0], [6.5, 1]]
SENSOR = {"id": "eye", "type": "static", "position": [0, 3], "shapes": [{"circle": 1, "sensor": True}]}


def watched(filters: Words, **fields: Any) -> Words:
    eye = {**SENSOR, "shapes": [{"circle": 1, "sensor": True, **filters}]}
    return scene(bodies=[GROUND, CRATE, eye], categories=["ghost"], prefabs=fields.pop("prefabs", {}), **fields)


RACK = {"id": "rack", "shapes": [{"box": [1, 3], "at": [0.5, 0]}, {"box": [0.9, 0.1], "at": [0, -1.5]}]}


def two_eyes(mask: str) -> Words:
    eyes = [{"circle": 1, "sensor": True}, {"circle": 2, "sensor": True, "mask": mask}]
    return {**SENSOR, "shapes": eyes}


GHOST = {"id": "ghost", "position": [5, 0.5], "shapes": [{"circle": 0.5, "category": "ghost"}]}
PRESS = [{"id": "c", "press": [{"joint": "j", "motor_speed": 90}]}]

LIFT = {"id": "lift", "type": "kinematic", "position": [9, 1], "shapes": [{"box": [1, 1]}],
        "path": {"to": [[0, 1]], "speed": 1, "enabled": False}}  # fmt: skip


def one_of(prefab: Words) -> Words:
    return {"prefabs": {"p": prefab}, "generate": [{"id": "one", "place": "p", "at": [8, 8]}]}


def ruled(when: Words, condition: Words | None = None, **joint: Any) -> Words:
    """A scene with a rule, and another one that brings eggs and counts them."""
    egg = {"id": "egg", "shapes": [{"circle": 0.1}]}
    rules = [{"when": when, "do": [{"delete": "crate"}], **({"if": condition} if condition else {})}]
    rules.append({"when": {"every": 1}, "do": [{"spawn": egg}, {"counter": "m", "add": 1}]})
    bodies = [GROUND, CRATE, BALL, SENSOR, LIFT]
    return pinned("weld", **joint) | {"bodies": bodies, "rules": rules, "counters": {"n": 0, "m": 0}}


CASES: dict[str, list[Case]] = {
    "overlap": [
        Case(
            scene(bodies=[GROUND, CRATE, {**CRATE, "id": "other", "position": [0.7, 0.5]}]),
            scene(bodies=[GROUND, CRATE, {**CRATE, "id": "other", "position": [0.97, 0.5]}]),
            '"crate" and "other" start 0.3 m deep in each other',
        ),
        Case(
            scene(bodies=[GROUND, {**CRATE, "position": [0, 0.2]}]),
            scene(bodies=[GROUND, {**CRATE, "position": [0, 0.2], "shapes": [{"box": [1, 1], "mask": []}]}]),
            "0.3 m deep",
        ),
        Case(
            pinned("weld", collide=True)
            | {"bodies": [GROUND, CRATE, {**BALL, "position": [0.5, 0.5], "shapes": [{"circle": 0.5}]}]},
            pinned("weld") | {"bodies": [GROUND, CRATE, {**BALL, "position": [0.5, 0.5]}]},
            "start 0.5 m deep",
        ),
        # shallow for the rack as a whole, deep for the thin tooth of it that touches
        Case(
            scene(bodies=[GROUND, CRATE, {**RACK, "position": [0.9, 2]}]),
            scene(bodies=[GROUND, CRATE, {**RACK, "position": [1.03, 2]}]),
            '"crate" and "rack" start 0.05 m deep',
        ),
    ],
    "pixels": [
        Case(in_pixels(), in_pixels(settings={"units_per_meter": 50}), "smaller than 40 m, as if lengths were pixels"),
        Case(in_pixels(), in_pixels(gravity=[0, -900]), "pixels"),
        Case(in_pixels(), in_pixels(shapes=[{"circle": 5}]), "pixels"),
        Case(in_pixels(count=1), in_pixels(count=3, gravity=[0, 0]), "pixels"),
    ],
    "radians": [
        Case(turned(1.5708), turned(15.7), "angle 1.5708 looks like radians: angles are in degrees: 90"),
        Case(turned(-3.14), turned(-3.2), "degrees: -180"),
        Case(turned(3.1415), turned(3.1), "degrees: 180"),
        Case(turned("=pi / 8"), turned("=180 / 8"), "degrees: 22.5"),
        Case(
            pinned("revolute", lower=-0.785), pinned("prismatic", axis=[1, 0], lower=-0.785), "lower -0.785 looks like"
        ),
        Case(pinned("wheel", motor_speed=31.4159), pinned("wheel", motor_speed=31.4), "degrees: 1800"),
    ],
    "upside-down": [Case(scene(gravity=[0, 9.81]), scene(gravity=[9.81, 0]), "y points up here")],
    "out-of-view": [
        Case(
            scene(view={"center": [500, 0], "height": 10}),
            scene(view={"center": [15, 0], "height": 10}),
            "the view shows no body that can move",
        ),
        Case(
            scene(view={"center": [500, 0], "height": 10}),
            scene(view={"center": [500, 0], "height": 10, "follow": "crate"}),
            "leave the view out",
        ),
    ],
    "twice-placed": [
        Case(
            scene(bodies=[GROUND, {**CRATE, "position": [6, 0.5], "shapes": [{"box": [1, 1], "at": [6, 0.5]}]}]),
            scene(bodies=[GROUND, {**CRATE, "position": [0, 0.5], "shapes": [{"box": [1, 1], "at": [6, 0.5]}]}]),
            'the shapes of "crate" repeat its position: they are at [12, 1]',
        ),
        Case(
            scene(bodies=[GROUND, {**CRATE, "position": [6, 0.5], "shapes": [{"polygon": WEDGE}]}]),
            scene(bodies=[GROUND, {**CRATE, "position": [-6, 0.5], "shapes": [{"polygon": WEDGE}]}]),
            "leave one of the two out",
        ),
    ],
    "falls-away": [
        Case(falling({"position": [30, 3]}), falling({"position": [20.3, 3]}), '"ball" falls for ever'),
        Case(falling({"position": [0, -3]}), falling({"position": [0, -3], "gravity_scale": 0}), "nothing below"),
        Case(
            falling({"shapes": [{"circle": 0.5, "mask": []}]}),
            falling({"shapes": [{"circle": 0.5, "mask": 1}]}),
            "look at its mask",
        ),
        Case(falling({"position": [30, 3]}), falling({"position": [30, 3], "velocity": [-5, 0]}), "falls"),
        Case(over([[9, 0], [-9, 0]]), over([[-9, 0], [9, 0]]), "which side of what lies there is solid"),
        Case(over([[-9, 0], [9, 0]], angle=180), over([[9, 0], [-9, 0]], angle=180), "falls"),
        Case(
            falling({"position": [30, 3]}, rules=[{"when": {"time": 1}, "do": [{"delete": "ground"}]}]),
            falling({"position": [30, 3]}, rules=[{"when": {"time": 1}, "do": [{"delete": "ball"}]}]),
            "falls",
        ),
    ],
    "runaway-speed": [
        Case(
            scene(bodies=[GROUND, {**BALL, "velocity": [0, 5000]}]),
            scene(bodies=[GROUND, {**BALL, "velocity": [0, 500]}]),
            '"ball" is off at 5000 m/s',
        ),
        Case(
            scene(bodies=[GROUND, {**BALL, "velocity": [5000, 0.001]}]),
            scene(bodies=[GROUND, {**BALL, "velocity": [5000, -2000]}]),
            "in no time",
        ),
    ],
    "far-anchor": [
        Case(
            pinned("revolute", bodies=["ground", "ball"], anchor=[30, 3]),
            pinned("revolute", bodies=["ground", "ball"], anchor=[6, 3]),
            '"j" holds "ball" 27 m away',
        ),
        Case(
            pinned("weld", bodies=["ball"], anchor=[30, 1]),
            pinned("friction", bodies=["ball"], anchor=[30, 1], max_force=1),
            "places in the world",
        ),
    ],
    "static-wheel": [
        Case(pinned("wheel", bodies=["crate", "ground"]), pinned("wheel"), '"ground", which is static'),
        Case(pinned("wheel", bodies=["crate", None]), pinned("wheel", bodies=[None, "crate"]), "is the world"),
        Case(
            pinned("wheel", bodies=["ball", "crate"], anchor=[3, 3]),
            pinned("wheel", bodies=["crate", "ball"], anchor=[3, 3]),
            'is "crate", and "ball" is round about it: the second of its bodies is the wheel',
        ),
        Case(
            pinned("wheel") | {"bodies": [GROUND, CRATE, {**BALL, "fixed_rotation": True}]},
            pinned("wheel") | {"bodies": [GROUND, {**CRATE, "fixed_rotation": True}, BALL]},
            "whose rotation is fixed",
        ),
    ],
    "idle-motor": [
        Case(
            pinned("revolute", motor_speed=90, max_torque=0),
            pinned("revolute", motor_speed=90, max_torque=1),
            'motor of "max_torque" 0',
        ),
        Case(
            pinned("prismatic", axis=[1, 0], max_force=5),
            pinned("prismatic", axis=[1, 0], max_force=5, motor_speed=0),
            'no "motor_speed"',
        ),
        Case(
            pinned("revolute", motor_speed=0),
            pinned("revolute", motor_speed=0) | {"controls": PRESS},
            "it holds still",
        ),
        Case(pinned("friction", max_force=0), pinned("friction", max_force=0, max_torque=0.1), "neither force nor"),
    ],
    "mass-ratio": [
        Case(
            pinned("weld") | {"bodies": [GROUND, {**CRATE, "mass": 2001}, {**BALL, "mass": 2}]},
            pinned("weld") | {"bodies": [GROUND, {**CRATE, "mass": 1999}, {**BALL, "mass": 2}]},
            '"crate" to "ball", of 1e+03 times less mass',
        )
    ],
    "blind-sensor": [
        Case(watched({"mask": ["ghost"]}), watched({"mask": ["default"]}), 'the sensor of "eye"'),
        Case(
            watched({"mask": ["ghost"]}),
            watched(
                {"mask": ["ghost"]},
                rules=[{"when": {"time": 1}, "do": [{"spawn": GHOST}]}],
            ),
            "can feel no other body",
        ),
        Case(
            scene(bodies=[GROUND, SENSOR]),
            scene(bodies=[{**GROUND, "type": "kinematic"}, SENSOR]),
            "static bodies do not feel static ones",
        ),
        Case(
            scene(bodies=[GROUND, CRATE, two_eyes("ghost")], categories=["ghost"]),
            scene(bodies=[GROUND, CRATE, two_eyes("default")], categories=["ghost"]),
            'a sensor of "eye" can feel no other body',
        ),
    ],
    "stuck-joint": [
        Case(
            pinned("weld") | {"joints": [{"id": k, "type": t, "bodies": ["crate", "ball"], "anchor": [1, 1]}
                                         for k, t in (("w", "weld"), ("h", "revolute"))]},
            pinned("weld") | {"joints": [
                {"id": "w", "type": "weld", "bodies": ["crate", "ball"], "anchor": [1, 1], "break_force": 9},
                {"id": "h", "type": "revolute", "bodies": ["crate", "ball"], "anchor": [1, 1]}]},
            '"h" moves nothing',
        ),
        Case(
            pinned("revolute") | {"bodies": [GROUND, *({**b, "fixed_rotation": True} for b in (CRATE, BALL))]},
            pinned("revolute") | {"bodies": [GROUND, {**CRATE, "fixed_rotation": True}, BALL]},
            '"j" cannot turn',
        ),
        Case(
            pinned("prismatic", axis=[1, 0], lower=1, upper=1),
            pinned("prismatic", axis=[1, 0], lower=1, upper=1, motor_speed=0, max_force=5) | {"controls": PRESS},
            '"j" cannot move: its "lower" is its "upper"',
        ),
    ],
    "no-expect": [Case(scene(expect=[]), scene(), "the scene expects nothing")],
    "never-fails": [
        Case(
            scene(expect=[{"at": 9, "rests": "ground"}]),
            scene(expect=[{"at": 9, "rests": ["ground", "crate"]}]),
            "static bodies alone",
        ),
        Case(
            scene(expect=[{"at": 9, "counter": "n", "equals": 0}], counters={"n": 0}),
            scene(
                expect=[{"at": 9, "counter": "n", "equals": 0}],
                counters={"n": 0},
                rules=[{"when": {"time": 5}, "do": [{"counter": "n", "add": 1}]}],
            ),
            'nothing changes the counter "n"',
        ),
        Case(
            scene(expect=[{"always": True, "outcome": "open"}]),
            scene(
                expect=[{"always": True, "outcome": "open"}],
                rules=[{"when": {"time": 5}, "do": [{"win": "well done"}]}],
            ),
            "nothing wins or loses",
        ),
        Case(
            scene(expect=[{"within": [0, 9], "stands": "crate"}]),
            scene(expect=[{"within": [1, 9], "stands": "crate"}]),
            "at step 0 everybody stands",
        ),
        Case(
            scene(bodies=[GROUND, SENSOR], expect=[{"at": 9, "apart": ["ground", "eye"]}]),
            scene(expect=[{"at": 9, "apart": ["ground", "crate"]}]),
            "neither of the two can move",
        ),
        Case(
            scene(bodies=[GROUND, SENSOR]),
            scene(
                bodies=[GROUND, SENSOR],
                rules=[{"when": {"time": 1}, "do": [{"spawn": GHOST}]}],
                categories=["ghost"],
            ),
            "there is no dynamic body",
        ),
    ],
    "unused": [
        Case(
            scene(counters={"n": 0}),
            scene(counters={"n": 0}, expect=[{"at": 9, "counter": "n", "equals": 0}]),
            'the counter "n" is never used',
        ),
        Case(
            scene(controls=[{"id": "fire", "keys": ["space"]}]),
            scene(
                controls=[{"id": "fire", "keys": ["space"]}],
                rules=[{"when": {"press": "fire"}, "do": [{"delete": "crate"}]}],
            ),
            'the control "fire" does nothing',
        ),
        Case(
            scene(materials={"wood": {}}),
            scene(materials={"wood": {}}, bodies=[GROUND, {**CRATE, "shapes": [{"box": [1, 1], "material": "wood"}]}]),
            'the material "wood" is never used',
        ),
        Case(
            scene(prefabs={"p": {"shapes": [{"circle": 1}]}}),
            scene(
                prefabs={"p": {"shapes": [{"circle": 1}]}},
                rules=[{"when": {"time": 1}, "do": [{"spawn": {"id": "new", "prefab": "p"}}]}],
            ),
            'the prefab "p" is never used',
        ),
        Case(
            scene(categories=["ghost"], bodies=[GROUND, {**CRATE, "shapes": [{"box": [1, 1], "mask": "ghost"}]}]),
            scene(categories=["ghost"], bodies=[GROUND, CRATE, GHOST]),
            "no shape is in it",
        ),
        Case(
            scene(vars={"w": 1, "h": "=2 * w"}),
            scene(vars={"w": 1, "h": "=2 * w"}, gravity=[0, "=-h"]),
            'the number "h" is never used',
        ),
        Case(
            scene(**one_of({"params": {"r": 1, "d": 1}, "shapes": [{"circle": "=r"}]})),
            scene(**one_of({"params": {"r": "=d / 2", "d": 1}, "shapes": [{"circle": "=r"}]})),
            'the parameter "d" of "p" is never used',
        ),
        Case(
            scene(controls=[{"id": "fire", "press": [{"delete": "crate"}]}]),
            scene(controls=[{"id": "fire", "press": [{"delete": "crate"}], "pad": ["a"]}]),
            "nobody can press it",
        ),
    ],
    "left-off": [
        Case(
            pinned("weld", enabled=False),
            pinned("weld", enabled=False) | {"rules": [{"when": {"time": 1}, "do": [{"joint": "j", "enabled": True}]}]},
            '"j" is off, and nothing switches it on',
        ),
        Case(
            scene(bodies=[GROUND, CRATE, LIFT]),
            scene(bodies=[GROUND, CRATE, LIFT], rules=[{"when": {"time": 1}, "do": [{"path": "l*", "enabled": True}]}]),
            'the path of "lift" is off',
        ),
    ],
    "idle-rule": [
        Case(ruled({"enter": ["ground", "crate"]}), ruled({"enter": ["eye", "crate"]}), '"ground" has no sensor'),
        Case(ruled({"leave": ["eye", "ground"]}), ruled({"leave": ["eye", "egg-*"]}), '"eye" cannot feel "ground"'),
        Case(ruled({"begin": ["eye", "crate"]}), ruled({"begin": ["egg-1", "crate"]}), '"enter" and "leave" tell'),
        Case(ruled({"hit": ["ground", "lift"]}), ruled({"hit": ["ground", "crate"]}), "look at their masks"),
        Case(ruled({"joint_break": "j"}), ruled({"joint_break": "j"}, break_force=9), "no such joint can break"),
        Case(
            ruled({"count": "n", "reaches": 3}), ruled({"count": "m", "reaches": 3}), 'nothing changes the counter "n"'
        ),
        Case(
            ruled({"count": "m", "reaches": -1}), ruled({"count": "m", "reaches": 1}), "only goes up"
        ),
        Case(
            ruled({"time": 2}, {"counter": "n", "least": 1}),
            ruled({"time": 2}, {"counter": "m", "least": 1}),
            "this never holds",
        ),
    ],
}  # fmt: skip
