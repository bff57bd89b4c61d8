"""The JSON document of a command: what all have in common, around what each has to tell, for `--json`."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any

import typer

from sandbox._version import __version__
from sandbox.cli.failures import HOLDS, exit_code_of, problems_of
from sandbox.cli.output import put

FORMAT = 1
"""Raised when a key goes or changes its meaning; new ones do not raise it."""

JSON = typer.Option("--json", help="Print one JSON document instead.")


def document(facts: Mapping[str, Any], code: int = HOLDS) -> str:
    """The text of a document about what a command has to tell; `code` is what it ends with."""
    envelope = {"format": FORMAT, "sandbox": __version__, "exit_code": code}
    taken = envelope.keys() & facts.keys()
    assert not taken, f"these keys have a meaning in every document: {taken}"
    return json.dumps(plain({**envelope, **facts}), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def print_document(facts: Mapping[str, Any], code: int = HOLDS) -> None:
    """Print that. Raises `OSError`."""
    put(document(facts, code), None)


def print_error_document(error: Exception) -> None:
    """Print the document of a command that an error ended before it had one. Raises `OSError`."""
    print_document({"problems": problems_of(error)}, exit_code_of(error))


def plain(value: Any) -> Any:
    """Data that JSON can say: numbers that are not finite become null."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, dict):
        return {key: plain(entry) for key, entry in value.items()}
    return [plain(entry) for entry in value] if isinstance(value, (list, tuple)) else value
