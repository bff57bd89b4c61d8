"""`sandbox list`: the scenes that come with the package."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox.cli.document import JSON, print_document
from sandbox.errors import SandboxError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sandbox.scene.catalog import Entry

_WORDS = typer.Argument(
    metavar="TEXT", show_default=False, help="Only scenes with these words in name, title or about."
)
_THEME = typer.Option(metavar="THEME", show_default=False, help="Only scenes of this theme.")


def list(
    text: Annotated[str, _WORDS] = "",
    theme: Annotated[str, _THEME] = "",
    json: Annotated[bool, JSON] = False,
) -> None:
    """List the scenes that come with the package: their themes, titles and sizes.

    Any of the names stands for the scene where a command wants one: sandbox run pyramid-10.

    Exit code 0: some were found.
    Exit code 2: there is no such theme.
    Exit code 5: none was found.
    """
    from sandbox.cli.failures import NothingToDoError
    from sandbox.scene.catalog import search, shipped_entries

    entries = shipped_entries()
    _check_theme(theme, entries)
    found = search((entry for entry in entries if theme in ("", entry.theme)), text)
    rows = [_row(entry) for entry in found]
    if not rows:
        raise NothingToDoError(f"no scene that comes with the package has the words {text!r}")
    print_document({"scenes": rows}) if json else _print_table(rows)


def _check_theme(wanted: str, entries: Sequence[Entry]) -> None:
    from sandbox.scene.near_names import did_you_mean

    themes = sorted({entry.theme for entry in entries})
    if wanted and wanted not in themes:
        hint = did_you_mean(wanted, themes)
        raise SandboxError(f"--theme: there is no theme {wanted!r}; {hint or 'there are ' + ', '.join(themes)}")


def _row(entry: Entry) -> dict[str, Any]:
    from sandbox.resources import scene_name
    from sandbox.scene import load_scene
    from sandbox.scene.duration import planned_steps

    scene = load_scene(entry.path)
    flat = scene.flatten()
    return {
        "name": scene_name(entry.path),
        "theme": entry.theme,
        "title": entry.title,
        "about": entry.about,
        "bodies": len(flat.bodies),
        "joints": len(flat.joints),
        "steps": planned_steps(scene),
        "controls": [control.title or control.id for control in scene.controls],
        "path": entry.path.as_posix(),
    }


def _print_table(rows: Sequence[dict[str, Any]]) -> None:
    from rich.console import Console
    from rich.text import Text

    out = Console(soft_wrap=True, highlight=False)
    wide, theme = max(len(row["name"]) for row in rows), ""
    out.print(Text(f"{'scene':<{wide + 2}}  {'bodies':>6} {'joints':>6} {'steps':>6}  title", style="dim"))
    for row in rows:
        if row["theme"] != theme:
            theme = row["theme"]
            out.print(Text(theme, style="bold"))
        numbers = f"{row['bodies']:>6} {row['joints'] or '':>6} {row['steps']:>6}"
        out.print(Text(f"  {row['name']:<{wide}}  {numbers}  {row['title']}"))
    plural = "" if len(rows) == 1 else "s"
    out.print(Text(f"{len(rows)} scene{plural}; sandbox run NAME opens one", style="dim"))
