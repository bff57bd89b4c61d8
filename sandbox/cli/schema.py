"""`sandbox schema`: the JSON Schema of scene files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from sandbox._printable import told
from sandbox.cli.output import OUTPUT, put
from sandbox.errors import SandboxError

_SUFFIX = "schema.json"


def schema(output: Annotated[Path | None, OUTPUT] = None) -> None:
    """Print the JSON Schema of scene files, by which an editor completes, explains and checks what you type.

    A scene names it: "$schema": "scene.schema.json". What it cannot say, such as that an id is there, `sandbox check`
    tells.

    Exit code 0, or 2 if the file cannot be written, or is there and is no schema by its name.
    """
    from sandbox.scene.schema import schema_text

    if output is not None and not output.name.endswith(_SUFFIX) and output.is_file():
        raise SandboxError(
            f"{told(output)}: there is a file of that name already; only one named *{_SUFFIX} is renewed"
        )
    put(schema_text(), output)
