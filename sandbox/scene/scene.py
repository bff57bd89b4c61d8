"""The scene: all that an author writes, from a file or from Python."""

from __future__ import annotations

from pathlib import Path as FilePath
from typing import Any

from pydantic import PrivateAttr

from sandbox._atomic_write import write_text
from sandbox.notebook import Shown
from sandbox.scene.effort import one_effort
from sandbox.scene.excerpt import line_column
from sandbox.scene.finding import path_of
from sandbox.scene.flat import FlatScene
from sandbox.scene.flatten import Flattener
from sandbox.scene.locate import locate
from sandbox.scene.pretty import scene_text
from sandbox.scene.report import scene_error
from sandbox.scene.rules import cross_checks
from sandbox.scene.scene_fields import SceneFields


class Scene(Shown, SceneFields):
    """A scene; it never changes. `Scene(title=..., bodies=[...])` raises `SceneError` with every mistake."""

    _source: str = PrivateAttr("Scene")
    _text: str | None = PrivateAttr(None)
    _flat: FlatScene | None = PrivateAttr(None)

    def __init__(self, **data: Any) -> None:
        super().__init__(**data)
        self.flatten()

    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    @property
    def source(self) -> str:
        """The file the scene came from, or "Scene"."""
        return self._source

    @property
    def text(self) -> str | None:
        """The file's text; None for a scene built in Python."""
        return self._text

    @one_effort()
    def flatten(self) -> FlatScene:
        """The scene with nothing left to look up, always the same object. Raises `SceneError`."""
        if self._flat is None:
            flattener = Flattener(self)
            findings = cross_checks(self.to_data())
            flat = None if findings else flattener.flat()
            if findings or flattener.findings:
                raise scene_error(self._source, findings or flattener.findings, self._text)
            self._flat = flat
        assert self._flat is not None
        return self._flat

    def save(self, path: str | FilePath) -> None:
        """Write the scene as JSON (UTF-8) that loads to an equal scene. Raises `OSError`; what was there stays then."""
        write_text(FilePath(path), scene_text(self.to_data()))

    def locate(self, pointer: str) -> tuple[int, int] | None:
        """Line and column in the scene's file of the value at a JSON pointer; None if there is no file."""
        if self._text is None:
            return None
        path = path_of(pointer)
        return line_column(self._text, locate(self._text, [path])[path].value_span[0])

    def model_copy(self, *, update: Any = None, deep: bool = False) -> Scene:
        """A new scene with the fields in `update` changed, checked like any other."""
        changed = {**self.given(), **(update or {})}
        aliases = {name: field.alias or name for name, field in type(self).model_fields.items()}
        return type(self)(**{aliases.get(name, name): value for name, value in changed.items()})

    def __copy__(self) -> Scene:
        """Itself, as it never changes."""
        return self

    def __deepcopy__(self, memo: Any = None) -> Scene:
        """Itself, as it never changes."""
        return self

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self.__dict__ == other.__dict__

    __hash__ = None  # type: ignore[assignment]
