"""Laying a JSON text out anew changes white space and nothing else."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sandbox.scene.layout import WIDTH, laid_out
from tests.examples import examples
from tests.shipped import FILES

NUMBERS = ["0", "-0", "1.0", "1e-3", "1E+5", "-2.50", "0.1e1", "123456789012345678901234567890"]
STRINGS = ['"\\u00b0"', '"a, b"', '"{\\"x\\": [1]}"', '"\\\\"', '"with a \\/ slash"', '"é"', '""']
LEAVES = st.sampled_from([*NUMBERS, *STRINGS, "true", "null"]) | st.integers().map(str)
SPACE = st.sampled_from(["", " ", "\n", "\n\n  ", "\t", "\r\n"])
WITHIN_STRINGS = re.compile(r'"(?:[^"\\]|\\.)*"|\s+')


def contents(text: str) -> str:
    """A JSON text without the white space between its tokens."""
    return WITHIN_STRINGS.sub(lambda match: match[0] if match[0][0] == '"' else "", text)


@st.composite
def spaced(draw: Any, tokens: list[str]) -> str:
    """Tokens with any white space between them."""
    return "".join(draw(SPACE) + token for token in tokens)


def listed(members: list[list[str]]) -> list[str]:
    return ["[", *[token for member in members for token in [",", *member]][1:], "]"]


def keyed(members: list[tuple[str, list[str]]]) -> list[str]:
    return ["{", *[token for key, value in members for token in [",", key, ":", *value]][1:], "}"]


KEYS = st.sampled_from(['"$schema"', '"format"', '"bodies"', '"id"', '"a rather long name of a field"'])
VALUES = st.recursive(
    LEAVES.map(lambda leaf: [leaf]),
    lambda inner: (
        st.lists(inner, max_size=12).map(listed) | st.lists(st.tuples(KEYS, inner), max_size=8).map(keyed)
    ),
    max_leaves=60,
)  # fmt: skip


@given(st.data())
@examples(150)
def test_only_white_space_changes_and_once_is_enough(data: Any) -> None:
    text = data.draw(spaced(data.draw(VALUES)))
    laid = laid_out(text)
    assert contents(laid) == contents(text)
    assert laid_out(laid) == laid
    assert laid.endswith("\n")
    for line in laid.splitlines():
        assert line == line.rstrip()
        # A line that is too long holds one member that cannot be parted.
        assert len(line) <= WIDTH or not re.search(r"[}\]],? [\[{]", WITHIN_STRINGS.sub(" ", line))


@given(VALUES)
@examples(50)
def test_what_stood_on_one_line_has_one_layout(tokens: list[str]) -> None:
    assert laid_out("".join(tokens)) == laid_out("  ".join(tokens))


def test_numbers_and_texts_keep_how_they_are_written() -> None:
    text = '{"a": 1e-3, "b": [1.0, -0, 0.10], "c": "\\u00b0"}'
    assert laid_out(text) == '{\n  "a": 1e-3,\n  "b": [1.0, -0, 0.10],\n  "c": "\\u00b0"\n}\n'


def test_breaks_between_fields_stay_and_those_within_short_lists_go() -> None:
    long = ", ".join(["0.12345"] * 10)
    text = f'{{"bodies": [{{"id": "a", "position": [1,\n 2],\n"first": [{long}], "last": 1}}]}}'
    assert laid_out(text).splitlines() == [
        "{",
        '  "bodies": [',
        "    {",
        '      "id": "a", "position": [1, 2],',
        f'      "first": [{long}], "last": 1',
        "    }",
        "  ]",
        "}",
    ]


@pytest.mark.parametrize("name", FILES)
def test_shipped_scenes_are_laid_out(name: str) -> None:
    text = FILES[name].read_text(encoding="utf-8")
    assert laid_out(text) == text, "sandbox fmt scenes"


def test_a_minified_scene_comes_out_fit_to_read() -> None:
    text = FILES["breakout"].read_text(encoding="utf-8")
    laid = laid_out(json.dumps(json.loads(text), separators=(",", ":")))
    assert max(map(len, laid.splitlines())) < 160
    assert json.loads(laid) == json.loads(text)
