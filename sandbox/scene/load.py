"""From a file or a text to a scene, or to one error with every mistake in it."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from sandbox._collecting import collection_postponed
from sandbox._lent import is_lent
from sandbox.arguments import check_kind, check_path
from sandbox.errors import Problem, SceneError
from sandbox.scene.authoring.blame import Expansion
from sandbox.scene.authoring.changes import check_numbers_set, with_changes
from sandbox.scene.authoring.document import Document
from sandbox.scene.authoring.expand import expanded
from sandbox.scene.effort import one_effort
from sandbox.scene.flatten import Flattener
from sandbox.scene.known import Known
from sandbox.scene.known_file import is_recording
from sandbox.scene.parse import parse
from sandbox.scene.plain import mapping
from sandbox.scene.read import read_text
from sandbox.scene.rules import cross_checks
from sandbox.scene.scene import Scene
from sandbox.scene.wording import findings


def load_scene(path: str | os.PathLike[str], set: Mapping[str, Any] | None = None) -> Scene:
    """The scene in a file, with the values of `set` for what stands there, as in `{"vars.rows": 40}`.

    Raises `SceneError` with every mistake and its line and column, and `ArgumentError`.
    """
    check_path("load_scene", path)
    return loads_scene(read_text(Path(path)), str(path), set)


@one_effort()
@collection_postponed()
def loads_scene(text: str, source: str = "<string>", set: Mapping[str, Any] | None = None) -> Scene:
    """The scene in a JSON text; `source` names it in messages, and is the file beside which includes are looked for.

    `set` as in `load_scene`. Raises `SceneError` and `ArgumentError`.
    """
    check_kind("loads_scene", "a text", text, str)
    check_kind("loads_scene", "the name of its source", source, str)
    _check_values(set)
    text = text.removeprefix("\ufeff")
    parsed = parse(text, source)
    if is_recording(parsed.data):
        mend = "sandbox replay runs it again, sandbox run and sandbox render show it"
        raise SceneError(source, [Problem("this is a recording, not a scene", hint=mend)])
    numbers = list(mapping(mapping(parsed.data).get("vars")))
    changed = with_changes(parsed.data, set or {}, source)
    expansion = expanded(Document(source, parsed.data, text, _file(source), changed, parsed.repeats))
    check_numbers_set(expansion, numbers)
    found = cross_checks(expansion.data, Known(lacking=expansion.lacking))
    try:
        scene = Scene.model_validate(expansion.data)
    except ValidationError as error:
        raise expansion.error(findings(error, Scene) + found) from None
    if found or not expansion.sound:
        raise expansion.error(found)
    scene._set = dict(set or {})
    return _checked(scene, expansion)


def _check_values(values: Any) -> None:
    """Raises `ArgumentError` unless values are by their paths."""
    if values is None:
        return
    check_kind("set", 'a dictionary of values by their paths, such as {"vars.rows": 40}', values, Mapping)
    for path in values:
        check_kind("set", "values by their paths, which are texts", path, str)


def _checked(scene: Scene, expansion: Expansion) -> Scene:
    """The scene with its origin and its flat form noted, once that shows no mistakes either."""
    flattener = Flattener(scene)
    flat = flattener.flat()
    if flattener.findings:
        raise expansion.error(flattener.findings)
    scene._source, scene._text, scene._flat = expansion.main.source, expansion.main.text, flat
    scene._expansion = expansion if expansion.origins or expansion.files else None
    return scene


def _file(source: str) -> Path | None:
    """The file that a text is from, if it is one; what a shell lends is in no folder, whatever is behind it."""
    try:
        return Path(source) if Path(source).is_file() and not is_lent(Path(source)) else None
    except (OSError, ValueError):
        return None
