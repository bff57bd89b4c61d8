"""The `sandbox` command: one file a subcommand, heavy imports inside the functions that need them."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from io import TextIOWrapper

INTERRUPTED = 130
"""Exit code after Ctrl-C: 128 + SIGINT, as of all programs."""


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line (`sys.argv` by default) and exit with its code; users never see a traceback."""
    try:
        _run(arguments)
    except KeyboardInterrupt:  # while commands are looked up: those that run have it told by typer
        raise SystemExit(INTERRUPTED) from None


def _run(arguments: Sequence[str] | None) -> None:
    _fill_in_closed_streams()
    from sandbox._lent import keep_streams
    from sandbox.cli.app import build
    from sandbox.cli.document import print_error_document
    from sandbox.cli.failures import report
    from sandbox.cli.usage import invoke

    keep_streams()
    words = sys.argv[1:] if arguments is None else [*arguments]
    if isinstance(sys.stdout, TextIOWrapper):  # names of files may hold what its encoding has no bytes for
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        # Once `sandbox list` is imported, `list` is its module here.
        raise SystemExit(invoke(build(), words))
    except Exception as error:
        code = report(error)
        if "--json" in words:
            with suppress(OSError):  # perhaps the very reason
                print_error_document(error)
        raise SystemExit(code) from error


def _fill_in_closed_streams() -> None:
    """Whoever starts us without stdin, stdout or stderr wants nothing of it. In this order each gets the number that is
    its own, the lowest free one: a file that is opened later would get it otherwise, and what is printed."""
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_RDWR), mode, encoding="utf-8"))
