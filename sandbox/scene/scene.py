"""The scene: all that an author writes, from a file or from Python."""

from __future__ import annotations

from pathlib import Path as FilePath
from typing import Any

from pydantic import BaseModel, PrivateAttr, ValidationError

from sandbox._atomic_write import write_text
from sandbox._collecting import collection_postponed
from sandbox.arguments import check_kind, check_path
from sandbox.errors import SceneError
from sandbox.notebook import Shown
from sandbox.scene.authoring.blame import Expansion
from sandbox.scene.authoring.document import Document
from sandbox.scene.authoring.expand import expanded
from sandbox.scene.authoring.python_words import as_written, in_words
from sandbox.scene.effort import one_effort
from sandbox.scene.excerpt import line_column
from sandbox.scene.finding import Finding, Path, path_of
from sandbox.scene.flat import FlatScene
from sandbox.scene.flatten import Flattener
from sandbox.scene.known import Known
from sandbox.scene.locate import locate
from sandbox.scene.pretty import scene_text
from sandbox.scene.report import scene_error
from sandbox.scene.rules import cross_checks
from sandbox.scene.scene_fields import SceneFields
from sandbox.scene.wording import findings


class Scene(Shown, SceneFields):
    """A scene; it never changes. `Scene(title=..., bodies=[...])` raises `SceneError` with every mistake."""

    _source: str = PrivateAttr("Scene")
    _text: str | None = PrivateAttr(None)
    _flat: FlatScene | None = PrivateAttr(None)
    _expansion: Expansion | None = PrivateAttr(None)
    _set: dict[str, Any] = PrivateAttr(default_factory=dict)

    def __init__(self, **data: Any) -> None:
        with one_effort(), collection_postponed():
            expansion = expanded(Document("Scene", in_words(data)))
            try:
                BaseModel.__init__(self, **expansion.data)
            except ValidationError as error:
                raise expansion.error(findings(error, type(self))) from None
            self._expansion = expansion if expansion.origins or not expansion.sound or "vars" in data else None
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

    @property
    def set_values(self) -> dict[str, Any]:
        """What was set from outside when the file was loaded, as `load_scene` takes it."""
        return dict(self._set)

    @property
    def included_files(self) -> tuple[FilePath, ...]:
        """The files that the scene's file includes, and those that these include."""
        return self._expansion.files if self._expansion is not None else ()

    @one_effort()
    def flatten(self) -> FlatScene:
        """The scene with nothing left to look up, always the same object. Raises `SceneError`."""
        if self._flat is None:
            flattener = Flattener(self)
            lacking = self._expansion.lacking if self._expansion is not None else ()
            found = cross_checks(self.to_data(), Known(lacking=lacking))
            sound = self._expansion is None or self._expansion.sound
            flat = flattener.flat() if sound and not found else None
            if not sound or found or flattener.findings:
                raise self._error(found or flattener.findings)
            self._flat = flat
        assert self._flat is not None
        return self._flat

    def _error(self, found: list[Finding]) -> SceneError:
        if self._expansion is not None:
            return self._expansion.error(found)
        return scene_error(self._source, found, self._text)

    def written(self, folder: str | FilePath | None = None) -> dict[str, Any]:
        """The scene as its author wrote it, as plain data: with its expressions, parameters and includes.

        In another `folder` than that of its file, what its includes brought stands in the scene itself.
        """
        if self._expansion is None:
            return self.to_data()
        if self._text is None:
            return {key: as_written(value) for key, value in self._expansion.main.data.items()}
        here = FilePath(self._source).resolve().parent
        return self._expansion.written(moved=folder is not None and FilePath(folder).resolve() != here)

    def save(self, path: str | FilePath, over: bool = True) -> None:
        """Write the scene as JSON (UTF-8) that loads to an equal scene; `over` a file that is there, or not.

        Raises `OSError` (`FileExistsError` for a file that is there), and `ArgumentError`; what was there stays then.
        """
        check_path("Scene.save", path)
        write_text(FilePath(path), scene_text(self.written(FilePath(path).parent)), over)

    def locate(self, pointer: str) -> tuple[int, int] | None:
        """Line and column in the scene's file of the value at a JSON pointer; None if there is no file.

        Raises `ArgumentError` for what is no text.
        """
        check_kind("Scene.locate", "a JSON pointer", pointer, str)
        if self._text is None:
            return None
        path = self.entry(path_of(pointer))
        return line_column(self._text, locate(self._text, [path])[path].value_span[0])

    def entry(self, path: Path) -> Path:
        """The path in the scene's own file of what brought the value at a path of its data; indices may be text."""
        if self._expansion is None:
            return path
        return self._expansion.entry(tuple(int(part) if str(part).isdigit() else part for part in path))

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
