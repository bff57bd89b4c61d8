"""`sandbox new`: a first scene to go on from."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox._printable import told
from sandbox.cli.document import JSON, print_document
from sandbox.cli.output import FORCE, OUTPUT, check_new, put
from sandbox.resources import SCENE_SUFFIX

if TYPE_CHECKING:
    from sandbox.cli.starters import Starter

_THEME = typer.Argument(metavar="THEME", help="What it is about: --list says which there are.")
_LIST = typer.Option("--list", help="List the themes, and write nothing.")


def new(
    theme: Annotated[str, _THEME] = "stack",
    output: Annotated[Path | None, OUTPUT] = None,
    force: Annotated[bool, FORCE] = False,
    list: Annotated[bool, _LIST] = False,
    json: Annotated[bool, JSON] = False,
) -> None:
    """Write a first scene to go on from, on one of some themes. It says in $comment fields what its parts are for.

    It passes sandbox check as it is. Where scene.schema.json lies beside it or above, it names it for editors.

    Exit code 0: it was written.
    Exit code 2: there is no such theme, or a file of that name already.
    """
    from sandbox.cli.starters import THEMES, starter, with_schema

    if list:
        _tell_themes([starter(each) for each in THEMES], json)
        return
    chosen = starter(theme)
    if output is None:
        print_document({"path": None, **_facts(chosen), "text": chosen.text}) if json else put(chosen.text, None)
        return
    check_new(output, force, ())
    text = with_schema(chosen.text, output)
    put(text, output, over=force)
    if json:
        print_document({"path": output.as_posix(), **_facts(chosen)})
    else:
        _walk_through(chosen, output, '"$schema"' in text)


def _facts(chosen: Starter) -> dict[str, Any]:
    return {"theme": chosen.theme, "title": chosen.title, "lines": chosen.lines}


def _tell_themes(starters: Any, as_json: bool) -> None:
    if as_json:
        print_document({"starters": [{"theme": s.theme, "title": s.title, "about": s.about} for s in starters]})
        return
    for each in starters:
        typer.echo(f"{each.theme:<9} {each.title}: {each.lines[0]}")


def _walk_through(chosen: Starter, output: Path, has_schema: bool) -> None:
    file = told(output)
    lines = [f"{file}: {chosen.title}", f"  {chosen.about}", *(f"  {line}" for line in chosen.lines), ""]
    steps = [("run", "watch it, and play"), ("check", "judge what it expects"), ("lint", "find what is hardly meant")]
    lines += [f"sandbox {name} {file}".ljust(len(file) + 16) + why for name, why in steps]
    if not has_schema:
        schema = told(output.with_name("scene.schema.json"))
        lines.append(f'For an editor that completes: sandbox schema -o {schema}, and "$schema" in the scene.')
    if not output.name.endswith(SCENE_SUFFIX):
        lines.append(f"Folders are searched for NAME{SCENE_SUFFIX}: this one is found by its own name alone.")
    typer.echo("\n".join(lines))
