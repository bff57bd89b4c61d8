"""What somebody does who sees the window for the first time: real keys and clicks in a process of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image, ImageSequence

import sandbox
from sandbox.cli import main
from sandbox.window.leftover import leftovers

SCENE = sandbox.Scene(
    title="A yard",
    bodies=[
        {"id": "ground", "type": "static", "shapes": [{"box": [40, 1]}], "position": [0, -0.5]},
        {"id": "crate", "shapes": [{"box": [1, 1]}], "position": [0, 0.5]},
        {"id": "ball", "shapes": [{"circle": 0.5}], "position": [3, 0.5]},
    ],
    view={"center": [0, 3], "height": 12},
)


class Visit:
    """A folder with the scene in it, and what scripts leave there."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        SCENE.save(folder / "yard.scene.json")

    def do(self, script: str, *options: str) -> None:
        """Do what a script says; the window must end without a word."""
        (self.folder / "hands.txt").write_text(script)
        command = [sys.executable, "-m", "sandbox", "run", "yard.scene.json", "--script", "hands.txt", *options]
        environment = {**os.environ, "SANDBOX_STATE_DIR": str(self.folder / "state")}
        done = subprocess.run(command, cwd=self.folder, env=environment, capture_output=True, text=True)
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")

    def recording(self, name: str = "yard") -> sandbox.Recording:
        """What was saved, which must run again to the bit."""
        with pytest.raises(SystemExit) as stop:
            main(["replay", str(self.folder / f"{name}.replay.json")])
        assert stop.value.code == 0
        return sandbox.Recording.load(self.folder / f"{name}.replay.json")

    def kinds(self, name: str = "yard") -> list[str]:
        return [type(command).__name__ for _, command in self.recording(name).commands]

    def picture(self, name: str) -> Any:
        with Image.open(self.folder / f"{name}.png") as image:
            return np.asarray(image.convert("RGB")).astype(int)


@pytest.fixture
def visit(display: Any, tmp_path: Path) -> Visit:
    return Visit(tmp_path)


def test_a_body_is_thrown(visit: Visit) -> None:
    visit.do("wait 5\nfilm thrown.gif\ndrag @0,0.5 to @4,5 in 6\nwait 30\ncut\nkey S\nwait 2\n")
    with Image.open(visit.folder / "thrown.gif") as film:
        assert (film.size, film.n_frames) == ((1280, 800), 12)
        assert {frame.info["duration"] for frame in ImageSequence.Iterator(film)} <= {60, 70}  # 15 a second
    recording = visit.recording()
    assert {type(command).__name__ for _, command in recording.commands} == {"StartDrag", "MoveDrag", "EndDrag"}
    assert max(pose[1] for name, pose in recording.final.items() if name == "crate") > 3.0


@pytest.mark.slow
def test_time_is_rewound_and_another_future_begins_there(visit: Visit) -> None:
    visit.do(
        "wait 20\ndrag @0,0.5 to @4,5 in 6\nwait 20\nshot late.png\nhold Left for 60\nshot early.png\n"
        "key Space\nwait 30\nkey S\nwait 2\nclick time.scrubber\nwait 2\n"
        "drag @3,0.5 to @3,3\nkey S\nwait 2\n"
    )
    assert "StartDrag" in visit.kinds()  # rewound is not undone: all of it is known
    late, early = visit.picture("late"), visit.picture("early")
    assert np.abs(late - early).max() > 100
    assert "SetPose" in visit.kinds("yard-2")  # scrubbing has paused, so that a drag puts the ball elsewhere


@pytest.mark.slow
def test_a_wedge_is_drawn_and_lands_on_the_ground(visit: Visit) -> None:
    visit.do("wait 5\nkey P\nclick @-6,1\nclick @-3,1\nclick @-6,3\nkey Enter\nwait 90\nkey S\nwait 2\n")
    recording = visit.recording()
    ((_, spawn),) = recording.commands
    assert isinstance(spawn, sandbox.Spawn)
    entry = spawn.bodies
    assert isinstance(entry, dict)
    assert len(entry["shapes"][0]["polygon"]) == 3
    # The pointer goes to whole pixels, so a corner is where it was asked for to one.
    x, y = entry["position"]
    corners = np.add(entry["shapes"][0]["polygon"], (x, y))
    assert np.abs(corners - [(-6, 1), (-3, 1), (-6, 3)]).max() < 0.05
    assert recording.final[entry["id"]][1] < y


@pytest.mark.slow
def test_a_stroke_becomes_a_polygon_of_few_corners(visit: Visit) -> None:
    moves = "".join(
        f"move @{-5 + 1.5 * np.cos(t):.3f},{4 + 1.5 * np.sin(t):.3f}\n" for t in np.linspace(0, 2 * np.pi, 60)
    )
    visit.do(f"key Space\nkey P\nmove @-3.5,4\npress left\n{moves}let left\nwait 3\nkey .\nkey S\nwait 2\n")
    ((_, spawn),) = visit.recording().commands
    assert isinstance(spawn, sandbox.Spawn)
    assert 8 <= len(spawn.bodies["shapes"][0]["polygon"]) <= 40


@pytest.mark.slow
def test_two_bodies_are_joined(visit: Visit) -> None:
    visit.do("wait 5\nclick tool.rod\nclick @0,0.5\nclick @3,0.5\nwait 60\nkey S\nwait 2\n")
    recording = visit.recording()
    ((_, spawn),) = recording.commands
    assert isinstance(spawn, sandbox.Spawn)
    assert spawn.joints["type"] == "distance"
    assert spawn.joints["bodies"] == ["crate", "ball"]


@pytest.mark.slow
def test_gravity_is_changed_by_a_button_and_by_the_dial(visit: Visit) -> None:
    visit.do(
        "wait 5\nclick panel.world\nwait 2\nclick world.gravity.moon\nwait 10\n"
        "drag world.gravity.dial to world.gravity.none\nwait 3\nkey S\nwait 2\n"
    )
    commands = [command for _, command in visit.recording().commands]
    assert {type(command) for command in commands} == {sandbox.SetGravity}
    assert commands[0] == sandbox.SetGravity((0.0, -1.62))
    assert commands[-1] != commands[0]


@pytest.mark.slow
def test_all_of_it_is_undone_and_done_again(visit: Visit) -> None:
    acts = (
        "wait 5\ndrag @0,0.5 to @4,5 in 6\nwait 10\nkey C\ndrag @-4,4 to @-3.5,4\nclick panel.world\nwait 2\n"
        "click world.gravity.moon\nwait 20\n"
    )
    visit.do(
        acts
        + "key Space\nkey S\n"
        + "key Ctrl+Z\n" * 4
        + "key .\nkey S\n"
        + "key Ctrl+Z\nkey Ctrl+Y\n" * 4
        + "wait 2\n"
    )
    assert {"StartDrag", "Spawn", "SetGravity"} <= set(visit.kinds())
    assert visit.recording("yard-2").commands == ()


@pytest.mark.slow
def test_the_moment_is_saved_as_a_scene_that_begins_so(visit: Visit) -> None:
    visit.do("wait 5\nkey C\ndrag @-4,4 to @-3.5,4\nwait 20\nkey Space\nkey S\nkey Ctrl+Shift+S\nwait 2\n")
    scene = sandbox.load_scene(visit.folder / "yard-2.scene.json")
    assert json.loads((visit.folder / "yard-2.scene.json").read_text())["title"] == "A yard"
    world = sandbox.World(scene)
    for name, (x, y, _) in visit.recording().final.items():
        assert world.body(name).position == pytest.approx((x, y), abs=1e-12)
    with pytest.raises(SystemExit) as stop:
        main(["check", str(visit.folder / "yard-2.scene.json")])
    assert stop.value.code == 0


@pytest.mark.slow
def test_copies_are_pasted_turned_scaled_and_deleted(visit: Visit) -> None:
    visit.do(
        "key Space\nclick @0,0.5\nkey Ctrl+D\nkey ]\nkey T\ndrag @1.2,1.4 to @0.6,2.4\n"
        "key V\nclick @3,0.5\nkey Ctrl+C\nmove @-5,3\nkey Ctrl+V\nkey Ctrl+A\nkey .\nkey S\nkey Delete\nkey S\nwait 2\n"
    )
    names = set(visit.recording().final)
    assert {"ground", "crate", "ball"} < names
    assert len(names) == 5
    assert set(visit.recording("yard-2").final) == {"ground"}


@pytest.mark.slow
def test_panels_tools_and_help_open_by_keys_and_by_mouse(visit: Visit) -> None:
    visit.do(
        "key Space\nwait 2\nshot plain.png\nkey Tab\nwait 2\nshot bare.png\nkey Tab\nkey F1\nwait 2\nshot help.png\n"
        "key Esc\nkey F8\nwait 2\nshot light.png\nclick menu.view\nwait 2\nshot menu.png\nkey Esc\nwait 2\n"
    )
    plain = visit.picture("plain")
    for name in ("bare", "help", "light", "menu"):
        assert (np.abs(visit.picture(name) - plain).max(axis=2) > 20).mean() > 0.02, name
    assert visit.picture("light").mean() > 150 > 60 > plain.mean()


@pytest.mark.parametrize("size", ["400x300", pytest.param("1920x1200", marks=pytest.mark.slow)])
def test_it_fits_into_small_and_large_windows(visit: Visit, size: str) -> None:
    visit.do("wait 3\nshot shot.png\n", "--size", size)
    width, height = map(int, size.split("x"))
    assert visit.picture("shot").shape == (height, width, 3)


@pytest.mark.slow
def test_a_mistake_in_a_script_is_told_with_its_line_and_what_was_done_is_offered(visit: Visit) -> None:
    (visit.folder / "hands.txt").write_text("wait 1\nkey C\ndrag @-4,4 to @-3.5,4\nclick nowhere\n")
    command = [sys.executable, "-m", "sandbox", "run", "yard.scene.json", "--script", "hands.txt"]
    environment = {**os.environ, "SANDBOX_STATE_DIR": str(visit.folder / "state")}
    done = subprocess.run(command, cwd=visit.folder, env=environment, capture_output=True, text=True)
    assert done.returncode == 2
    assert "hands.txt:4: there is no place 'nowhere'" in done.stderr
    assert "Traceback" not in done.stderr
    (left,) = leftovers(visit.folder / "state")
    assert [type(command) for _, command in left.commands] == [sandbox.Spawn]


@pytest.mark.parametrize(
    ("script", "words"), [("jump", "hands.txt:1: there is no act 'jump'"), ("wait 1\nkey Hyper", "hands.txt:2"),
                          ("click 'a", "quotes"), ("drag 1,1", "needs 3 words")],
)  # fmt: skip
def test_a_script_is_checked_before_anything_is_done(tmp_path: Path, script: str, words: str) -> None:
    from sandbox.window.script import Script

    (tmp_path / "hands.txt").write_text(script)
    with pytest.raises(sandbox.SandboxError, match=words):
        Script(tmp_path / "hands.txt")
