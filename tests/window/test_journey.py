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


PICTURES_A_SECOND = 15


def small_pictures(path: Path) -> list[Image.Image]:
    """Those of a film, a quarter as wide and high; one that is shown for longer, as nothing moves, as often as that.

    Whether two are the same to the last pixel hangs on the frames a second that the menu bar shows.
    """
    pictures: list[Image.Image] = []
    with Image.open(path) as film:
        assert film.size == (1000, 640)
        for picture in ImageSequence.Iterator(film):
            times = round(picture.info["duration"] * PICTURES_A_SECOND / 1000)
            pictures += [picture.convert("RGB").resize((250, 160), Image.Resampling.BOX)] * times
    return pictures


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
    assert len(kept) == len(shot)
    for number in range(0, len(kept), 6):
        assert alike(kept[number], shot[number]), f"picture {number} of the film looks otherwise"

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
