"""What all commands have in common: what is empty is no path, and how a command speaks of itself."""

from __future__ import annotations

import inspect
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from typer.core import TyperCommand

from sandbox.errors import SandboxError


class Command(TyperCommand):
    """A command that refuses empty arguments and empty paths of options: one would mean this folder, and all in it.

    It also refuses `-` as the path of an option, which would be a file of that name.
    """

    def __init__(self, *args: Any, **options: Any) -> None:
        """As typer has it, but for the line breaks of its text."""
        super().__init__(*args, **options)
        self.help = _flowing(self.help or "")

    def get_params(self, ctx: Any) -> list[Any]:
        """Without the names of Python's types."""
        return without_types(super().get_params(ctx))

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Refuse an empty argument; the value of an option that is no path is for that to judge.

        Raises `SandboxError`.
        """
        options: list[Any] = [option for option in self.params if option.param_type_name == "option"]
        values = {name for option in options if not option.is_flag and not option.count for name in option.opts}
        for before, arg in zip(["", *args], args, strict=False):
            if arg == "" and before not in values:
                raise SandboxError("an argument is empty; is a variable of the shell not set? This folder is `.`")
        rest = super().parse_args(ctx, [*args])  # which uses the list up
        for option in options:
            if not isinstance(ctx.params.get(option.name), Path):
                continue
            if _is_given(option.opts, args, ""):
                raise SandboxError(f"{option.opts[-1]}: the path is empty; is a variable of the shell not set?")
            if _is_given(option.opts, args, "-"):
                streams = "/dev/stdin and /dev/stdout stand for the streams, ./- for a file of that name"
                raise SandboxError(f"{option.opts[-1]} -: this is no path; {streams}")
        return rest


def without_types(params: list[Any]) -> list[Any]:
    """Parameters as a help text has them: a switch takes no value, and an argument has said its name, so that nothing
    is left to tell; typer would write `<bool>` and `<list[Path]>`."""
    for param in params:
        if param.param_type_name == "argument":
            param.display_type_rich = lambda ctx: ""
        elif param.is_flag:
            param.metavar = ""
    return params


def _flowing(text: str) -> str:
    """A text without the line breaks of its source, which stand where no terminal needs them; but each exit code has
    a line of its own."""
    paragraphs = re.split(r"\n\s*\n", inspect.cleandoc(text))
    return "\n\n".join(re.sub(r"\s*\n\s*(?!Exit code)", " ", paragraph) for paragraph in paragraphs)


def _is_given(names: Sequence[str], args: Sequence[str], value: str) -> bool:
    """Whether an option is given with just this value: as `-o ""` or `--output=`, say."""
    return any(
        (arg in names and following == value) or arg in [f"{name}={value}" for name in names]
        for arg, following in zip(args, [*args[1:], None], strict=True)
    )
