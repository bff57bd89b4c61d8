"""Saved tests run as they are, stand for the pair they were made of, and fail where they should."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import sandbox
from sandbox.reference import comparison
from sandbox.reference.comparison import Observer, compare
from sandbox.reference.comparison_result import Comparison, Miss
from sandbox.reference.pair import Core, Pair
from sandbox.reference.regression import save_regressions

PACKAGE = Path(sandbox.__file__).parent.parent


@pytest.fixture
def scene() -> sandbox.Scene:
    ground = {"id": "ground", "type": "static", "shapes": [{"box": [9, 1]}], "position": [0, -0.5]}
    ball = {"id": "a ball".replace(" ", "-"), "shapes": [{"circle": 0.3}], "position": [0.1, 0.25], "angle": 33}
    return sandbox.Scene.model_validate({"bodies": [ground, ball], "settings": {"steps": 3}})


def spoiled(scene: sandbox.Scene, monkeypatch: pytest.MonkeyPatch) -> Comparison:
    decide = comparison.decide
    with monkeypatch.context() as patch:
        patch.setattr(comparison, "decide", lambda *given: (decide(*given)[0] - 1e-3, decide(*given)[1]))
        return compare(scene, 2)


def run_pytest(folder: Path) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(PACKAGE)}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(folder)]
    return subprocess.run(command, capture_output=True, text=True, env=environment, cwd=folder, check=False)


def test_a_saved_pair_is_the_pair_to_the_bit(
    scene: sandbox.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tally = spoiled(scene, monkeypatch)
    files = save_regressions(scene, Path("over there/my scene.scene.json"), tally, tmp_path / "new")
    assert [file.name for file in files] == [f"test_my_scene_step_{k}_shapes_0_1.py" for k in (1, 2)]
    for file, found in zip(files, tally.disagreements, strict=True):
        text = file.read_text()
        source = re.search(r"PAIR = (Pair\(.*?\n\))", text, re.DOTALL)
        assert source is not None
        assert eval(source[1], {"Core": Core, "Pair": Pair}) == found.pair
        assert f"sandbox:       {found.ours}" in text


@pytest.mark.slow
def test_saved_files_run_as_they_are(scene: sandbox.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tally = spoiled(scene, monkeypatch)
    tally.misses.append(Miss(2, ("ground", "a-ball"), (0, 1)))
    files = save_regressions(scene, Path("s.scene.json"), tally, tmp_path)
    assert len(files) == 3
    assert sandbox.load_scene(tmp_path / "s.scene.json") == scene
    done = run_pytest(tmp_path)
    assert done.returncode == 0, done.stdout
    assert "3 passed" in done.stdout


def test_a_saved_step_fails_where_the_grid_still_misses(
    scene: sandbox.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    miss = Comparison(misses=[Miss(2, ("ground", "a-ball"), (0, 1))], missed=1)
    (file,) = save_regressions(scene, Path("s.scene.json"), miss, tmp_path)
    names = {"__file__": str(file)}
    exec(compile(file.read_text(), str(file), "exec"), names)
    names["test_s_step_2_missed"]()  # type: ignore[operator]
    noted = Observer._note_misses

    def forgetful(observer: Observer, candidates: object) -> None:
        observer.world.state.counters[0].pair_count = 0
        noted(observer, candidates)  # type: ignore[arg-type]

    monkeypatch.setattr(Observer, "_note_misses", forgetful)
    with pytest.raises(AssertionError):
        names["test_s_step_2_missed"]()  # type: ignore[operator]


def test_nothing_is_written_where_all_agree(scene: sandbox.Scene, tmp_path: Path) -> None:
    assert save_regressions(scene, Path("s.scene.json"), compare(scene, 3), tmp_path / "new") == []
    assert not (tmp_path / "new").exists()
