"""Whatever a public function is given that it does not take, it says so itself, in an error of the package: one line,
and never what happens to fail deep inside."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sandbox

WRONG = {
    "None": None, "text": "x", "bytes": b"x", "list": [1], "dict": {"a": 1}, "nan": math.nan, "inf": math.inf,
    "huge": 10**400, "negative": -1, "float": 2.5, "true": True, "0-d": np.array(3.0), "1-d": np.array([1.0, 2.0, 3.0]),
    "empty": np.array([]), "float64": np.float64(2.5), "complex": 1j, "object": object(), "type": int,
    "pairs": ((1, 2),),
}  # fmt: skip


def scene() -> sandbox.Scene:
    """A crate on the ground, with a hinge."""
    return sandbox.Scene(
        bodies=[
            sandbox.Body(id="ground", type="static", shapes=[sandbox.BoxShape(box=(20, 1))], position=(0, -0.5)),
            sandbox.Body(id="crate", shapes=[sandbox.BoxShape(box=(1, 1))], position=(0, 0.5)),
        ],
        joints=[sandbox.Target(id="hand", type="target", bodies=("crate",), anchor=(0, 0.5), target=(0, 2))],
        settings={"steps": 3},
    )


SCENE = scene()
RECORDING = sandbox.record(SCENE, 2)
WORLD = sandbox.World(SCENE)
BATCH = sandbox.Batch(SCENE, 2)
TABLE = sandbox.sweep(SCENE, {"gravity.1": [-9.0]})
DRAWING = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><rect id="crate" width="2" height="2"/></svg>'
GRAVITY = sandbox.SetGravity((0.0, -1.0))


def imported(**given: Any) -> None:
    """Import a drawing of the current folder."""
    Path("a.svg").write_text(DRAWING)
    sandbox.import_scene("a.svg", **given)


def put(thing: Callable[[], Any], name: str) -> Callable[[Any], None]:
    """Sets an attribute of what `thing` makes."""
    return lambda value: setattr(thing(), name, value)


CALLS: dict[str, tuple[Callable[[Any], Any], str]] = {
    "scene_of": (sandbox.scene_of, ""),
    "scene_of scene": (lambda value: sandbox.scene_of(WORLD, value), "None"),
    "copy_of": (lambda value: sandbox.copy_of(value, ["crate"]), ""),
    "copy_of bodies": (lambda value: sandbox.copy_of(WORLD, value), "empty"),
    "copy_of offset": (lambda value: sandbox.copy_of(WORLD, ["crate"], offset=value), ""),
    "paste_of": (lambda value: sandbox.paste_of(value, [], []), ""),
    "paste_of bodies": (lambda value: sandbox.paste_of(WORLD, value, []), "empty"),
    "paste_of joints": (lambda value: sandbox.paste_of(WORLD, [], value), "empty"),
    "paste_of offset": (lambda value: sandbox.paste_of(WORLD, [], [], value), ""),
    "export_scene": (lambda value: sandbox.export_scene(value, "pymunk"), ""),
    "export_scene format": (lambda value: sandbox.export_scene(SCENE, value), ""),
    "import_scene": (sandbox.import_scene, ""),
    "import_scene format": (lambda value: imported(format=value), ""),
    "import_scene units_per_metre": (lambda value: imported(units_per_metre=value), "None float float64"),
    "import_scene tolerance": (lambda value: imported(tolerance=value), ""),
    "import_scene solid": (lambda value: imported(solid=value), "empty"),
    "load_scene": (sandbox.load_scene, ""),
    "load_scene set": (lambda value: sandbox.loads_scene("{}", "x", value), "None"),
    "loads_scene": (sandbox.loads_scene, ""),
    "loads_scene source": (lambda value: sandbox.loads_scene("{}", value), "text"),
    "Scene.save": (lambda value: SCENE.save(value), "text"),
    "record": (sandbox.record, ""),
    "record steps": (lambda value: sandbox.record(SCENE, value), "None huge"),
    "record commands": (lambda value: sandbox.record(SCENE, 2, value), "empty"),
    "record commands[0]": (lambda value: sandbox.record(SCENE, 2, [value]), ""),
    "record step of a command": (lambda value: sandbox.record(SCENE, 2, [(value, GRAVITY)]), ""),
    "record command": (lambda value: sandbox.record(SCENE, 2, [(1, value)]), ""),
    "record on_steps": (lambda value: sandbox.record(SCENE, 2, on_steps=value), "None type"),
    "record workers": (lambda value: sandbox.record(SCENE, 2, workers=value), ""),
    "Recorder": (sandbox.Recorder, ""),
    "Recorder.apply": (sandbox.Recorder(sandbox.World(SCENE)).apply, ""),
    "Recording.load": (sandbox.Recording.load, ""),
    "Recording.save": (lambda value: RECORDING.save(value), "text"),
    "rerun": (sandbox.rerun, ""),
    "rerun tolerance": (lambda value: sandbox.rerun(RECORDING, tolerance=value), "None"),
    "rerun on_steps": (lambda value: sandbox.rerun(RECORDING, on_steps=value), "None type"),
    "Tolerance": (lambda value: sandbox.Tolerance(distance=value), "inf float float64"),
    "find_divergence": (lambda value: sandbox.find_divergence(RECORDING, value), ""),
    "find_divergence on_steps": (lambda value: sandbox.find_divergence(SCENE, SCENE, on_steps=value), "None type"),
    "Run": (lambda value: sandbox.Player(sandbox.Run(value, 3)), ""),
    "Run steps": (lambda value: sandbox.Player(sandbox.Run(SCENE, value)), "huge"),
    "Run commands": (lambda value: sandbox.Player(sandbox.Run(SCENE, 3, value)), "empty"),
    "Player": (sandbox.Player, ""),
    "Player budget": (lambda value: sandbox.Player(SCENE, value), "inf float float64"),
    "Judge": (lambda value: sandbox.Judge(value, WORLD), ""),
    "Judge world": (lambda value: sandbox.Judge(SCENE, value), ""),
    "Batch": (lambda value: sandbox.Batch(value, 2), ""),
    "Batch.apply": (BATCH.apply, ""),
    "Batch.row": (BATCH.row, ""),
    "Batch.set_velocity": (partial(BATCH.set_velocity, "crate"), "float 0-d float64 negative true list pairs"),
    "sweep": (lambda value: sandbox.sweep(value, {"gravity.1": [1.0]}), ""),
    "sweep steps": (lambda value: sandbox.sweep(SCENE, {"gravity.1": [1.0]}, steps=value), "None"),
    "sweep collect": (lambda value: sandbox.sweep(SCENE, {"gravity.1": [1.0]}, collect=value), "empty"),
    "sweep draw": (lambda value: sandbox.sweep(SCENE, {"gravity.1": "0:1"}, draw=value), "None"),
    "SweepTable.save": (TABLE.save, "text"),
    "SweepTable.to_csv": (TABLE.to_csv, "text"),
    "gravity": (put(lambda: sandbox.World(SCENE), "gravity"), ""),
    "position": (put(lambda: sandbox.World(SCENE).body("crate"), "position"), ""),
    "velocity": (put(lambda: sandbox.World(SCENE).body("crate"), "velocity"), ""),
    "target": (put(lambda: sandbox.World(SCENE).joint("hand"), "target"), ""),
    "query filter": (lambda value: WORLD.query.point((0.0, 0.0), value), "None"),
    "query within": (lambda value: WORLD.query.nearest((0.0, 0.0), value), "inf huge float true float64"),
    "query rays": (lambda value: WORLD.query.rays(value, value), "pairs"),
    "Filter types": (lambda value: WORLD.query.point((0.0, 0.0), sandbox.Filter(types=value)), ""),
    "Filter exclude": (lambda value: WORLD.query.point((0.0, 0.0), sandbox.Filter(exclude=value)), ""),
    "Filter mask": (lambda value: WORLD.query.point((0.0, 0.0), sandbox.Filter(mask=value)), "true"),
    "Filter group": (lambda value: WORLD.query.point((0.0, 0.0), sandbox.Filter(group=value)), "true negative"),
    "Filter sensors": (lambda value: WORLD.query.point((0.0, 0.0), sandbox.Filter(sensors=value)), "true"),
    "sweep vary": (lambda value: sandbox.sweep(SCENE, {"gravity.1": value}), "list 1-d"),
    "SweepTable": (sandbox.SweepTable, "dict"),
    "SweepTable column": (TABLE.__getitem__, ""),
    "Scene.locate": (SCENE.locate, "text"),
    "SetPose": (lambda value: WORLD.apply(sandbox.SetPose("crate", value, 0.0)), ""),
    "Body bullet": (lambda value: sandbox.Body(id="a", bullet=value), "true"),
    "Body position": (lambda value: sandbox.Body(id="a", position=value), ""),
}  # fmt: skip
"""What to call with a wrong value, and which of `WRONG` it takes nevertheless."""


@pytest.mark.parametrize("name", CALLS)
def test_a_wrong_kind_is_told_in_one_line(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    call, takes = CALLS[name]
    for kind, value in WRONG.items():
        if kind in takes.split():
            continue
        with pytest.raises(sandbox.SandboxError) as told:
            call(value)
        text = str(told.value)
        assert text, kind
        assert len(text) < 400, kind
        assert "\n" not in text or isinstance(told.value, sandbox.FileError), kind


def test_what_is_pasted_holds_only_what_comes_along() -> None:
    bodies, joints = sandbox.copy_of(WORLD, ["crate"])
    assert sandbox.paste_of(WORLD, bodies, joints)[1]
    with pytest.raises(sandbox.ArgumentError, match="paste_of: takes entries as copy_of gives them"):
        sandbox.paste_of(WORLD, [], joints)
