"""The `sandbox` command: one file a subcommand, heavy imports inside the functions that need them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NoReturn


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run the command line (`sys.argv` by default) and exit with its code; users never see a traceback."""
    from sandbox.cli.app import build
    from sandbox.cli.failures import report

    code = 0
    try:
        build().main(None if arguments is None else list(arguments), prog_name="sandbox")
    except SystemExit as stop:
        raise stop
    except Exception as error:
        code = report(error)
    raise SystemExit(code)
