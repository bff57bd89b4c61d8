"""A foreign file that has been read: its text, what it holds as plain data, and how a mistake in it is told."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sandbox.errors import Problem, SceneError
from sandbox.formats.reading import MisreadError
from sandbox.scene.finding import Finding
from sandbox.scene.report import scene_error


@dataclass(frozen=True)
class Options:
    """How a file is to be read.

    `units_per_metre`: how many units of the file make a metre, None: as its format has it. `tolerance`: how far, in
    metres, flat sides may lie from the curve that they stand for. `solid`: names of layers of a map that are solid all
    over.
    """

    units_per_metre: float | None = None
    tolerance: float = 0.01
    solid: tuple[str, ...] = ()


@dataclass(frozen=True)
class Source:
    """A file: where it is, its text, and its contents (of XML the root element, of a recording
    the bytes, else parsed JSON)."""

    path: Path
    text: str
    data: Any
    line_of: Callable[[tuple[str | int, ...]], int] | None = None

    def error(self, misread: MisreadError) -> SceneError:
        """The error that a user sees, with the place of what cannot be used."""
        if isinstance(self.data, bytes):
            return scene_error(str(self.path), [Finding((), misread.message, misread.hint)], None)
        if self.line_of is None:
            return scene_error(str(self.path), [Finding(misread.path, misread.message, misread.hint)], self.text)
        problem = Problem(misread.message, hint=misread.hint, line=self.line_of(misread.path), column=1)
        return SceneError(str(self.path), [problem])
