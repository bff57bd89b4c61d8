"""The table of commands. A command's file is imported when the command is asked for, not before."""

from __future__ import annotations

import importlib
import keyword
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from sandbox.cli.command import Command, without_types

PANELS = {
    "Play and show": ("run", "list", "render", "gallery"),
    "Test": ("check", "record", "replay", "diff", "bisect"),
    "Write scenes": ("new", "lint", "fmt", "expand", "schema", "import", "export"),
    "Look inside": ("sat", "solver", "events"),
    "Measure": ("sweep", "compare", "bench"),
    "This machine": ("cache",),
}
"""Command names by the heading of the help text that they stand under, in its order."""
COMMANDS = tuple(name for names in PANELS.values() for name in names)
"""All command names; `name` is the function `name` in `sandbox/cli/name.py`, but for words of Python's own, which get a
`_` there."""


class LazyGroup(TyperGroup):
    """A command group that imports a subcommand's file on first use."""

    def get_params(self, ctx: Any) -> list[Any]:
        """Without the names of Python's types."""
        return without_types(super().get_params(ctx))

    def list_commands(self, ctx: Any) -> list[str]:
        """All command names, without importing anything."""
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """The command of that name, imported now; None if there is none."""
        # For an unknown name all are loaded, so that the error can suggest the nearest one.
        for name in [cmd_name] if cmd_name in COMMANDS else COMMANDS:
            if name not in self.commands:
                self.commands[name] = _load(name)
        return self.commands.get(cmd_name)


def build() -> Any:
    """The whole command line as one click command."""
    app = typer.Typer(cls=LazyGroup, no_args_is_help=True, add_completion=False)
    app.callback()(_options)
    return typer.main.get_command(app)


def _load(name: str) -> Any:
    word = f"{name}_" if keyword.iskeyword(name) else name
    module = importlib.import_module(f"sandbox.cli.{word}")
    app = typer.Typer(add_completion=False)
    panel = next(panel for panel, names in PANELS.items() if name in names)
    app.command(name, cls=getattr(module, "CommandClass", Command), rich_help_panel=panel)(getattr(module, word))
    return typer.main.get_command(app)


def _show_version(wanted: bool) -> None:
    if wanted:
        from sandbox._version import __version__

        typer.echo(f"sandbox {__version__}")
        raise typer.Exit


def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """A deterministic 2D physics sandbox: scenes in a window, and the same scenes headless."""
