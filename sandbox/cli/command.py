"""What all commands have in common: an empty argument is no path."""

from __future__ import annotations

from typing import Any

from typer.core import TyperCommand

from sandbox.errors import SandboxError


class Command(TyperCommand):
    """A command that refuses empty arguments: as a path one would mean this folder, and all that is in it."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Refuse an empty argument; one that is the value of an option is for that to judge.

        Raises `SandboxError`.
        """
        options: list[Any] = [option for option in self.params if option.param_type_name == "option"]
        values = {name for option in options if not option.is_flag and not option.count for name in option.opts}
        for before, arg in zip(["", *args], args, strict=False):
            if arg == "" and before not in values:
                raise SandboxError("an argument is empty; is a variable of the shell not set? This folder is `.`")
        return super().parse_args(ctx, args)
