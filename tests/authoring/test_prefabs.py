"""Prefabs with parameters and of several bodies: what copies are, and what is told of mistakes in them."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox import World
from sandbox.errors import SceneError
from sandbox.scene import Body, Place, Prefab, Row, Scene, load_scene, loads_scene
from tests.examples import examples
from tests.scene.scene_helpers import one, refused

BALL = {"shapes": [{"circle": "=r"}], "params": {"r": 0.5}}
CART: dict[str, Any] = {
    "params": {"wheel": 0.3},
    "bodies": [
        {"id": "bed", "position": [0, 1], "angle": 10, "velocity": [1, 0], "shapes": [{"box": [2, "=wheel"]}]},
        {"id": "back", "prefab": "ball", "params": {"r": "=wheel"}, "position": [-1, "=wheel"]},
    ],
    "joints": [
        {"id": "axle", "type": "wheel", "bodies": ["bed", "back"], "anchor": [-1, "=wheel"]},
        {"id": "slide", "type": "prismatic", "bodies": ["bed"], "anchor": [0, 1], "axis": [1, 0]},
        {"id": "rod", "type": "distance", "bodies": ["bed", "back"], "anchors": [[0, 1], [-1, 0.3]]},
        {"id": "gear", "type": "gear", "joints": ["axle", "slide"]},
    ],
}


def placed(**entry: Any) -> Scene:
    scene = {"prefabs": {"ball": BALL, "cart": CART}, "generate": [{"id": "c", "place": "cart", **entry}]}
    return loads_scene(json.dumps(scene))


def test_a_copy_is_bodies_and_joints_under_its_id():
    flat = placed(at=[5, 7]).flatten()
    assert [(body.id, body.position) for body in flat.bodies] == [("c.bed", (5, 8)), ("c.back", (4, 7.3))]
    assert [joint.id for joint in flat.joints] == ["c.axle", "c.slide", "c.rod", "c.gear"]
    assert flat.joints[0].anchor_a == (4, 7.3)
    assert (flat.joints[0].body_a, flat.joints[0].body_b) == ("c.bed", "c.back")
    assert flat.joints[3].joints == ("c.axle", "c.slide")
    assert flat.bodies[1].shapes[0].radius == 0.3


def test_a_turned_copy_is_turned_as_a_whole():
    flat = placed(at=[5, 7], angle=90).flatten()
    bed, back = flat.bodies
    assert bed.position == (4, 7)
    assert bed.angle == math.radians(100)
    assert bed.velocity == (0, 1)
    assert back.position == (4.7, 6)
    assert flat.joints[0].anchor_a == (4.7, 6)
    assert [flat.joints[k].axis for k in (0, 1)] == [(-1, 0), (0, 1)]
    assert flat.joints[2].anchor_b == (4.7, 6)


@given(st.floats(-50, 50), st.floats(-50, 50), st.sampled_from([0, 90, 180, 270, -90]), st.floats(0.1, 1))
@examples(20)
def test_copies_are_what_one_would_write(x, y, angle, wheel):
    """A copy placed by hand: turns by quarters are exact."""
    cos, sin = {0: (1, 0), 90: (0, 1), 180: (-1, 0), 270: (0, -1), -90: (0, -1)}[angle]

    def at(u: float, v: float) -> tuple[float, float]:
        return x + (cos * u - sin * v), y + (sin * u + cos * v)

    flat = placed(at=[x, y], angle=angle, params={"wheel": wheel}).flatten()
    assert [body.position for body in flat.bodies] == [at(0, 1), at(-1, wheel)]
    assert flat.joints[0].anchor_a == at(-1, wheel)
    assert flat.bodies[1].shapes[0].radius == wheel


@pytest.mark.parametrize(
    ("entry", "ids"),
    [
        ({"place": "cart"}, ["g.bed", "g.back"]),
        ({"place": "cart", "count": 2, "at": ["=9*i", 0]}, ["g-1.bed", "g-1.back", "g-2.bed", "g-2.back"]),
        ({"row": "cart", "count": 2, "step": [5, 0]}, ["g-1.bed", "g-1.back", "g-2.bed", "g-2.back"]),
        ({"stack": "cart", "count": 1, "spacing": 5}, ["g-1.bed", "g-1.back"]),
        ({"grid": "cart", "columns": 1, "rows": 2, "spacing": [5, 5]},
         ["g-1-1.bed", "g-1-1.back", "g-2-1.bed", "g-2-1.back"]),
        ({"pyramid": "cart", "rows": 1, "spacing": [5, 5]}, ["g-1-1.bed", "g-1-1.back"]),
        ({"scatter": "cart", "count": 1, "inside": [0, 0, 9, 9], "apart": 1}, ["g-1.bed", "g-1.back"]),
    ],
)  # fmt: skip
def test_every_generator_can_copy_several_bodies(entry, ids):
    scene = Scene(prefabs={"ball": BALL, "cart": CART}, generate=[{"id": "g", **entry}])
    assert [body.id for body in scene.flatten().bodies] == ids
    World(scene).step(1)


def test_parameters_may_count_the_copies():
    entries = [
        {"id": "a", "row": "ball", "count": 3, "step": [2, 0], "params": {"r": "=0.1*i"}},
        {"id": "b", "grid": "ball", "columns": 2, "rows": 2, "spacing": [2, 2], "params": {"r": "=row/10+column/100"}},
        {"id": "c", "place": "ball", "count": 2, "at": ["=i", "=i**2"], "angle": "=10*i"},
    ]
    flat = Scene(prefabs={"ball": BALL}, generate=entries).flatten()
    assert [body.shapes[0].radius for body in flat.bodies[:3]] == [0.1, 0.2, 0.1 * 3]
    assert [body.shapes[0].radius for body in flat.bodies[3:7]] == [0.11, 0.1 + 2 / 100, 0.2 + 1 / 100, 0.2 + 2 / 100]
    assert [(body.position, body.angle) for body in flat.bodies[7:]] == [
        ((1, 1), math.radians(10)), ((2, 4), math.radians(20)),
    ]  # fmt: skip


def test_a_generator_with_the_same_parameters_for_all_stays_one():
    scene = Scene(prefabs={"ball": BALL}, generate=[{"id": "a", "row": "ball", "count": 3, "params": {"r": 0.25}}])
    assert [body.position for body in scene.flatten().bodies] == [(0, 0), (0.5, 0), (1, 0)]
    assert len(scene.generate) == 1


def test_bodies_and_what_rules_bring_give_parameters():
    scene = Scene(
        prefabs={"ball": BALL},
        bodies=[
            {"id": "one", "prefab": "ball"},
            {"id": "two", "prefab": "ball", "params": {"r": 2}, "position": (9, 0)},
        ],
        rules=[{"when": {"time": 1}, "do": [{"spawn": {"id": "s", "prefab": "ball", "params": {"r": 3}}}]}],
    )
    flat = scene.flatten()
    assert [body.shapes[0].radius for body in flat.bodies] == [0.5, 2]
    assert flat.rules[0].do[0].body.shapes[0].radius == 3


def test_prefabs_in_prefabs():
    prefabs = {
        "ball": BALL,
        "pair": {"params": {"d": 1}, "generate": [{"id": "n", "row": "ball", "count": 2, "step": ["=d", 0]}]},
        "four": {"generate": [{"id": "p", "place": "pair", "count": 2, "at": [0, "=5*i"], "params": {"d": "=2*i"}}]},
    }
    scene = Scene(prefabs=prefabs, generate=[{"id": "x", "place": "four", "angle": 90}])
    assert [(body.id, body.position) for body in scene.flatten().bodies] == [
        ("x.p-1.n-1", (-5, 0)), ("x.p-1.n-2", (-5, 2)), ("x.p-2.n-1", (-10, 0)), ("x.p-2.n-2", (-10, 4)),
    ]  # fmt: skip


def test_a_chain_in_a_prefab():
    prefabs = {
        "link": {"shapes": [{"box": [1, 0.2]}]},
        "rope": {"generate": [{"id": "r", "chain": "link", "count": 2, "step": [1, 0], "pin": "start"}]},
    }
    flat = Scene(prefabs=prefabs, generate=[{"id": "x", "place": "rope", "at": [3, 0], "angle": -90}]).flatten()
    assert [(body.id, body.position) for body in flat.bodies] == [("x.r-1", (3, -0.5)), ("x.r-2", (3, -1.5))]
    assert [(j.id, j.body_a, j.anchor_a) for j in flat.joints] == [
        ("x.r-joint-0", None, (3, 0)), ("x.r-joint-1", "x.r-1", (3, -1)),
    ]  # fmt: skip


def test_models_do_the_same():
    scene = Scene(
        prefabs={"pair": Prefab(bodies=[Body(id="a", shapes=[{"circle": 1}]), Body(id="b", shapes=[{"circle": 1}])])},
        generate=[Place(id="p", place="pair", at=(1, 1)), Row(id="q", row="pair", count=1, step=(1, 0))],
    )
    assert [body.id for body in scene.flatten().bodies] == ["p.a", "p.b", "q-1.a", "q-1.b"]


def test_a_scene_is_saved_as_it_was_written(tmp_path):
    scene = placed(at=["=1+1", 7])
    scene.save(tmp_path / "x.json")
    words = json.loads((tmp_path / "x.json").read_text())
    assert words["generate"] == [{"id": "c", "place": "cart", "at": ["=1+1", 7]}]
    assert load_scene(tmp_path / "x.json") == scene
    assert Scene(**scene.to_data()).flatten() == scene.flatten()


def test_a_body_is_found_where_it_was_written():
    prefab = '{"bodies": [\n{"id": "a", "shapes": [{"circle": 1}]}]}'
    scene = loads_scene(f'{{"prefabs": {{"p": {prefab}}}, "generate": [\n {{"id": "x", "place": "p"}}]}}')
    assert scene.locate(scene.flatten().bodies[0].pointer) == (2, 1)


A = '{"id": "a", "shapes": [{"circle": 1}]}'


@pytest.mark.parametrize(
    ("prefab", "entry", "said"),
    [
        ('"bodies": [{"id": "a", "shapes": [{"circle": @-1}]}]', '"place": "p"', "circle must not be below 1e-06 m"),
        ('"bodies": [{"id": "a", @"shapez": []}]', "", 'unknown field "shapez": did you mean "shapes"?'),
        ('"bodies": [@{"shapes": [{"circle": 1}]}]', "", '"id" is missing'),
        ('"bodies": [{"id": "a", "shapes": [{"circle": 1, "material": @"wod"}]}]', '"place": "p"',
         'no material is named "wod"'),
        ('"bodies": @5', '"place": "p"', "bodies must be a list of bodies, not a number"),
        ('"params": @[], "bodies": []', '"place": "p"', "params must be an object {...}, not a list"),
        ('"bodies": [], @"color": "red"', "",
         'a prefab of several bodies has no "color" of its own: give it to its bodies'),
        ('"params": {"r": 1}, "bodies": []', '"place": "p", "params": {@"q": 1}',
         'the prefab "p" has no parameter "q": it has r'),
        (f'"bodies": [{A}]', '"place": @"q"', 'no prefab is named "q": there is "p"'),
        (f'"bodies": [{A}]', '"row": @"p", "count": 2',
         '"step" is needed: neighbours just touch only where all are the same single body'),
        (f'"bodies": [{A}]', '"chain": @"p", "count": 2', 'a chain links bodies, and the prefab "p" has several'),
        ('"generate": [{"id": "a", "place": @"p"}]', '"place": "p"', "these prefabs contain each other: p > p"),
        ('"generate": [{"id": "a", "place": @"pp"}]', '"place": "p"', 'no prefab is named "pp": did you mean "p"?'),
        (f'"bodies": [{A}]', '"place": "p", "at": ["=@i", 0]',
         'there is no "i" here: only what a generator copies is counted'),
        (f'"bodies": [{A}]', '"place": "p", "count": 3, "at": ["=1@/(i-2)", 0]', "division by zero"),
        (f'"bodies": [{A}]', '"place": "p", "count": @100001', "count must not be above 100000"),
        (f'"bodies": [{A}], "joints": [{{"id": "j", "type": "weld", "bodies": ["a", @"b"], "anchor": [0, 0]}}]',
         '"place": "p"', 'no body has the id "x.b": did you mean "x.a"?'),
    ],
)  # fmt: skip
def test_mistakes_are_told_where_they_were_written(prefab, entry, said):
    """The sign @ stands before the place that is to be told."""
    generator = f'\n {{"id": "x", {entry}}}' if entry else ""
    before, after = f'{{"prefabs": {{"p": {{\n {prefab}}}}}, "generate": [{generator}]}}'.split("@")
    place = f"{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"
    assert one(before + after) == f"{place}: {said}"


def test_a_mistake_in_a_prefab_is_told_once_for_all_copies():
    prefabs = {"p": {"bodies": [{"id": "a", "shapes": []}]}}
    copies = [{"id": "x", "place": "p", "count": 50}]
    assert len(refused(json.dumps({"prefabs": prefabs, "generate": copies})).problems) == 1


def test_an_id_that_a_copy_has_is_taken():
    prefabs, twice = {"p": {"bodies": [{"id": "a", "shapes": [{"circle": 1}]}]}}, {"id": "x", "place": "p"}
    error = refused(json.dumps({"prefabs": prefabs, "generate": [twice, twice]}))
    assert [(problem.pointer, problem.message) for problem in error.problems] == [
        ("/generate/1/id", 'the id "x.a" is taken by a copy of a prefab')
    ]


def test_bodies_are_no_copies_of_several():
    text = '{"prefabs": {"p": {"bodies": []}}, "bodies": [{"id": "x", "prefab": "p"}]}'
    assert one(text).startswith('1:69: the prefab "p" has several bodies: place it')
    text = '{"bodies": [{"id": "x", "shapes": [{"circle": 1}], "params": {"a": 1}}]}'
    assert one(text).startswith("1:52: there is no prefab here to fill in")


KEYS = [
    "id",
    "place",
    "count",
    "at",
    "angle",
    "params",
    "bodies",
    "joints",
    "generate",
    "prefab",
    "shapes",
    "vars",
    "row",
    "step",
]
VALUES: list[Any] = [
    None, True, 0, -1, 3, 1e9, "", "=i", "=1/0", "=wheel", "=(", "cart", "ball", "loop", "c", [], {}, [1, 2],
    ["=i", "=i"], {"wheel": "=i"}, {"wheel": []}, [{}], [{"id": "a"}], [{"id": "a", "place": "cart"}], {"cart": CART},
    "M 0 0 L 1 1 Z",
]  # fmt: skip
WHOLE = {
    "vars": {"n": 2, "m": "=n"},
    "include": ["sandbox:materials"],
    "prefabs": {"ball": BALL, "cart": CART, "loop": {"generate": [{"id": "l", "place": "cart", "at": ["=n", 0]}]}},
    "bodies": [{"id": "one", "prefab": "ball", "params": {"r": "=m"}}],
    "generate": [
        {"id": "c", "place": "loop", "count": 2, "at": ["=9*i", 0]},
        {"id": "d", "row": "cart", "count": 2, "step": [5, 9]},
    ],
}


def _paths(node: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    pairs = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    return [path, *(found for key, value in pairs for found in _paths(value, (*path, key)))]


@given(st.data())
@examples(150)
def test_whatever_is_put_into_a_document(data):
    document = json.loads(json.dumps(WHOLE))
    for _ in range(data.draw(st.integers(1, 3))):
        paths = [path for path in _paths(document) if path]
        path = data.draw(st.sampled_from(paths))
        node = document
        for part in path[:-1]:
            node = node[part]
        key = data.draw(st.sampled_from(KEYS)) if isinstance(node, dict) and data.draw(st.booleans()) else path[-1]
        node[key] = json.loads(json.dumps(data.draw(st.sampled_from(VALUES))))
    text, problems = json.dumps(document), []
    try:
        scene = loads_scene(text)
    except SceneError as error:
        problems = error.problems
    else:
        assert Scene(**json.loads(text)) == scene
        assert Scene(**scene.to_data()).flatten() == scene.flatten()
    assert all(problem.line or problem.message.startswith("and at least") for problem in problems)
