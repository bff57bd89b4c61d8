"""The `sandbox` command: one file a subcommand, heavy imports inside the functions that need them."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from io import TextIOWrapper


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line (`sys.argv` by default) and exit with its code; users never see a traceback."""
    from sandbox.cli.app import build
    from sandbox.cli.failures import report

    if isinstance(sys.stdout, TextIOWrapper):  # names of files may hold what its encoding has no bytes for
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        # Once `sandbox list` is imported, `list` is its module here.
        build().main(None if arguments is None else [*arguments], prog_name="sandbox")
    except Exception as error:
        raise SystemExit(report(error)) from error
