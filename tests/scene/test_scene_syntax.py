"""What is no JSON, or not enough like it, is told in plain words at its place."""

from __future__ import annotations

import json

import pytest

from sandbox.scene import loads_scene
from sandbox.scene.limits import MAX_DEPTH
from tests.scene.scene_helpers import one

HALF = 'half a character: a character that takes two such halves has both: "\\ud83d\\ude00"'


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", '1:1: the file is empty: a scene is an object: {"bodies": [...]}'),
        ("  \n ", '1:1: the file is empty: a scene is an object: {"bodies": [...]}'),
        ('{"title": "a",}', "1:14: a trailing comma: take it away: nothing follows it"),
        ('{"gravity": [0, 1,]}', "1:18: a trailing comma: take it away: nothing follows it"),
        ('{"title": "a"', "1:14: the file ends too early: the \"{\" at 1:1 is not closed by a \"}\""),
        ('{"title": "a" "about": ""}', "1:15: a comma is missing before this"),
        ('{"title" "a"}', '1:10: a ":" is missing after the field\'s name'),
        ('{title: "a"}', "1:2: a field's name is due here: in double quotes"),
        ("{'title': 1}", "1:2: text stands in double quotes"),
        ('{"title": \'a\'}', "1:11: text stands in double quotes"),
        ('{"title": “a”}', "1:11: text stands in straight double quotes"),
        ('{"a": 1,5}', "1:9: a field's name is due here: if this is a decimal, it has a point, as in 1.5"),
        ('{\n  // hello\n}', '2:3: JSON has no comments: an object may have one as a field, "$comment": "..."'),
        ('{"title": "a}\n}', '1:11: text must end on the line it begins: close it with " (a line break inside is \\n)'),
        ('{"title": "a\tb"}', "1:13: a control character within text: write it with a backslash: a tab is \\t"),
        ('{"title": "\\q"}', "1:12: not a valid \\ escape: a backslash itself is \\\\"),
        ('{"title": "a\\ud83d"}', f"1:13: {HALF}"),
        ('{"title": "\\ude00\\ud83d"}', f"1:12: {HALF}"),
        ('{"title": "\\\\\\uD800x"}', f"1:14: {HALF}"),
        ('{"bodies": [{"id": "\\udbff\\u0041"}]}', f"1:21: {HALF}"),
        ('{"title": True}', '1:11: True is not JSON: did you mean "true"?'),
        ('{"title": None}', '1:11: None is not JSON: did you mean "null"?'),
        ('{"title": hello}', "1:11: a value is due here: text stands in double quotes"),
        ('{"gravity": [0, .5]}', "1:17: not a valid number: a number begins with a digit or -, as in 0.5 or -0.5"),
        ('{"gravity": [0, +5]}', "1:17: not a valid number: a number begins with a digit or -, as in 0.5 or -0.5"),
        ('{"gravity": [0, 05]}', "1:18: a number must not begin with 0"),
        ("{} {}", "1:4: the scene has ended before this: a file holds one object"),
        ('{"a": ' * 40 + "1" + "}" * 40, "1:193: nested deeper than 32 levels"),
        ("[" * 100_000, "1:33: nested deeper than 32 levels"),
    ],
)  # fmt: skip
def test_what_is_no_json_is_told_at_its_place(text, told):
    assert one(text) == told


def test_a_scene_of_the_allowed_depth_is_read():
    deep = '{"x": ' + "[" * (MAX_DEPTH - 1) + "]" * (MAX_DEPTH - 1) + "}"
    assert one(deep) == '1:2: unknown field "x"'


def test_brackets_in_texts_are_not_nesting():
    assert loads_scene(json.dumps({"about": "[" * 100})).about == "[" * 100


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('{"bodies": [{"id": "a"]}', '1:23: a "}" is missing before this: the "{" at 1:13 is not closed by a "}"'),
        ('{"gravity": [0, 1}', '1:18: a "]" is missing before this: the "[" at 1:13 is not closed by a "]"'),
        ('{"bodies": [{"id": "]}"}', '1:25: the file ends too early: the "[" at 1:12 is not closed by a "]"'),
        ('{"bodies": {"id": "a"}, {"id": "b"}]}',
         '1:25: a field\'s name is due here: the "{" at 1:1 is not closed by a "}", '
         "or objects are to stand in a list [...]"),
        ('{"title": "a, "about": "b"}',
         '1:16: the text ends before this: a " is missing or too much; within a text it is \\"'),
        ('{"title": "a "best" game"}',
         '1:15: the text ends before this: a " is missing or too much; within a text it is \\"'),
    ],
)  # fmt: skip
def test_the_bracket_or_quote_that_is_not_closed_is_named(text, told):
    assert one(text) == told


def test_both_halves_and_what_only_looks_like_one_are_text() -> None:
    text = '{"title": "\\ud83d\\ude00 \\\\ud83d \\u00e9"}'
    assert loads_scene(text).title == json.loads(text)["title"] == "\U0001f600 \\ud83d \xe9"
