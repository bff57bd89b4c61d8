"""The lessons as data: sections of words and code, and what of them can be shown in the window."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

from sandbox.resources import find_scene, scenes_dir

LESSONS = ("sat", "solver")
"""Folders of shipped scenes whose README is a lesson."""
Kind = Literal["words", "item", "code"]
_COMMAND = re.compile(r"sandbox (?:sat|run|solver) [^`\n]+")
_LINK, _IMAGE = re.compile(r"\[([^\]]*)\]\([^)]*\)"), re.compile(r"^!\[")
_MARKS = re.compile(r"\*\*|`|(?<!\w)\*(?=\S)|(?<=\S)\*(?!\w)")


@dataclass(frozen=True)
class Block:
    """A paragraph, an item of a list, or lines of code."""

    kind: Kind
    text: str


@dataclass(frozen=True)
class Showing:
    """What a command of a lesson shows: a scene, two of its bodies (None: its first two), and what of their test.

    `figure` and `axis` are those of `sandbox sat`; a scene that is only run has no figure.
    """

    scene: str
    bodies: tuple[str, str] | None = None
    figure: str = ""
    axis: int | None = None

    @property
    def label(self) -> str:
        """Words for a button."""
        axis = f" {self.axis}" if self.axis is not None else ""
        pair = f", {self.bodies[0]} and {self.bodies[1]}" if self.bodies else ""
        return f"{self.scene}{pair}{f', {self.figure}{axis}' if self.figure else ''}"


@dataclass(frozen=True)
class Section:
    """One section of a lesson."""

    title: str
    blocks: tuple[Block, ...]
    showings: tuple[Showing, ...]


@lru_cache(maxsize=4)
def lesson(name: str) -> tuple[Section, ...]:
    """The sections of a lesson. Raises `OSError` if the file is not there."""
    text = (scenes_dir() / name / "README.md").read_text(encoding="utf-8")
    first, *rest = re.split(r"^## ", text, flags=re.MULTILINE)
    return tuple(_section(part) for part in (first.removeprefix("# "), *rest))


def _section(text: str) -> Section:
    title, _, body = text.partition("\n")
    # Without what its author wrote as `$ command` and without the pictures: the window shows them itself.
    found = dict.fromkeys(showing for command in _COMMAND.findall(body) if (showing := _showing(command)) is not None)
    return Section(title.strip(), tuple(_blocks(body)), tuple(found))


def _blocks(body: str) -> Iterator[Block]:
    """Blocks in order; fences of shell commands, tables and pictures are left out."""
    for number, part in enumerate(re.split(r"^```", body, flags=re.MULTILINE)):
        if number % 2:
            language, _, code = part.partition("\n")
            if language != "sh":
                yield Block("code", code.rstrip())
            continue
        for paragraph in re.split(r"\n\s*\n", part):
            lines = paragraph.strip("\n")
            if not lines.strip() or lines.startswith("|") or _IMAGE.match(lines):
                continue
            if lines.startswith("    "):
                yield Block("code", "\n".join(line[4:] for line in lines.split("\n")))
            elif re.match(r"\s*([-*]|\d+\.) ", lines):
                yield from (
                    Block("item", _plain(item)) for item in re.split(r"^\s*(?:[-*]|\d+\.) ", lines, flags=re.M)[1:]
                )
            else:
                yield Block("words", _plain(lines))


def _plain(text: str) -> str:
    """Words without their marks, on one line."""
    return " ".join(_MARKS.sub("", _LINK.sub(r"\1", text)).split())


def _showing(command: str) -> Showing | None:
    """What `sandbox sat ...`, `run` or `solver` shows; None if there is no such scene."""
    try:
        _, kind, scene, *options = shlex.split(command)
    except ValueError:
        return None
    if not scene.replace("-", "").isalnum() or not find_scene(scenes_dir() / scene).exists():
        return None
    bodies, axis, figure = None, None, "whole" if kind == "sat" else ""
    for k, option in enumerate(options):
        if option == "--bodies":
            bodies = options[k + 1], options[k + 2]
        elif option == "--figure" and kind == "sat":
            figure = options[k + 1]
        elif option == "--axis":
            axis = int(options[k + 1])
        elif option == "--step-by-step":
            figure = "edges"
    return Showing(scene, bodies, figure, axis)
