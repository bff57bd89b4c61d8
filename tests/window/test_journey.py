"""The film in README.md: all that a newcomer does, with real keys and clicks, saved and run again headless."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from PIL import Image, ImageSequence

import sandbox
from sandbox.cli import main
from tests.window.test_pictures import alike

ASSETS = Path(__file__).parents[2] / "assets"


LATE = 3
"""Pictures by which one film may be behind another: the hand waits until what it reaches for stands still."""


def small_pictures(path: Path) -> list[Image.Image]:
    """Those of a film, a quarter as wide and high."""
    with Image.open(path) as film:
        pictures = [picture.convert("RGB") for picture in ImageSequence.Iterator(film)]
    assert pictures[0].size == (1000, 640)
    return [picture.resize((250, 160), Image.Resampling.BOX) for picture in pictures]


def saved(path: Path) -> list[sandbox.Command]:
    """What a recording did, which `sandbox replay` runs again to the bit."""
    with pytest.raises(SystemExit) as stop:
        main(["replay", str(path)])
    assert stop.value.code == 0
    return [command for _, command in sandbox.Recording.load(path).commands]


@pytest.mark.slow
def test_the_film_is_made_by_its_script_and_what_it_saves_runs_again(display: Any, tmp_path: Path) -> None:
    script = str(ASSETS / "window.script.txt")
    command = [sys.executable, "-m", "sandbox", "run", "pyramid-10", "--script", script, "--size", "1000x640"]
    environment = {**os.environ, "SANDBOX_STATE_DIR": str(tmp_path / "state")}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")

    kept, shot = small_pictures(ASSETS / "window.gif"), small_pictures(tmp_path / "film.gif")
    assert abs(len(kept) - len(shot)) <= LATE
    for number in range(0, len(kept), 12):
        near = shot[max(number - LATE, 0) : number + LATE + 1]
        assert any(alike(kept[number], picture) for picture in near), f"picture {number} of the film looks otherwise"

    done_by_hand = saved(tmp_path / "pyramid-10.replay.json")
    wedge, box, rod = [command for command in done_by_hand if isinstance(command, sandbox.Spawn)]
    assert isinstance(wedge.bodies, dict)
    assert isinstance(box.bodies, dict)
    assert isinstance(rod.joints, dict)
    assert len(wedge.bodies["shapes"][0]["polygon"]) == 3
    assert rod.joints["bodies"][0] == box.bodies["id"]
    assert rod.joints["bodies"][1].startswith("block-")
    assert done_by_hand[-1] == sandbox.SetGravity((0.0, -1.62))
    assert not any(isinstance(command, sandbox.StartDrag) for command in done_by_hand)  # rewound, and another future
    assert saved(tmp_path / "pyramid-10-2.replay.json") == []
