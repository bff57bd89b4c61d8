"""A small git repository with a copy of the engine, in whose history one line of the solver changes."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

import sandbox
from sandbox.scene import Scene
from tests.cli.conftest import CRATE, GROUND, cli  # noqa: F401

SOFTER = (
    "sandbox/engine/contact_solver/solve.py",
    "wanted = soft.bias_rate * separation",
    "wanted = 0.9 * soft.bias_rate * separation",
)
"""One line of the solver: what overlaps is pushed apart more slowly."""

PUSHED = CRATE | {"position": [0, 0.52], "velocity": [1.0, -0.5]}


class History:
    """A git repository with a copy of the package; `commits` are its commits, oldest first."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.commits: list[str] = []
        package = Path(sandbox.__file__).parent
        shutil.copytree(package, root / "sandbox", ignore=shutil.ignore_patterns("__pycache__"))
        self.git("init", "--quiet")
        self.commit("the engine as it is")

    def git(self, *arguments: str) -> str:
        names = ("-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "core.autocrlf=false")
        command = ["git", "-C", str(self.root), *names, *arguments]
        return subprocess.run(command, capture_output=True, text=True, check=True, env=_clean()).stdout.strip()

    def commit(self, message: str, file: str = "", old: str = "", new: str = "") -> str:
        """Commit all, with the first `old` in a file replaced."""
        if file:
            path = self.root / file
            text = path.read_text(encoding="utf-8")
            assert old in text
            path.write_text(text.replace(old, new, 1), encoding="utf-8")
        self.git("add", "--all")
        self.git("commit", "--quiet", "--allow-empty", "-m", message)
        self.commits.append(self.git("rev-parse", "HEAD"))
        return self.commits[-1]

    def worktrees(self) -> int:
        return len(self.git("worktree", "list").splitlines())


def _clean() -> dict[str, str]:
    """The environment without what a git hook would set."""
    return {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}


@pytest.fixture(scope="session")
def history(tmp_path_factory: pytest.TempPathFactory) -> History:
    """base, words, BROKEN (cannot be imported), mended, a line of the solver, words."""
    made = History(tmp_path_factory.mktemp("engine"))
    made.commit("words only", "sandbox/errors.py", "Every error", "Each error")
    made.commit("broken", "sandbox/tables.py", "import numpy as np", "import numpy as np !")
    made.commit("mended", "sandbox/tables.py", "import numpy as np !", "import numpy as np")
    made.commit("pushes softer", *SOFTER)
    made.commit("more words", "sandbox/errors.py", "Each error", "All errors")
    return made


@pytest.fixture
def golden(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The recording of a crate that falls and slides, beside its scene."""
    for name in ("CI", "GITHUB_ACTIONS"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("SANDBOX_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    Scene(bodies=[GROUND, PUSHED], settings={"steps": 8}).save("a.scene.json")
    sandbox.record("a.scene.json").save("a.replay.json")
    return Path("a.replay.json")
