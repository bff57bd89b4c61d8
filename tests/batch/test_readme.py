"""The programs of the guides to batches and sweeps run, and the environment for Gymnasium is one."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sandbox

HOME = Path(sandbox.__file__).parent


def programs(guide: str) -> list[str]:
    return re.findall(r"^```python\n(.*?)^```", (HOME / guide).read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def test_the_guide_to_batches(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(HOME.parent)
    first, _second = programs("batch/README.md")
    exec(first, {})
    found = re.match(r"(\d+) of 100 random rules", capsys.readouterr().out)
    assert found is not None
    assert 1 <= int(found[1]) < 50


def test_the_guide_to_sweeps(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    bodies = [{"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 5]}]
    Path("crate.scene.json").write_text(json.dumps({"bodies": bodies}))
    (program,) = programs("sweeps/README.md")
    exec(program, {})
    assert len(Path("falls.csv").read_text().splitlines()) == 19


class TestGymnasium:
    @pytest.fixture
    def env(self) -> Any:
        pytest.importorskip("gymnasium")
        from sandbox.batch.cart_pole import CartPoles

        return CartPoles(40, threads=1)

    def test_the_program(self, env: Any, capsys: pytest.CaptureFixture[str]) -> None:
        exec(programs("batch/README.md")[1], {"np": np})
        assert capsys.readouterr().out == "0 of 50 poles have fallen\n"

    def test_the_same_seed_gives_the_same_episodes(self, env: Any) -> None:
        runs = []
        for _ in range(2):
            seen, _ = env.reset(seed=3)
            assert seen in env.observation_space
            for k in range(20):
                seen, *_ = env.step(np.full(40, k % 2))
            runs.append(seen)
        assert np.array_equal(*runs)

    def test_an_episode_ends_and_the_next_begins(self, env: Any) -> None:
        env.reset(seed=3)
        for _ in range(60):
            seen, reward, fallen, late, _ = env.step(np.full(40, 1))
            if fallen.any():
                break
        assert (np.abs(seen[fallen, 2]) > np.radians(12)).all()
        assert not late.any()
        assert (reward == 1.0).all()
        again, reward, *_ = env.step(np.full(40, 1))
        assert (np.abs(again[fallen, 2]) < 0.06).all()
        assert (reward[fallen] == 0.0).all()
        assert list(env.batch.step_counts[fallen]) == [0] * int(fallen.sum())
