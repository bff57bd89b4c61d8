"""Command lines that typer cannot take, told as all errors are: in one line, and as a document where `--json` asks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import typer

from sandbox.cli.failures import UNREAD
from sandbox.errors import SandboxError

_UsageError: Any = typer.BadParameter.__mro__[1]
"""Of typer's own, or of the click that older ones are made of."""


def invoke(command: Any, words: Sequence[str]) -> int:
    """Run a command line; its exit code. Raises `SandboxError` where it is of no use, and what commands raise."""
    try:
        code = command.main([*words], prog_name="sandbox", standalone_mode=False)
    except _UsageError as error:
        if type(error).__name__ == "NoArgsIsHelpError":
            print(error.ctx.get_help())
            return int(error.exit_code)
        raise SandboxError(_told(error, words)) from None
    except SystemExit as stop:
        # Typer ends with 1 when nobody reads what is printed, which here means that something did not hold.
        if isinstance(stop.__context__, BrokenPipeError):
            return UNREAD
        raise
    return code if isinstance(code, int) else 0


def _told(error: Any, words: Sequence[str]) -> str:
    text = error.format_message().rstrip(".")
    value = _given(getattr(error, "param", None), words)
    said = "" if value is None or value in text else f", not {value!r}"
    path = error.ctx.command_path if error.ctx is not None else "sandbox"
    return f"{text}{said}{'' if text.endswith('?') else ';'} {path} --help tells what there is"


def _given(param: Any, words: Sequence[str]) -> str | None:
    """The value of an option in a command line."""
    for name in getattr(param, "opts", ()):
        for word, following in zip(words, [*words[1:], None], strict=True):
            if word == name:
                return following
            if name.startswith("--") and word.startswith(f"{name}="):
                return word.partition("=")[2]
    return None
