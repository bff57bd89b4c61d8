"""The script for an emulated arm64, with a stand-in for the emulator that runs this machine's Python."""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path

import pytest

from tests.determinism import arm64

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the stand-in is a shell script")


@pytest.fixture
def emulator(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> arm64.Emulator:
    """Without the compiler; what it is told of the root and its Python is left out."""
    program = tmp_path / "qemu-aarch64-static"
    program.write_text(f'#!/bin/sh\nshift 3\nexec {shlex.quote(sys.executable)} "$@"\n')
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    return arm64.Emulator(tmp_path, jit=False)


def test_it_runs_this_package_and_says_with_what(emulator: arm64.Emulator):
    assert emulator.printed("-c", arm64.VERSIONS).endswith("without the compiler\n")
    assert emulator.printed("-c", "import sandbox; print(sandbox.__file__)").startswith(str(arm64.ROOT))


def test_digests_that_differ_are_told(
    emulator: arm64.Emulator, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
):
    monkeypatch.setattr(arm64, "PROGRAMS", ["one"])
    monkeypatch.setattr(arm64, "other_process", lambda program: ["a", "b"])
    for there, same in (("a b", True), ("a c", False)):
        monkeypatch.setattr(emulator, "printed", lambda *words, there=there: there)
        assert arm64.same_digests(emulator) is same
    assert capfd.readouterr().out.split("\n")[:2] == ["one: 2 of 2 digests equal", "one: 1 of 2 digests equal"]


def test_recordings_are_judged(emulator: arm64.Emulator, tmp_path: Path):
    assert not emulator.replays([str(tmp_path / "none.replay.json")])
