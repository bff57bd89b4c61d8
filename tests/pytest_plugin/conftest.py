"""A user's own repository, in which pytest runs with the plugin."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import sandbox
import sandbox.cli.check_table
import sandbox.report.report_page
import sandbox.testing.own_replay
import sandbox.testing.verdict
from sandbox._kernel_cache import cache_folder
from tests.cli.conftest import CRATE, GROUND, cli  # noqa: F401

KERNELS = cache_folder().parents[1]
"""The folder in use, which another process would not find: pytester has a home of its own."""


@pytest.fixture(scope="session")
def _engine() -> None:
    """pytester forgets modules that were loaded meanwhile, and numpy cannot be loaded twice: load it before."""
    sandbox.rerun(sandbox.record(sandbox.Scene(bodies=[GROUND, CRATE]), 1))


@pytest.fixture
def home(_engine: None, pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> pytest.Pytester:
    """An empty repository. The plugin is named, so that it is there once whether or not the package is installed."""
    for name in ("CI", "GITHUB_ACTIONS"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    monkeypatch.setenv("SANDBOX_CACHE_DIR", str(KERNELS))
    monkeypatch.setenv("PYTEST_ADDOPTS", "-p sandbox.pytest_plugin")
    return pytester


@pytest.fixture
def put(home: pytest.Pytester) -> Callable[..., Path]:
    """Writes a scene of a crate that lies on the ground, with the given expectations."""

    def write(name: str, *expect: dict[str, Any], **fields: Any) -> Path:
        path = home.path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        scene = {"bodies": [GROUND, CRATE], "settings": {"steps": 20}, "expect": expect, **fields}
        path.write_text(json.dumps(scene, indent=1), encoding="utf-8")
        return path

    return write


@pytest.fixture
def keep() -> Callable[[Path], Path]:
    """Records a scene beside its file."""

    def write(scene: Path) -> Path:
        path = scene.with_name(scene.name.replace(".scene.json", ".replay.json"))
        sandbox.record(scene).save(path)
        return path

    return write
