"""Every mistake is told in one plain line, at its place, all of them at once."""

from __future__ import annotations

import json

import pytest

from sandbox.scene.finding import Finding
from sandbox.scene.limits import MAX_ALIKE, MAX_BODIES, MAX_PROBLEMS
from sandbox.scene.report import told
from tests.scene.scene_helpers import refused

BALL = '{"id": "ball", "shapes": [{"circle": 1}]}'


def body(fields: str) -> str:
    return f'{{"bodies": [\n{{"id": "it", {fields}}}\n]}}'


def shape(fields: str) -> str:
    return f'{{"bodies": [{{"id": "it", "type": "static", "shapes": [\n{{{fields}}}\n]}}]}}'


def region(fields: str) -> str:
    return f'{{"regions": [\n{{{fields}}}\n]}}'


def expect(fields: str) -> str:
    return f'{{"bodies": [{BALL}], "expect": [\n{{{fields}}}\n]}}'


def generate(fields: str) -> str:
    return f'{{"prefabs": {{"crate": {{"shapes": [{{"circle": 1}}]}}}}, "generate": [\n{{"id": "g", {fields}}}\n]}}'


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('{"format": 2}', "1:12: format must be 1"),
        ('{"format": true}', "1:12: format must be 1"),
        ('{"format": 1.0}', "1:12: format must be 1"),
        ('{"bodys": []}', '1:2: unknown field "bodys": did you mean "bodies"?'),
        ('{"gravity": -9.81}', "1:13: gravity must be a list [x, y], not a number"),
        ('{"gravity": [0]}', "1:13: gravity needs 2 entries, [x, y], and has 1"),
        ('{"gravity": [0, "down"]}',
         '1:17: gravity[1] must be a number, not text: an expression begins with "=", as in "=9.81 / 6"'),
        (body('"shapes": [{"circle": 1}], "mass": "20"'),
         "2:49: mass must be a number, not text: take the quotes away"),
        (body('"shapes": [{"circle": 1}], "mass": "20 kg"'),
         "2:49: mass must be a number, not text: a number stands without its unit and quotes"),
        (body('"shapes": [{"circle": 1}], "bullet": "true"'),
         "2:51: bullet must be true or false, not text: take the quotes away"),
        ('{"gravity": [0, 0x10]}',
         "1:18: not a valid number: a number is decimal and stands without its unit, as in 16 or 1.6e3"),
        ('{"gravity": [0, 9.81m]}',
         "1:21: not a valid number: a number is decimal and stands without its unit, as in 16 or 1.6e3"),
        ('{"gravity": [0, 9.]}', "1:18: not a valid number: a point has digits on both sides, and there is one"),
        ('{"gravity": [0, 9/2]}',
         '1:18: not a valid number: an expression is text that begins with "=", as in "=1 / 2"'),
        ('{"gravity": [0, NaN]}', "1:17: gravity[1] must be a finite number"),
        ('{"gravity": [0, -Infinity]}', "1:17: gravity[1] must be a finite number"),
        ('{"gravity": [0, 1e999]}', "1:17: gravity[1] must be a finite number"),
        ('{"title": 5}', "1:11: title must be text, not a number"),
        ('{"title": "a", "title": "b"}', '1:16: "title" is given twice'),
        ('{"settings": {"step_rate": 0}}', "1:28: step_rate must not be below 1 Hz"),
        ('{"settings": {"substeps": 2.5}}', "1:27: substeps must be a whole number"),
        ('{"settings": {"sleeping": 1}}', "1:27: sleeping must be true or false, not a number"),
        ('{"view": {"centre": [0, 0]}}', '1:11: unknown field "centre": did you mean "center"?'),
        ('{"materials": {"view": {"densty": 1}}}', '1:25: unknown field "densty": did you mean "density"?'),
        (shape('"chain": [[0, 0], [1, 0]], "one_side": true'),
         '2:29: unknown field "one_side": did you mean "one_sided"?'),
        ('{"substeps": 2}', '1:2: unknown field "substeps": it belongs in "settings"'),
        (
            '{"settings": {"gravity": [0, 0]}}',
            '1:15: unknown field "gravity": it belongs in the scene itself',
        ),
        ('{"materials": {"w d": {}}}', '1:16: the name "w d" must be 1 to 100 letters, digits or any of _ - . :'),
        ('{"materials": {"w": {"friction": -1}}}', "1:34: friction must not be negative"),
        ('{"materials": {"w": {"density": 1e-9}}}', "1:33: density must be 0 or at least 1e-06 kg/m^2"),
        ('{"categories": ["default"]}', '1:17: the category "default" is there already'),
        ('[]', "1:1: must be an object {...}, not a list"),
        ('{"bodies": {}}', "1:12: bodies must be a list of bodies, not an object"),
        ('{"bodies": [5]}', "1:13: bodies[0] must be an object {...}, not a number"),
        ('{"bodies": [{"shapes": [{"circle": 1}]}]}', '1:13: "id" is missing'),
        (f'{{"bodies": [{BALL},\n{BALL}]}}', '2:8: the id "ball" is taken by bodies[0]'),
        (body('"shpaes": []'), '2:14: unknown field "shpaes": did you mean "shapes"?'),
        (body('"type": "static"'), '2:1: the body "it" has no shapes: give it one, as in "shapes": [{"circle": 0.5}]'),
        (body('"shapes": []'), "2:24: shapes needs at least 1 entry and has 0"),
        (body('"shapes": [{"circle": 1}], "type": "dinamic"'),
         '2:49: type must be one of "static", "kinematic", "dynamic": did you mean "dynamic"?'),
        (body('"shapes": [{"circle": 1}], "friction": 1'),
         '2:41: unknown field "friction": it belongs in a material or a shape'),
        (body('"shapes": [{"circle": 1}], "position": [2e9, 0]'), "2:54: position[0] must not be above 1e+09 m"),
        (body('"shapes": [{"circle": 1}], "color": "redd"'),
         '2:50: color must be a colour such as "#3a7bd5" or "tomato": did you mean "red"?'),
        (body('"shapes": [{"circle": 1}], "material": "wood"'), '2:53: no material is named "wood"'),
        (body('"prefab": "crate"'), '2:24: no prefab is named "crate"'),
        (body('"shapes": [{"segment": [[0, 0], [1, 0]]}]'),
         "2:1: a dynamic body without mass: give its shapes a density and an area, or give it a mass"),
        (shape('"cirlce": 1'), '2:2: unknown field "cirlce": did you mean "circle"?'),
        (shape('"at": [0, 0]'), '2:1: a shape needs one of "circle", "box", "capsule", "segment", "polygon", "chain"'),
        (shape('"circle": 1, "box": [1, 1]'), '2:15: a shape has one kind, and this one has "circle" and "box"'),
        (shape('"circle": 0'), "2:12: circle must not be below 1e-06 m"),
        (shape('"circle": true'), "2:12: circle must be a number, not true or false"),
        (shape('"circle": 1, "angle": 5'), '2:15: unknown field "angle": it belongs in a shape or a body'),
        (shape('"box": 1'), "2:9: box must be a list [width, height], not a number"),
        (shape('"box": [2, 1], "radius": 0.5'),
         "2:27: the radius must be less than half the box's smaller side (0.5 m): a box rounded that far is a capsule"),
        (shape('"capsule": [[1, 1], [1, 1]], "radius": 1'), "2:22: the two ends are the same point"),
        (shape('"capsule": [[1, 1], [2, 1]]'), '2:1: "radius" is missing'),
        (shape('"polygon": [[0, 0], [1, 1]]'), "2:13: polygon needs at least 3 entries and has 2"),
        (shape('"polygon": [[0, 0], [1, 1], [2, 2]]'),
         "2:13: the polygon has no area: its vertices lie on one line"),
        (shape('"polygon": [[0, 0], [2, 2], [2, 0], [0, 2]]'), "2:14: the polygon intersects itself"),
        (shape(f'"polygon": {[[k, k * k] for k in range(1001)]}'), "2:13: polygon has 1001 entries; 1000 is the limit"),
        (shape('"polygon": [[0, 0], [4, 0], [1, 1], [0, 4]], "radius": 0.1'),
         "2:57: radius must be 0 for a polygon that is concave or has holes"),
        (shape('"polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [[[1, 1], [2, 1], [2, 2]]], "radius": 0.1'),
         "2:94: radius must be 0 for a polygon that is concave or has holes"),
        (shape('"polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [[[1, 1], [2, 1], [2, 5]]]'),
         "2:66: the hole meets the polygon's outline"),
        (shape('"polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [[[6, 1], [7, 1], [7, 5]]]'),
         "2:58: the hole lies outside of the polygon"),
        (shape('"polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [[[1, 1], [2, 2], [3, 3]]]'),
         "2:57: the hole has no area: its vertices lie on one line"),
        (shape('"polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [[[0, 1], [2, 1], [2, 2]]]'),
         "2:58: the hole meets the polygon's outline"),
        (shape('"polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [[[1, 1], [3, 3], [3, 1], [1, 3]]]'),
         "2:58: the hole intersects itself"),
        (shape('"polygon": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [[[1, 1], [2, 2]]]'),
         "2:57: holes[0] needs at least 3 entries and has 2"),
        (shape('"circle": 1, "category": "payer"'), '2:27: no category is named "payer": list it in "categories"'),
        (shape('"circle": 1, "mask": 1.5'),
         "2:23: mask must be a category name, a list of names, or a whole number used as bits, not 1.5"),
        (shape('"circle": 1, "mask": -1'), "2:23: mask must not be negative"),
        (expect('"rests": "ball"'),
         '2:1: an expectation needs a time: "at": step, "always": true, or "within": [first, last]'),
        (expect('"at": 1, "always": true, "rests": "ball"'),
         '2:11: an expectation has one time, and this one has "at" and "always"'),
        (expect('"always": false, "rests": "ball"'), "2:12: always must be true"),
        (expect('"always": 1, "rests": "ball"'), "2:12: always must be true"),
        (expect('"at": 1.5, "rests": "ball"'), "2:8: at must be a whole number"),
        (expect('"within": [9, 1], "rests": "ball"'),
         "2:12: within the first number must not be greater than the second"),
        (expect('"at": 1, "rests": "bal"'), '2:20: no body has the id "bal": did you mean "ball"?'),
        (expect('"at": 1, "rests": ["ball", "x-*"]'), '2:29: no body\'s id matches "x-*"'),
        (expect('"at": 1, "rests": 5'),
         '2:20: rests must be a body id, a list of ids, or a pattern such as "wall-*", not a number'),
        (expect('"at": 1, "inside": [1, 1, 0, 0]'),
         "2:21: inside must be [left, bottom, right, top] with left < right and bottom < top"),
        (expect('"at": 1, "rest": "ball"'), '2:11: unknown field "rest": did you mean "rests"?'),
        (expect('"at": 1, "near": [0, 0]'), '2:1: "of" is missing'),
        (region('"watr": 1'), '2:2: unknown field "watr": did you mean "water"?'),
        (region('"water": 1, "surfce": 0'), '2:14: unknown field "surfce": did you mean "surface"?'),
        (region('"inside": [0, 0, 1, 1]'),
         '2:1: a region needs one of "water", "gravity", "gravity_scale", "attraction", "wind"'),
        (region('"water": 1, "wind": [0, 0]'), '2:14: a region has one kind, and this one has "water" and "wind"'),
        (region('"wind": [5, 0], "inside": [0, 0, 1, 1], "disc": [0, 0, 1]'),
         '2:42: a region has one area, and this one has "inside" and "disc"'),
        (region('"wind": [5, 0], "outline": [[0, 0], [2, 0], [1, 0.5], [0, 2]]'),
         "2:29: the area is not convex; use several regions"),
        (region('"attraction": 5, "falloff": 4'), "2:30: falloff must not be above 3"),
        (region('"water": 1, "start": 3, "end": 3'), '2:33: "end" must be later than "start" (3 s)'),
        (body('"shapes": [{"circle": 1}], "thrusters": [{"forc": [1, 0], "force": [1, 0]}]'),
         '2:56: unknown field "forc": did you mean "force"?'),
        (body('"type": "static", "shapes": [{"circle": 1}], "thrusters": [{"force": [1, 0]}]'),
         "2:72: a static body cannot be pushed: make it dynamic"),
        (generate('"row": "crate"'), '2:1: "count" is missing'),
        (generate('"row": "crte", "count": 2'), '2:20: no prefab is named "crte": did you mean "crate"?'),
        (generate('"row": "crate", "count": 0'), "2:38: count must not be below 1"),
        (generate('"heap": "crate", "count": 2'),
         '2:13: unknown field "heap": a generator needs one of "place", "row", "stack", "grid", "pyramid", '
         '"scatter", "chain"'),
        (generate('"row": "crate", "cuont": 2'), '2:29: unknown field "cuont": did you mean "count"?'),
    ],
)  # fmt: skip
def test_one_mistake_is_one_line(text, told):
    lines = [line for line in refused(text).lines() if line.startswith("x.json:")]
    assert lines[0].removeprefix("x.json:") == told
    assert len(lines) == 1


def test_the_vertices_of_holes_count_as_well():
    ring = [[k, k * k] for k in range(501)]
    (line,) = (line for line in refused(shape(f'"polygon": {ring}, "holes": [{ring}]')).lines() if "x.json" in line)
    assert line.endswith("the polygon and its holes have 1002 vertices; 1000 is the limit")


def test_all_mistakes_are_told_at_once_in_the_order_of_the_file():
    error = refused(
        """{
  "expect": [{"at": 300, "rests": "crat"}],
  "titel": "x", "titel": "y",
  "bodies": [
    {"id": "crate", "shpaes": [{"box": [1, 1]}], "position": [0, "5"]},
    {"id": "crate", "shapes": [{"circle": NaN}, {"box": [1, 1], "material": "wod"}]}
  ],
  "materials": {"wood": {}}
}"""
    )
    assert [(p.line, p.column, p.pointer) for p in error.problems] == [
        (2, 35, "/expect/0/rests"),
        (3, 17, "/titel"),
        (3, 17, "/titel"),
        (5, 21, "/bodies/0/shpaes"),
        (5, 66, "/bodies/0/position/1"),
        (6, 12, "/bodies/1/id"),
        (6, 43, "/bodies/1/shapes/0/circle"),
        (6, 77, "/bodies/1/shapes/1/material"),
    ]


def test_the_excerpt_shows_the_line_and_a_caret():
    problem = refused('{"title": "x",\n\t"gravty": [0, 0]}').problems[0]
    assert problem.message == 'unknown field "gravty"'
    assert problem.hint == 'did you mean "gravity"?'
    assert problem.excerpt == '    2 |  "gravty": [0, 0]}\n      |  ^^^^^^^^'


def test_the_excerpt_of_a_long_line_keeps_the_caret_in_sight():
    text = '{"about": "' + "x" * 500 + '", "titel": "y"}'
    shown, carets = refused(text).problems[0].excerpt.splitlines()
    assert len(shown) < 120
    start = carets.index("^")
    assert shown[start : start + carets.count("^")] == '"titel"'


def test_a_thousand_mistakes_are_told_in_part():
    bodies = ",\n".join(json.dumps({"id": f"a{k}", "shpaes": 1}) for k in range(1000))
    error = refused(f'{{"bodies": [\n{bodies}]}}')
    assert len(error.problems) == MAX_ALIKE + 1
    assert error.problems[-1].message == 'and at least 990 more like this: unknown field "shpaes"'
    assert error.problems[0].line == 2


def test_mistakes_of_many_sorts_are_told_in_part():
    names = [a + b for a in "abcdefghijklmnop" for b in "qrstuvwxyz"]
    sorts = [Finding(("bodies",), f"mistake {name}") for name in names]
    problems = told(sorts)
    assert len(problems) == MAX_PROBLEMS + 1
    assert problems[-1].message == "and at least 60 more mistakes"


@pytest.mark.slow
def test_too_many_bodies_are_one_mistake():
    text = json.dumps({"bodies": [{"id": f"b{k}", "prefab": "p"} for k in range(MAX_BODIES + 1)]})
    assert "bodies has 100001 entries; 100000 is the limit" in str(refused(text))


def test_lone_surrogates_never_reach_the_terminal():
    str(refused('{"\\ud800": "\\ud800", "title": "\\ud800"}')).encode("utf-8")
