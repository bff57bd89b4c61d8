"""Mistakes in chains and one-way shapes are told at their place."""

from __future__ import annotations

import json

import pytest

from sandbox.errors import SandboxError
from sandbox.scene.load import loads_scene

MISTAKES = [
    ({"chain": [[0, 0]]}, "chain"),
    ({"chain": [[0, 0], [1, 0], [1, 0]]}, "the same as the one before it"),
    ({"chain": [[0, 0], [1, 0]], "closed": True}, "needs 3 points"),
    ({"chain": [[0, 0], [1, 0], [1, 1], [0, 0]], "closed": True}, "leave out the last one"),
    ({"chain": [[0, 0], [1, 0], [1, 1]], "closed": True, "ghosts": [[9, 9], [8, 8]]}, "no ends"),
    ({"chain": [[0, 0], [1, 0]], "ghosts": [[-1, 0], [1, 0]]}, "the end of the chain itself"),
    ({"box": [1, 1], "one_way": [0, 0]}, "a direction such as"),
]


@pytest.mark.parametrize(("shape", "words"), MISTAKES)
def test_a_mistake_is_told(shape, words):
    text = json.dumps({"bodies": [{"id": "a", "type": "static", "shapes": [shape]}]})
    with pytest.raises(SandboxError, match=words):
        loads_scene(text)
