"""From a file or a text to a scene, or to one error with every mistake in it."""

from __future__ import annotations

import os
from pathlib import Path

from pydantic import ValidationError

from sandbox.arguments import check_kind
from sandbox.errors import Problem, SceneError
from sandbox.scene.effort import one_effort
from sandbox.scene.flatten import Flattener
from sandbox.scene.known_file import is_recording
from sandbox.scene.parse import parse
from sandbox.scene.read import read_text
from sandbox.scene.report import scene_error
from sandbox.scene.rules import cross_checks
from sandbox.scene.scene import Scene
from sandbox.scene.wording import findings


def load_scene(path: str | os.PathLike[str]) -> Scene:
    """The scene in a file. Raises `SceneError` with every mistake and its line and column."""
    check_kind("load_scene", "the path of a file", path, str, os.PathLike)
    return loads_scene(read_text(Path(path)), str(path))


@one_effort()
def loads_scene(text: str, source: str = "<string>") -> Scene:
    """The scene in a JSON text; `source` names it in messages. Raises `SceneError`."""
    check_kind("loads_scene", "a text", text, str)
    text = text.removeprefix("\ufeff")
    parsed = parse(text, source)
    if is_recording(parsed.data):
        mend = "sandbox replay runs it again, sandbox run and sandbox render show it"
        raise SceneError(source, [Problem("this is a recording, not a scene", hint=mend)])
    found = parsed.repeats + cross_checks(parsed.data)
    try:
        scene = Scene.model_validate(parsed.data)
    except ValidationError as error:
        raise scene_error(source, findings(error, Scene) + found, text) from None
    if found:
        raise scene_error(source, found, text)
    return _checked(scene, source, text)


def _checked(scene: Scene, source: str, text: str) -> Scene:
    """The scene with its origin and its flat form noted, once that shows no mistakes either."""
    flattener = Flattener(scene)
    flat = flattener.flat()
    if flattener.findings:
        raise scene_error(source, flattener.findings, text)
    scene._source, scene._text, scene._flat = source, text, flat
    return scene
