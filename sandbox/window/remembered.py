"""How the user likes the window, kept between runs."""

from __future__ import annotations

import json
from contextlib import suppress
from dataclasses import asdict, dataclass, fields
from pathlib import Path

from sandbox._atomic_write import write_text
from sandbox.render.camera import Size

NAME = "window.json"


@dataclass
class Remembered:
    """`size` of the window in pixels, `light` theme, `text_scale` as chosen by hand (None: as suits the screen), open
    `panels` (None: those that are open at first), `less_motion`: nothing fades or turns; `docks`: where panels are
    docked, in ImGui's own words.
    """

    size: Size | None = None
    light: bool = False
    text_scale: float | None = None
    less_motion: bool = False
    panels: list[str] | None = None
    docks: str = ""

    def keep(self, folder: Path) -> None:
        """Write it. Where that cannot be, it is forgotten."""
        with suppress(OSError):
            folder.mkdir(parents=True, exist_ok=True)
            write_text(folder / NAME, json.dumps(asdict(self), indent=1) + "\n")


def remembered(folder: Path) -> Remembered:
    """What was kept in `folder`; of what is damaged, the usual."""
    usual = Remembered()
    try:
        found = json.loads((folder / NAME).read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return usual
    for field in fields(usual):
        value = found.get(field.name) if isinstance(found, dict) else None
        if _fits(field.name, value):
            setattr(usual, field.name, tuple(value) if isinstance(value, list) and field.name == "size" else value)
    return usual


def _fits(name: str, value: object) -> bool:
    match name:
        case "size":
            return (
                isinstance(value, list)
                and len(value) == 2
                and all(type(side) is int and 320 <= side <= 8192 for side in value)
            )
        case "text_scale":
            return isinstance(value, float) and 0.5 <= value <= 3.0
        case "panels":
            return isinstance(value, list) and all(isinstance(one, str) for one in value)
        case "docks":
            return isinstance(value, str) and len(value) < 100_000
    return isinstance(value, bool)
