"""Fixtures for tests written in Python."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import pytest

from sandbox.testing.paths import shown
from sandbox.testing.summary import note_judged, note_written

if TYPE_CHECKING:
    from sandbox.engine.world import World
    from sandbox.replay.recording.recording import Recording
    from sandbox.scene import Scene

_SUFFIXES = ("", ".scene.json")


class ReplayCheck(Protocol):
    """What the fixture `replay_check` is."""

    def __call__(
        self, what: Any, steps: int | None = None, commands: Iterable[tuple[int, Any]] = (), name: str = ""
    ) -> None:
        """Compare a run with its recording; fails the test if they differ."""


@pytest.fixture
def world(request: pytest.FixtureRequest) -> Callable[[Any], World]:
    """Makes worlds: `world("pile")`, `world("scenes/pile.scene.json")`, `world({"bodies": [...]})`, `world(scene)`.

    A name is looked for beside the test file, then in each folder above it up to the root of the session, there and in
    its `scenes`, and at last among the scenes of the package. Raises `SceneError` if it cannot be used.
    """

    def make(what: Any) -> World:
        __tracebackhide__ = True
        from sandbox.engine.world import World
        from sandbox.errors import SandboxError

        try:
            return World(scene_of(what, request))
        except SandboxError as error:
            raise error.with_traceback(None) from None

    return make


@pytest.fixture
def replay_check(request: pytest.FixtureRequest) -> ReplayCheck:
    """Records a run in the test and compares it with the recording beside the test file.

    `replay_check(what, steps, commands)` takes what `world` takes, or a `Recorder` whose world the test has stepped, or
    a `Recording`. In `test_x.py`, `test_falls` has `test_x.test_falls.replay.json`; a further one in the same test
    needs a `name`. `pytest --replay-update` writes it.
    """
    given: set[Path] = set()

    def check(what: Any, steps: int | None = None, commands: Iterable[tuple[int, Any]] = (), name: str = "") -> None:
        __tracebackhide__ = True
        from sandbox.errors import SandboxError
        from sandbox.testing.own_replay import compare
        from sandbox.testing.verdict import verdict

        path = golden_path(request, name)
        if path in given:
            pytest.fail(f"{path.name}: the second recording of a test needs another name=", pytrace=False)
        given.add(path)
        try:
            made = _recording_of(what, steps, commands, request)
            told = shown(path, request.config)
            note_judged(request.node, told.as_posix(), _kept(made, request), _accept(request))
            report = compare(made, told, request.config.getoption("replay_update") or "")
        except (SandboxError, OSError) as error:
            raise error.with_traceback(None) from None
        if report.action:
            note_written(request.node, told.as_posix())
        if not report.fine:
            pytest.fail(verdict(report, _accept(request)), pytrace=False)

    return check


def _accept(request: pytest.FixtureRequest) -> str:
    return f"accept it:  pytest --replay-update=changed {request.node.nodeid!r}"


def _kept(made: Recording, request: pytest.FixtureRequest) -> str:
    """Where the run of a test is kept until the page is written; "" if none is asked for."""
    if not request.config.getoption("replay_report"):
        return ""
    path = request.getfixturevalue("tmp_path_factory").mktemp("replay") / "made.replay.json"
    made.save(path)
    return str(path)


def golden_path(request: pytest.FixtureRequest, name: str = "") -> Path:
    """Where the recording of a test stands."""
    parts = [*request.node.nodeid.split("::")[1:], *([name] if name else [])]
    stem = re.sub(r"[^\w\-\[\].=+]", "_", ".".join(parts))
    return Path(request.path).with_name(f"{request.path.stem}.{stem}.replay.json")


def scene_of(what: Any, request: pytest.FixtureRequest) -> Scene:
    """The scene that a test means. Raises `SceneError`, or fails the test if there is none of that name."""
    from sandbox.scene import Scene, load_scene

    if isinstance(what, Scene):
        return what
    return (
        Scene(**what) if isinstance(what, Mapping) else load_scene(shown(_file_of(Path(what), request), request.config))
    )


def _file_of(wanted: Path, request: pytest.FixtureRequest) -> Path:
    from sandbox.resources import find_scene

    home, root = request.path.parent, request.config.rootpath
    above = [folder for folder in (home, *home.parents) if folder.is_relative_to(root)] or [home]
    places = [place for folder in above for place in (folder, folder / "scenes")]
    found = [place / (str(wanted) + suffix) for place in places for suffix in _SUFFIXES]
    shipped = find_scene(wanted) if wanted.name == str(wanted) else wanted
    file = next((path for path in (*found, shipped) if path.is_file()), None)
    if file is None:
        pytest.fail(_nowhere(str(wanted), [place for place in places if place.is_dir()]), pytrace=False)
    return file


def _nowhere(wanted: str, folders: Sequence[Path]) -> str:
    """What is said where no scene has that name, with the nearest that there is."""
    from sandbox.resources import SCENE_SUFFIX, scene_name, shipped_scenes
    from sandbox.scene.near_names import did_you_mean

    there = [file for folder in folders for file in sorted(folder.glob(f"*{SCENE_SUFFIX}"))]
    hint = did_you_mean(wanted, map(scene_name, (*there, *shipped_scenes())))
    looked = ", ".join(folder.as_posix() for folder in folders)
    return f"no scene {wanted!r} in {looked}, nor among those of the package{hint and f': {hint}'}"


def _recording_of(what: Any, steps: int | None, commands: Iterable[Any], request: pytest.FixtureRequest) -> Any:
    from sandbox.replay.recording.recorder import Recorder, record
    from sandbox.replay.recording.recording import Recording

    if isinstance(what, Recorder):
        return what.recording()
    return what if isinstance(what, Recording) else record(scene_of(what, request), steps, commands)
