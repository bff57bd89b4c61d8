"""Scene files and recordings as tests: what `sandbox check` and `sandbox replay` judge, by the same judges."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from sandbox.testing.paths import shown
from sandbox.testing.summary import note_judged, note_written


class UnmetError(Exception):
    """A scene or recording did not pass; the text is all that a person needs to see."""


def expects_something(scene: Path) -> bool:
    """Whether a scene has an `expect` block; one that cannot be read counts, so that its mistakes come to light."""
    from sandbox.replay.golden.cases import expects

    return expects(scene)


def is_asked_by_a_test(replay: Path) -> bool:
    """Whether the test file stands beside it that compares with it (`test_x.py` with `test_x.NAME.replay.json`)."""
    return replay.with_name(replay.name.partition(".")[0] + ".py").is_file()


class Scenes(pytest.File):
    """A scene file: its expectations, and the recording that it should have where that is asked for."""

    def collect(self) -> Iterator[pytest.Item]:
        """One test for what the scene says must hold."""
        yield SceneItem.from_parent(self, name="check")
        wanted = self.config.getini("sandbox_recordings_required") or self.config.getoption("replay_update")
        if wanted and not self._recording.is_file():
            yield ReplayItem.from_parent(self, name="replay", replay=self._recording, scene=self.path)

    @property
    def _recording(self) -> Path:
        return self.path.with_name(self.path.name.removesuffix(".scene.json") + ".replay.json")


class Replays(pytest.File):
    """A recording."""

    def collect(self) -> Iterator[pytest.Item]:
        """One test: it comes out as it was recorded."""
        yield ReplayItem.from_parent(self, name="replay", replay=self.path)


class _Item(pytest.Item):
    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """The one clear text; a traceback only of what nobody foresaw."""
        from sandbox.errors import SandboxError

        if isinstance(excinfo.value, (UnmetError, SandboxError)):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        """File, line and title."""
        return self.path, None, f"{shown(self.path, self.config)}: {self.name}"


class SceneItem(_Item):
    """What a scene says must hold."""

    def runtest(self) -> None:
        """Run the scene and judge it, as `sandbox check` does."""
        from sandbox.cli.check_result import Result
        from sandbox.cli.check_table import reasons
        from sandbox.replay.headless_run import run_headless
        from sandbox.scene import load_scene

        path = shown(self.path, self.config)
        scene = load_scene(path)
        result = Result(path, scene, run_headless(scene))
        if result.verdict != "holds":
            raise UnmetError("\n".join(["an expectation does not hold:", *reasons(result)]))


class ReplayItem(_Item):
    """A recording, or the one that `scene` should have."""

    def __init__(self, *, replay: Path, scene: Path | None = None, **given: Any) -> None:
        super().__init__(**given)
        self._replay, self._scene = replay, scene

    def runtest(self) -> None:
        """Run it again and compare, as `sandbox replay` does."""
        from sandbox.replay.golden.cases import Case
        from sandbox.replay.golden.examine import ReplaySettings, examine
        from sandbox.testing.verdict import verdict

        scene = shown(self._scene, self.config) if self._scene else None
        case = Case(shown(self._replay, self.config), scene)
        note_judged(self, case.replay.as_posix())
        report = examine(case, ReplaySettings(update=self.config.getoption("replay_update") or ""))
        if report.action:
            note_written(self, case.replay.as_posix())
        if not report.fine:
            raise UnmetError(verdict(report))
