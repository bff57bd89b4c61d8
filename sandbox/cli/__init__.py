"""The `sandbox` command: one file a subcommand, heavy imports inside the functions that need them."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from io import TextIOWrapper


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line (`sys.argv` by default) and exit with its code; users never see a traceback."""
    _fill_in_closed_streams()
    from sandbox.cli.app import build
    from sandbox.cli.failures import error_document, report

    words = sys.argv[1:] if arguments is None else [*arguments]
    if isinstance(sys.stdout, TextIOWrapper):  # names of files may hold what its encoding has no bytes for
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        # Once `sandbox list` is imported, `list` is its module here.
        build().main(words, prog_name="sandbox")
    except Exception as error:
        code = report(error)
        if "--json" in words:
            with suppress(OSError):  # perhaps the very reason
                print(error_document(error, code))
        raise SystemExit(code) from error


def _fill_in_closed_streams() -> None:
    """Whoever starts us without stdin, stdout or stderr wants nothing of it; but a file that is opened first would get
    its number, and what is printed."""
    for number, name, mode in ((0, "stdin", "r"), (1, "stdout", "w"), (2, "stderr", "w")):
        if getattr(sys, name) is None:
            with suppress(OSError):
                os.fstat(number)
                continue
            os.open(os.devnull, os.O_RDWR)  # takes the lowest free number, which is this one
            setattr(sys, name, os.fdopen(number, mode, encoding="utf-8"))
