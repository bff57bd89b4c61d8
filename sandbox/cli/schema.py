"""`sandbox schema`: the JSON Schema of scene files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from sandbox.cli.output import OUTPUT, put


def schema(output: Annotated[Path | None, OUTPUT] = None) -> None:
    """Print the JSON Schema of scene files, by which an editor completes, explains and checks what you type.

    A scene names it: "$schema": "scene.schema.json". What it cannot say, such as that an id is there, `sandbox check`
    tells.

    Exit code 0, or 2 if the file cannot be written.
    """
    from sandbox.scene.schema import schema_text

    put(schema_text(), output)
