"""Reading files that a test has just written."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest

from sandbox.formats import Imported, import_scene

Read = Callable[..., Imported]


@pytest.fixture
def read(tmp_path: Path) -> Read:
    """Writes a text, or data as JSON, into a file and imports it; `units` make a metre."""

    def call(content: Any, name: str = "file", units: float | None = None, tolerance: float = 0.01,
             solid: Sequence[str] = ()) -> Imported:  # fmt: skip
        path = tmp_path / name
        path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return import_scene(path, "", units, tolerance, solid)

    return call


def texts(imported: Imported) -> list[str]:
    """What the remarks say, without places."""
    return [remark.text for remark in imported.remarks]
