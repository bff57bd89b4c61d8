"""What `sandbox render` can be asked for."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from sandbox.cli.document import JSON
from sandbox.cli.options import SET
from sandbox.errors import SandboxError

if TYPE_CHECKING:
    from sandbox.render.shots import Style
    from sandbox.render.theme import Theme

STILL_SIZE, FILM_SIZE = "1280x800", "640x400"
MOST_STEPS = 10_000_000

_SCENE = typer.Argument(metavar="SCENE", help="A scene file, the name of a shipped scene, or a recording.")
_OUTPUT = typer.Option(
    "-o", "--output", metavar="FILE", help="The file to write: NAME.png, .svg, .gif, .mp4, .webm or .html."
)
_STEP = typer.Option(
    min=0, max=MOST_STEPS, metavar="N", help="Steps to take before the picture, or before the film begins."
)
_STEPS = typer.Option(
    min=1,
    max=100_000,
    metavar="N",
    show_default=False,
    help="Length of a film in steps; default 300, of a page or a recording the whole run.",
)
_RANGE = typer.Option(
    "--range", metavar="A:B", show_default=False, help="Film from step A to step B: --step and --steps in one."
)
_FPS = typer.Option(
    min=1.0,
    max=120.0,
    metavar="N",
    show_default=False,
    help="Pictures a second in a film; default 25, of a video 60; a GIF: to 50.",
)
_SIZE = typer.Option(
    metavar="WxH", show_default=False, help=f"Pixels; default {STILL_SIZE} for pictures, {FILM_SIZE} for films."
)
_CENTER = typer.Option(metavar="X,Y", show_default=False, help="Middle of the picture, m.")
_HEIGHT = typer.Option(
    min=1e-6, max=1e9, metavar="METRES", show_default=False, help="How much is seen from bottom to top."
)
_FOLLOW = typer.Option(metavar="BODY", show_default=False, help='Go with a body, or with what moves: "moving".')
_OVERLAY = typer.Option(
    metavar="NAMES", show_default=False, help="What to draw over it, as in contacts,boxes or sat:crate:ramp."
)
_THEME = typer.Option(metavar="dark|light", help="Colours.")
_COLOR_BY = typer.Option(
    metavar="WHAT",
    show_default=False,
    help="What the colours of bodies mean: theme, material, group, speed, sleep, island, mass or density.",
)
_DEPTH = typer.Option("--depth/--flat", help="Whether what moves casts a soft shadow.")


@dataclass(frozen=True)
class RenderOptions:
    """What `sandbox render` was asked for."""

    scene: Annotated[Path, _SCENE]
    output: Annotated[Path, _OUTPUT]
    step: Annotated[int, _STEP] = 0
    steps: Annotated[int | None, _STEPS] = None
    range: Annotated[str | None, _RANGE] = None
    fps: Annotated[float | None, _FPS] = None
    size: Annotated[str | None, _SIZE] = None
    center: Annotated[str | None, _CENTER] = None
    height: Annotated[float | None, _HEIGHT] = None
    follow: Annotated[str | None, _FOLLOW] = None
    overlay: Annotated[list[str] | None, _OVERLAY] = None
    theme: Annotated[str, _THEME] = "dark"
    color_by: Annotated[str | None, _COLOR_BY] = None
    depth: Annotated[bool, _DEPTH] = True
    set: Annotated[list[str] | None, SET] = None
    json: Annotated[bool, JSON] = False


def steps_asked_for(options: RenderOptions) -> tuple[int, int | None]:
    """(first step, length in steps or None). Raises `SandboxError` for a range that is none."""
    if options.range is None:
        return options.step, options.steps
    if options.step or options.steps is not None:
        raise SandboxError("--range says where a film begins and ends: leave --step and --steps away")
    match = re.fullmatch(r"\s*(\d{1,8})\s*:\s*(\d{1,8})\s*", options.range)
    if match is None:
        raise SandboxError(f"--range {options.range!r} is not a range; write two steps, such as 60:240")
    first, last = int(match[1]), int(match[2])
    if not first < last <= first + 100_000:
        raise SandboxError(f"--range {options.range}: the second step comes after the first, by at most 100,000")
    return first, last - first


def style_of(options: RenderOptions, size: tuple[int, int], bodies: Sequence[str]) -> Style:
    """Camera, theme, colours and overlays. Raises `SandboxError` with the nearest name for what is not known."""
    from sandbox.render.coloring.registry import find_coloring
    from sandbox.render.overlays.registry import find_overlay
    from sandbox.render.shots import Style

    names = [name.strip() for text in options.overlay or () for name in text.split(",") if name.strip()]
    return Style(
        size=size,
        theme=theme_of(options.theme),
        center=_center(options.center),
        height=options.height,
        follow=_followed(options.follow, bodies),
        overlays=[find_overlay(name, bodies) for name in names],
        color_by=find_coloring(options.color_by).name if options.color_by is not None else None,
        depth=options.depth,
    )


def theme_of(name: str) -> Theme:
    """The theme of that name. Raises `SandboxError` with the nearest one."""
    from sandbox.render.theme import THEMES
    from sandbox.scene.near_names import did_you_mean

    if name not in THEMES:
        hint = did_you_mean(name, THEMES) or f"there are {' and '.join(THEMES)}"
        raise SandboxError(f"--theme {name!r} is no theme; {hint}")
    return THEMES[name]


def _center(text: str | None) -> tuple[float, float] | None:
    if text is None:
        return None
    number = r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*"
    match = re.fullmatch(f"{number},{number}", text)
    if match is None or max(abs(float(part)) for part in match.groups()) > 1e12:
        raise SandboxError(f"--center {text!r} is not a place; write x and y in metres, such as --center=-2.5,4")
    return float(match[1]), float(match[2])


def _followed(name: str | None, bodies: Sequence[str]) -> str | None:
    from sandbox.scene.near_names import did_you_mean
    from sandbox.scene.references import MOVING

    if name is None or name == MOVING or name in bodies:
        return name
    hint = did_you_mean(name, [*bodies, MOVING]) or f"it has {', '.join(bodies[:5])}{' ...' * (len(bodies) > 5)}"
    raise SandboxError(f"--follow: no body {name!r} in this scene; {hint}")
