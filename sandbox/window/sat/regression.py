"""A pair as a regression test: a scene of two bodies where they are now, and what must hold of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sandbox.errors import SandboxError
from sandbox.geometry.sat_rows import Vec
from sandbox.geometry.shape_box import box_of
from sandbox.geometry.shapes import Shape
from sandbox.render.number_text import metres
from sandbox.render.sat_labels import headline
from sandbox.replay.headless_run import run_headless
from sandbox.resources import SCENE_SUFFIX
from sandbox.scene import Scene
from sandbox.window.sat.inspection import Inspection
from sandbox.window.session import free_path

NEARLY = 1e-9
"""Share of the pair's size below which a gap or an overlap is a touch: the engine may say either."""


def save_regression(seen: Inspection, stem: str, step: int, folder: Path) -> Path:
    """Write the pair as the first free STEM-A-B.scene.json in `folder`; `sandbox check` then judges it.

    Raises `SandboxError` for a pair that cannot collide in a scene or of which the engine says something else than the
    table, `OSError` if the file cannot be written.
    """
    scene = regression_scene(seen, f"{stem}, step {step}")
    first, second = seen.names
    path = free_path(folder, f"{stem}-{first}-{second}", SCENE_SUFFIX)
    scene.save(path)
    return path


def regression_scene(seen: Inspection, where: str) -> Scene:
    """The scene of a pair, run once to see that it holds. Raises `SandboxError`."""
    touching = seen.table.colliding
    scene = _scene(seen, where, touching)
    if run_headless(scene).holds:
        return scene
    if abs(seen.deciding.separation) <= NEARLY * _size(seen):
        scene = _scene(seen, where, not touching)
        if run_headless(scene).holds:
            return scene
    said = "touch" if touching else "are apart"
    raise SandboxError(f"by the table they {said} ({headline(seen.table, seen.names)}), but the step says otherwise")


def _scene(seen: Inspection, where: str, touching: bool) -> Scene:
    a, b = seen.names
    # Only what has an area can be pushed, and two bodies that cannot be pushed have no contact.
    b_moves = _has_area(seen.b)
    if not b_moves and not _has_area(seen.a):
        raise SandboxError(f"{a} and {b} are two lines without thickness: in a scene they never collide")
    verdict = "touches" if touching else "apart"
    depth = metres(abs(seen.deciding.separation))
    found = f"overlap by {depth}" if seen.table.colliding else f"are {depth} apart"
    return Scene(
        title=f"{a} and {b}",
        about=f"From {where}: they {found}.",
        gravity=[0, 0],
        bodies=[_body(a, seen.a, not b_moves), _body(b, seen.b, b_moves)],
        settings={"steps": 1},
        expect=[{"at": 1, verdict: [a, b]}],
    )


def _body(name: str, shape: Shape, moves: bool) -> dict[str, Any]:
    """A shape as a body of its own, about the middle of its box."""
    left, bottom, right, top = box_of(shape)
    x, y = left + (right - left) / 2, bottom + (top - bottom) / 2
    words = _shape([(u - x, v - y) for u, v in shape.given], shape.radius)
    return {"id": name, "type": "dynamic" if moves else "static", "position": [x, y], "shapes": [words]}


def _shape(points: list[Vec], radius: float) -> dict[str, Any]:
    corners = [list(point) for point in points]
    match len(points):
        case 1:
            return {"circle": radius, "at": corners[0]}
        case 2:
            return {"capsule": corners, "radius": radius} if radius else {"segment": corners}
    return {"polygon": corners, **({"radius": radius} if radius else {})}


def _has_area(shape: Shape) -> bool:
    return shape.radius > 0.0 or len(shape.vertices) > 2


def _size(seen: Inspection) -> float:
    a, b = box_of(seen.a), box_of(seen.b)
    return max(a[2] - a[0], a[3] - a[1]) + max(b[2] - b[0], b[3] - b[1])
