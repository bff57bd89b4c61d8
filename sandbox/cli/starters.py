"""The scenes that `sandbox new` begins with: one file a theme in `starter_scenes/`, held to be sound by tests."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from sandbox.errors import SandboxError
from sandbox.resources import SCENE_SUFFIX

FOLDER = Path(__file__).with_name("starter_scenes")
THEMES = ("stack", "joints", "vehicle", "machine", "game", "fluid", "space", "sat")
"""From the plainest on; the first is the one for who names none."""


@dataclass(frozen=True)
class Starter:
    """A scene by theme: its text, and what it says of itself; the last of the `lines` says what to try."""

    theme: str
    text: str
    title: str
    about: str
    lines: tuple[str, ...]


def starter(theme: str) -> Starter:
    """The scene of a theme. Raises `SandboxError` with the nearest name if there is none."""
    if theme not in THEMES:
        from sandbox.scene.near_names import did_you_mean

        raise SandboxError(
            f"there is no starter {theme!r}; {did_you_mean(theme, THEMES) or 'there are ' + ', '.join(THEMES)}"
        )
    text = (FOLDER / (theme + SCENE_SUFFIX)).read_text(encoding="utf-8")
    data = json.loads(text)
    return Starter(theme, text, data["title"], data["about"], tuple(data["$comment"]))


def with_schema(text: str, output: Path) -> str:
    """The text with `$schema`, if `scene.schema.json` lies beside `output` or in one of the three folders above."""
    from sandbox.scene.layout import laid_out

    folders = [output.absolute().parent, *output.absolute().parent.parents][:4]
    for number, folder in enumerate(folders):
        if (folder / "scene.schema.json").is_file():
            address = json.dumps("../" * number + "scene.schema.json")
            return laid_out(text.replace("{", f'{{"$schema": {address}, ', 1))
    return text
