"""Path data as points, with the parser that scenes have for it."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.formats.numbers import Vec
from sandbox.scene.svg_curves import Arc, along_arc, along_curve
from sandbox.scene.svg_path import PathError, Subpath, subpaths


@dataclass
class Stroke:
    """Points that a pen draws without being lifted; `closed` if the last leads back to the first."""

    points: list[Vec]
    closed: bool = False


def strokes_of(text: str, tolerance: float) -> tuple[list[Stroke], str]:
    """The strokes of a path, and what is wrong with its text: as SVG says, it is good up to there.

    `tolerance` is how far lines may leave a curve, in units of the path.
    """
    found: list[Stroke] = []
    try:
        for each in subpaths(text):
            found.append(Stroke(_points(each, tolerance), each.closed))
    except PathError as error:
        return found, error.message
    return found, ""


def _points(path: Subpath, tolerance: float) -> list[Vec]:
    found = [path.start]
    for piece in path.pieces:
        steps = along_arc(piece, tolerance) if isinstance(piece, Arc) else along_curve((found[-1], *piece), tolerance)
        found += [point for point in steps if point != found[-1]]
    return found
