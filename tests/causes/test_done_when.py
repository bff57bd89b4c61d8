"""One friction, one command or one line of the solver is changed: every view names step, body, number and cause."""

from __future__ import annotations

import json
import math
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import sandbox
from sandbox.resources import scenes_dir
from sandbox.scene import Scene
from tests.causes.conftest import PUSH, STOP, Views, junit_text, page_text, place, record, write
from tests.cli.conftest import CRATE, GROUND
from tests.git_folder import commit, needs_git
from tests.revisions.conftest import SOFTER


def first_parting(golden: Path, now: sandbox.Recording) -> int:
    """The step that is to be named, from two recordings alone."""
    recorded = sandbox.Recording.load(golden).digests
    return next(step for step, pair in enumerate(zip(recorded, now.digests, strict=True), 1) if pair[0] != pair[1])


def test_one_friction_of_a_shipped_scene(views: Callable[..., Views]) -> None:
    for kind in ("scene", "replay"):
        shutil.copy(scenes_dir() / "friction" / f"ramp.{kind}.json", ".")
    scene, golden = Path("ramp.scene.json"), Path("ramp.replay.json")
    text = scene.read_text(encoding="utf-8")
    old = '"pine": {"friction": 0.09}'
    assert old in text
    scene.write_text(text.replace(old, old.replace("0.09", "0.1")), encoding="utf-8")
    body = place(scene, '{"id": "pine"')
    step = first_parting(golden, sandbox.record(scene))
    seen = views(golden)
    detail = seen.divergence["detail"]
    assert (seen.entry["verdict"], seen.divergence["step"], detail["body"]) == ("stale", step, "pine")
    # Of two surfaces the friction is the geometric mean, and the slope has 1.
    assert (detail["field"], detail["expected"], detail["got"]) == ("friction", math.sqrt(0.09), math.sqrt(0.1))
    assert seen.divergence["cause"]["kind"] == "scene"
    for words in (
        f"step {step} ({step / 60:.3f} s): ",
        f"friction expected 0.3, got {math.sqrt(0.1)!r} ({detail['ulps']:,} ulps off)",
        f"cause: the scene was edited: {place(scene, '0.1')}: materials.pine.friction was 0.09 and is 0.1",
        f"body pine: {body}",
        "farthest off: ",
    ):
        assert seen.all_say(words), words
    assert "the scene of that name that comes with the package" in seen.page


@needs_git
def test_one_command(views: Callable[..., Views], cli: Callable) -> None:
    write()
    Path("push.json").write_text(json.dumps([PUSH, STOP]))
    golden = record(cli, "--commands", "push.json")
    revision = commit()
    golden.write_text(golden.read_text(encoding="utf-8").replace("[0.5, 0.0]", "[0.75, 0.0]"), encoding="utf-8")
    seen = views(golden)
    detail = seen.divergence["detail"]
    assert (seen.entry["verdict"], seen.divergence["step"], detail["body"]) == ("diverged", 21, "box")
    assert detail["expected"] != detail["got"]
    assert detail["ulps"] > 0
    assert seen.divergence["cause"]["kind"] == "command"
    assert seen.divergence["cause"]["origin"] == f"the commands of slide.replay.json of revision {revision}"
    spot = place(golden, '[20, "ApplyImpulse"')
    words = "command 1 (step 20, ApplyImpulse on box): impulse was [0.5, 0.0] and is [0.75, 0.0]"
    assert seen.all_say(f"cause: the commands were edited: {spot}: {words}")
    assert seen.all_say("step 21 (0.350 s): ")
    assert seen.all_say(f"{detail['field']} expected {detail['expected']!r}")
    assert seen.all_say("body box: slide.scene.json:")


class Engine:
    """A git repository with a copy of the package, whose engine is run as a program of its own."""

    def __init__(self, root: Path) -> None:
        self.root = root
        shutil.copytree(Path(sandbox.__file__).parent, root / "sandbox", ignore=shutil.ignore_patterns("__pycache__"))
        (root / ".gitignore").write_text("__pycache__\nout.*\n")
        falling = CRATE | {"position": [0, 0.52], "velocity": [1.0, -0.5]}
        Scene(bodies=[GROUND, falling], settings={"steps": 8}).save(root / "a.scene.json")
        sandbox.record(root / "a.scene.json").save(root / "a.replay.json")
        self.revision = commit(root)

    def soften(self) -> str:
        """Change one line of the solver; `FILE:LINE: was A, is B`."""
        file, old, new = SOFTER
        path = self.root / file
        text = path.read_text(encoding="utf-8")
        path.write_text(text.replace(old, new, 1), encoding="utf-8")
        line = text[: text.index(old)].count("\n") + 1
        return f"{file}:{line}: was `{old}`, is `{new}`"

    def replay(self, *options: str) -> Views:
        environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_DIR")}
        environment |= {"PYTHONPATH": str(self.root), "NUMBA_DISABLE_JIT": "1"}
        files = ["--report", "out.html", "--junit", "out.xml"]
        command = [sys.executable, "-m", "sandbox", "replay", "a.replay.json", *options]
        text, data = (
            subprocess.run(
                [*command, *more], cwd=self.root, env=environment, capture_output=True, text=True, check=False
            )
            for more in (files, ["--json"])
        )
        assert (text.returncode, data.returncode) == (1, 1), text.stderr + data.stderr
        (entry,) = json.loads(data.stdout)["replays"]
        return Views(text.stdout, entry, junit_text(self.root / "out.xml"), page_text(self.root / "out.html"))


@pytest.mark.slow(seconds=15)
@needs_git
def test_one_line_of_the_solver(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SANDBOX_CACHE_DIR", str(tmp_path / "cache"))
    engine = Engine(tmp_path / "engine")
    line = engine.soften()
    seen = engine.replay()
    step = seen.divergence["step"]
    assert seen.divergence["cause"]["kind"] == "engine"
    assert seen.all_say("cause: the engine is another: its source differs from that of revision " + engine.revision)
    assert seen.all_say(line)
    assert seen.all_say("body crate: a.scene.json:")
    assert seen.all_say(f"sandbox replay a.replay.json --against {engine.revision}")

    commit(engine.root)
    seen = engine.replay("--against", engine.revision)
    detail = seen.divergence["detail"]
    assert (seen.divergence["step"], detail["body"]) == (step, "crate")
    assert detail["expected"] != detail["got"]
    for words in (
        f"step {step} ({step / 60:.3f} s): ",
        f"{detail['field']} expected {detail['expected']!r}",
        f"({detail['ulps']:,} ulp",
        "farthest off: ",
        "cause: the engine is another: ",
        line,
        "body crate: a.scene.json:",
        "that is what was recorded",
    ):
        assert seen.all_say(words), words
    assert f"the run with the engine of {engine.revision}" in seen.page
    assert "separating-axis test of the first pair that differs" in seen.page
    assert 'data-expected="expected-0"' in seen.page
