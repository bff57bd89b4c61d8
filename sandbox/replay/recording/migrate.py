"""Older files in the form of today."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sandbox.scene.finding import Finding

FORMAT = 1
"""The version of the format that this version writes."""

MIGRATIONS: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {}
"""For each older format, what makes its plain data that of the next one. Format 1 is the first there was."""


def migrated(data: dict[str, Any]) -> tuple[dict[str, Any], list[Finding]]:
    """The data in today's format, or why that cannot be."""
    given = data.get("format")
    if isinstance(given, bool) or not isinstance(given, int) or given < 1:
        where = ("format",) if "format" in data else ()
        return data, [Finding(where, f'a recording begins with "format": {FORMAT}')]
    if given > FORMAT:
        text = f"the file has format {given} and this version of sandbox reads up to {FORMAT}"
        hint = "update sandbox: python -m pip install -U FOLDER, where FOLDER is a newer checkout of it"
        return data, [Finding(("format",), text, hint)]
    for version in range(given, FORMAT):
        data = {**MIGRATIONS[version](data), "format": version + 1}
    return data, []
