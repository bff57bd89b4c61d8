"""Loads texts that must be refused."""

from __future__ import annotations

import pytest

from sandbox.errors import SceneError
from sandbox.scene import loads_scene


def refused(text: str) -> SceneError:
    with pytest.raises(SceneError) as caught:
        loads_scene(text, "x.json")
    return caught.value


def one(text: str) -> str:
    """The one mistake of a text, as `line:column: message`."""
    lines = [line for line in refused(text).lines() if line.startswith("x.json")]
    assert len(lines) == 1
    return lines[0].removeprefix("x.json:")
