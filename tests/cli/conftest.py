"""Calling the command line as a user does: through `main`, with its exit code, stdout and stderr."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from sandbox.cli import main

GROUND = {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]}
CRATE = {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.5]}


@dataclass(frozen=True)
class Done:
    """How a call ended and what it printed."""

    code: int
    out: str
    err: str


@pytest.fixture(autouse=True)
def _nowhere_special(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is printed is not that of GitHub's machines, whoever runs the tests."""
    for name in ("GITHUB_ACTIONS", "GITHUB_WORKSPACE"):
        monkeypatch.delenv(name, raising=False)


@pytest.fixture
def cli(capsys: pytest.CaptureFixture[str]) -> Callable[..., Done]:
    """Runs `sandbox ARGUMENTS...` in this process."""

    def call(*arguments: object) -> Done:
        capsys.readouterr()
        with pytest.raises(SystemExit) as stop:
            main([str(argument) for argument in arguments])
        captured = capsys.readouterr()
        return Done(stop.value.code, captured.out, captured.err)  # type: ignore[arg-type]

    return call


@pytest.fixture
def write_scene(tmp_path: Path) -> Callable[..., Path]:
    """Writes a scene of a crate that lies on the ground, with the given expectations, in `tmp_path`."""

    def write(name: str, *expect: dict[str, Any], **fields: Any) -> Path:
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        scene = {
            "title": name,
            "bodies": [GROUND, CRATE],
            "settings": {"steps": 20},
            "expect": expect,
            **fields,
        }
        path.write_text(json.dumps(scene, indent=1), encoding="utf-8")
        return path

    return write
