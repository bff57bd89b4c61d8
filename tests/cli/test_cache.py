"""`sandbox cache`: the folder and the key for a CI server."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from sandbox import _kernel_cache


def test_key_and_path_alone_are_one_line(cli: Callable) -> None:
    found = json.loads(cli("cache", "--json").out)
    assert cli("cache", "--key").out == found["key"] + "\n"
    assert cli("cache", "--path").out == found["path"] + "\n"


def test_the_folder_is_the_one_that_is_asked_for(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "sandbox", "cache", "--json"]
    environment = os.environ | {"SANDBOX_CACHE_DIR": str(tmp_path)}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    found = json.loads(done.stdout)
    assert found["path"] == tmp_path.as_posix()
    assert found["compiled"] is False


def test_the_key_follows_sources_and_python(monkeypatch: pytest.MonkeyPatch) -> None:
    before = _kernel_cache.cache_key()
    monkeypatch.setattr(_kernel_cache, "sources_hash", lambda: "0" * 16)
    assert _kernel_cache.cache_key() != before
    monkeypatch.undo()
    monkeypatch.setattr("platform.python_version", lambda: "3.99.0")
    assert _kernel_cache.cache_key() != before
