"""One mistake, one message: what follows from it is not told beside it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from copy import deepcopy
from typing import Any

import pytest

from sandbox.errors import Problem, SceneError
from sandbox.resources import shipped_scenes
from sandbox.scene import loads_scene

GAME: dict[str, Any] = {
    "vars": {"w": 2},
    "materials": {"lively": {"restitution": 1}},
    "categories": ["balls"],
    "prefabs": {
        "brick": {"material": "lively", "shapes": [{"box": ["=w", 1]}]},
        "cart": {
            "params": {"r": 0.3},
            "bodies": [
                {"id": "bed", "position": [0, "=2 * r"], "shapes": [{"box": [2, 0.3]}]},
                {"id": "back", "position": [-0.7, "=r"], "shapes": [{"circle": "=r"}]},
            ],
            "joints": [{"id": "axle", "type": "wheel", "bodies": ["bed", "back"], "anchor": [-0.7, "=r"]}],
        },
    },
    "bodies": [
        {"id": "ball", "position": [0, -4], "shapes": [{"circle": 0.2, "category": "balls"}]},
        {"id": "paddle", "position": [0, -5], "material": "lively", "shapes": [{"box": [2, 0.4]}]},
        {"id": "lift", "type": "kinematic", "position": [9, 0], "shapes": [{"box": [1, 1]}],
         "path": {"to": [[0, 2]], "speed": 1}},
    ],
    "generate": [
        {"id": "brick", "grid": "brick", "columns": 4, "rows": 2, "at": [-6, 4], "spacing": [3, 2]},
        {"id": "car", "place": "cart", "at": [0, 20]},
        {"id": "wall", "chain": "brick", "count": 3, "at": [0, 40]},
    ],
    "joints": [{"id": "rail", "type": "prismatic", "bodies": ["paddle"], "anchor": [0, -5], "axis": [1, 0]}],
    "regions": [{"id": "breeze", "wind": [0, 1], "inside": [-6, -6, 6, 6]}],
    "counters": {"score": 0},
    "controls": [{"id": "move", "keys": ["left"], "hold": [{"joint": "rail", "motor_speed": 9}]}],
    "rules": [
        {"when": {"begin": ["ball", "brick-*"]}, "do": [{"delete": "@second"}, {"counter": "score", "add": 1}]},
        {"when": {"press": "move"},
         "do": [{"region": "breeze", "enabled": False}, {"joint": "car.axle", "motor_speed": 1}]},
        {"when": {"joint_break": "wall-joint-2"}, "do": [{"spawn": {"id": "egg", "prefab": "brick"}, "limit": 2}]},
        {"when": {"count": "score", "reaches": 8}, "do": [{"win": "All are gone"}, {"delete": "egg-*"}]},
    ],
    "expect": [{"at": 1, "stands": ["ball", "car.bed", "brick-1-1"]}, {"at": 1, "counter": "score", "least": 0}],
}  # fmt: skip
GONE = object()


def changed(path: str, value: object) -> dict[str, Any]:
    scene = deepcopy(GAME)
    node: Any = scene
    *way, last = (int(part) if part.isdigit() else part for part in path.split("."))
    for part in way:
        node = node[part]
    if value is GONE:
        del node[last]
    elif isinstance(node, list) and last == len(node):
        node.append(value)
    else:
        node[last] = value
    return scene


def problems(scene: object, source: str = "<string>") -> list[Problem]:
    with pytest.raises(SceneError) as caught:
        loads_scene(json.dumps(scene, indent=1), source)
    return caught.value.problems


def told(scene: object) -> list[str]:
    return [f"{each.pointer} {each.message}{': ' * bool(each.hint)}{each.hint}" for each in problems(scene)]


def test_the_scene_is_right() -> None:
    loads_scene(json.dumps(GAME))


LIST, OBJECT = ["x"], {"x": 1}


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        # fields of the wrong kind: what they would have declared is not called unknown
        *((name, 5, f"/{name} {name} must be a list of {what}, not a number") for name, what in {
            "bodies": "bodies", "generate": "generators", "joints": "joints", "regions": "regions",
            "controls": "controls", "rules": "rules", "expect": "expectations"}.items()),
        *((name, LIST, f"/{name} {name} must be an object {{...}}, not a list")
          for name in ("vars", "materials", "prefabs", "counters")),
        ("categories", "balls", '/categories categories must be a list ["name", ...], not text'),
        ("include", ["sandbox:materal"], '/include/0 no part is named "materal": did you mean "sandbox:materials"?'),
        # entries that cannot be read
        ("bodies.0", "ball", "/bodies/0 bodies[0] must be an object {...}, not text"),
        ("bodies.0.id", GONE, '/bodies/0 "id" is missing'),
        ("bodies.0.id", 5, "/bodies/0/id id must be text, not a number"),
        ("generate.0", "brick", '/generate/0 a generator must be an object such as {"place": ...}, not text'),
        ("generate.0.columns", "4",
         "/generate/0/columns columns must be a whole number, not text: take the quotes away"),
        ("generate.1.place", "crat", '/generate/1/place no prefab is named "crat": did you mean "cart"?'),
        ("generate.1.att", [0, 0], '/generate/1/att unknown field "att": did you mean "at"?'),
        ("generate.2.count", GONE, '/generate/2 "count" is missing'),
        ("joints.0.id", GONE, '/joints/0 "id" is missing'),
        ("regions.0", "breeze", '/regions/0 a region must be an object such as {"water": ...}, not text'),
        ("controls.0.id", 5, "/controls/0/id id must be text, not a number"),
        ("prefabs.cart.bodies", OBJECT, "/prefabs/cart/bodies bodies must be a list of bodies, not an object"),
        ("prefabs.cart.bodies.0.id", GONE, '/prefabs/cart/bodies/0 "id" is missing'),
        ("prefabs.cart.joints.0.id", GONE, '/prefabs/cart/joints/0 "id" is missing'),
        ("prefabs.cart.params", "r", "/prefabs/cart/params params must be an object {...}, not text"),
        ("prefabs.brick.shapes", GONE, '/prefabs/brick the prefab "brick" has no shapes: give it one, as in "shapes": '
         '[{"circle": 0.5}]'),
        ("rules.2.do.0", "egg", '/rules/2/do/0 an action must be an object such as {"delete": ...}, not text'),
        ("rules.2.do.0.spawn.id", GONE, '/rules/2/do/0/spawn "id" is missing'),
        ("rules.2.do.0.limit", 20_000, "/rules/2/do/0/limit limit must not be above 10000"),
        # a trigger that cannot be read may bring what the actions speak of
        ("rules.0.when", GONE, '/rules/0 "when" is missing'),
        ("rules.0.when", "begin", '/rules/0/when a trigger must be an object such as {"hit": ...}, not text'),
        ("rules.0.when", {"begn": ["ball", "brick-*"]},
         '/rules/0/when/begn unknown field "begn": did you mean "begin"?'),
        ("materials.lively", {"restitution": 1.5, "bmper": True},
         '/materials/lively/bmper unknown field "bmper": did you mean "bumper"?'),
        # a word that is known nowhere stands for the only one that is missing
        ("rules.0", {"on": {"begin": ["ball", "brick-*"]}, "do": [{"delete": "@second"}]},
         '/rules/0/on unknown field "on": did you mean "when"?'),
        ("rules.3.when", {"count": "score", "past": 8},
         '/rules/3/when/past unknown field "past": did you mean "reaches"?'),
        ("rules.0.if", "score > 8", "/rules/0/if if must be an object {...}, not text"),
        ("bodies.1.shapes.0", {"type": "circle", "radius": 1},
         '/bodies/1/shapes/0/type the kind of a shape is a key: as in {"circle": ...}'),
        ("joints.0.min", "=w", '/joints/0/min unknown field "min"'),
        ("rules.0.do.1.counter", "points", '/rules/0/do/1/counter no counter is named "points": there is "score"'),
        # numbers that cannot be worked out
        ("vars.w", "=2 *", "/vars/w the expression ends too early"),
        ("generate.0.columns", "=n", '/generate/0/columns no number is named "n": give it in "vars"'),
        ("regions.0.inside.0", "=n", '/regions/0/inside/0 no number is named "n": give it in "vars"'),
        # ids that are given twice
        ("bodies.3", {"id": "car.bed", "shapes": [{"circle": 1}]},
         '/generate/1/id the id "car.bed" is taken by bodies[3]'),
        ("generate.3", {"id": "car", "place": "cart", "at": [0, 50]},
         '/generate/3/id the id "car.bed" is taken by a copy of a prefab'),
        ("prefabs.cart.bodies.1.id", "bed",
         '/prefabs/cart/bodies/1/id the id "bed" is taken by bodies[0] of the prefab'),
        # of two that are alike, one may have the name that is missed then
        ("bodies.1.id", "ball", '/bodies/1/id the id "ball" is taken by bodies[0]'),
        ("prefabs.cart.bodies.0.id", True, "/prefabs/cart/bodies/0/id id must be text, not true or false"),
        ("prefabs.cart.bodies.0.id", "my bed",
         '/prefabs/cart/bodies/0/id the name "my bed" must be 1 to 100 letters, digits or any of _ - . :'),
        # generators that are wrong, in the scene and in a prefab
        ("generate.3", {"id": "ring", "place": "brick", "coutn": 9, "at": ["=i", 60]},
         '/generate/3/coutn unknown field "coutn": did you mean "count"?'),
        ("prefabs.cart.generate", [{"id": "hook", "row": "brick", "coutn": 2, "step": [1, 0]}],
         '/prefabs/cart/generate/0/coutn unknown field "coutn": did you mean "count"?'),
        # an unknown name is one mistake, wherever it stands
        ("bodies.0.id", "bal",
         '/rules/0/when/begin/0 no body has the id "ball", here and elsewhere: did you mean "bal"?'),
        ("prefabs.cart.params", {"ra": 0.3},
         '/prefabs/cart/bodies/0/position/1 no number is named "r", here and elsewhere: did you mean "ra"?'),
        # patterns have near names too
        ("rules.0.when.begin.1", "brik-*",
         "/rules/0/when/begin/1 no body's id matches \"brik-*\": did you mean \"brick-*\"?"),
        ("rules.3.do.1.delete", "eg-*", "/rules/3/do/1/delete no body's id matches \"eg-*\": did you mean \"egg-*\"?"),
        ("rules.1.do.1.joint", "cra.*", "/rules/1/do/1/joint no joint's id matches \"cra.*\": did you mean \"car.*\"?"),
        # a list that is wrong as a whole
        ("bodies.2.path.to", [0, 2],
         "/bodies/2/path/to/0 to[0] must be a list [x, y], not a number: and likewise in those after it"),
        ("rules.3.when.count", ["score"], "/rules/3/when/count count must be text, not a list"),
        ("expect.0.touches", "ball",
         '/expect/0/touches an expectation has one kind, and this one has "stands" and "touches"'),
        ("joints.0.bodies", "pad", '/joints/0/bodies bodies must be a list ["id", "id"]; null is the world, not text'),
        ("generate.1", {"id": "car", "row": "cart", "count": 2},
         '/generate/1/row "step" is needed: neighbours just touch only where all are the same single body'),
        # one wrong word is one mistake
        ("rules.1.if", {"countre": "score", "least": 0},
         '/rules/1/if/countre unknown field "countre": did you mean "counter"?'),
        ("bodies.2.path", {"to": [[0, 2]], "times": [1, 1]},
         "/bodies/2/path/times needs a time for each of the 1 places, and has 2"),
        ("rules.1.if", {"counter": "score", ">": 0},
         '/rules/1/if/> unknown field ">": there are counter, equals, least, most, touches'),
        # names of the event without their sign
        ("rules.0.do.0.delete", "second", '/rules/0/do/0/delete no body has the id "second": did you mean "@second"?'),
        ("rules.0.do.1", {"velocity": [8, 0], "of": "ball", "along": "motion"},
         '/rules/0/do/1/along no body has the id "motion": did you mean "@motion"?'),
        # fields that belong elsewhere, or have a longer name
        ("rules.1.do.1.speed", 3, '/rules/1/do/1/speed unknown field "speed": did you mean "motor_speed"?'),
        ("controls.0.hold.0.speed", 3, '/controls/0/hold/0/speed unknown field "speed": did you mean "motor_speed"?'),
        ("bodies.0.speed", 3, '/bodies/0/speed unknown field "speed": it belongs in a "path"'),
        ("bodies.0.damping", 3,
         '/bodies/0/damping unknown field "damping": did you mean "linear_damping" or "angular_damping"?'),
        ("prefab", {}, '/prefab unknown field "prefab": did you mean "prefabs"?'),
    ],
)  # fmt: skip
def test_one_mistake_is_one_message(path: str, value: object, said: str) -> None:
    assert told(changed(path, value)) == [said]


def test_a_wrong_name_is_told_once() -> None:
    words = json.loads(json.dumps(GAME).replace('"score"', '"the score"'))
    said = 'the name "the score" must be 1 to 100 letters, digits or any of _ - . :, here and elsewhere'
    assert told(words) == [f"/counters/the score {said}"]


def test_a_misspelt_list_is_one_message_however_much_refers_to_it() -> None:
    """Near names are looked for as long as that takes not too long, which tells nothing of what follows."""
    names = [f"somebody-with-a-long-name-{k}" for k in range(900)]
    rules = [{"when": {"time": 1}, "do": [{"delete": f"{name}-or-so"}]} for name in names]
    bodies = [{"id": name, "shapes": [{"circle": 1}]} for name in names]
    assert told({"bodies": bodies, "bodys": bodies, "rules": rules})[-1].startswith('/bodys unknown field "bodys"')
    assert len(told({"bodies": bodies, "bodys": bodies, "rules": rules})) == 1


def keys_once() -> dict[str, tuple[str, Any, list[Any]]]:
    """Every field that shipped scenes have, by its name: the file, its data, and the way to the field."""
    found: dict[str, tuple[str, Any, list[Any]]] = {}
    for file in shipped_scenes():
        data = json.loads(file.read_text(encoding="utf-8"))
        for way in _ways(data, []):
            found.setdefault(way[-1], (str(file), data, way))
    return found


def _ways(node: Any, way: list[Any]) -> Iterator[list[Any]]:
    """The ways to all fields; names that an author gives are none."""
    for key, value in node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ():
        is_given = not way or way[-1] not in ("vars", "materials", "prefabs", "counters", "params")
        if isinstance(key, str) and is_given and len(key) > 3 and key[0] != "$":
            yield [*way, key]
        yield from _ways(value, [*way, key])


def test_a_misspelt_field_is_one_message() -> None:
    """Each field of the shipped scenes once, with two letters swapped. A bumper is not seen to be meant for one."""
    for key, (file, data, way) in keys_once().items():
        home, wrong = deepcopy(data), key[:-3] + key[-2] + key[-3] + key[-1]
        node = home
        for part in way[:-1]:
            node = node[part]
        if wrong == key or key == "bumper":
            continue
        node[wrong] = node.pop(key)
        found = problems(home, file)
        assert [each.message for each in found] == [f'unknown field "{wrong}"'], (file, way, found)
        assert found[0].hint == f'did you mean "{key}"?'
