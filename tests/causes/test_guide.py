"""What the guide to replays prints of an edited scene is what is printed."""

from __future__ import annotations

import re
import shlex
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

import sandbox
from sandbox.resources import scenes_dir
from tests.cli.conftest import cli  # noqa: F401
from tests.git_folder import commit, needs_git

GUIDE = Path(sandbox.__file__).with_name("replay") / "README.md"
PRINTED = re.findall(
    r"^```text\n\$ sandbox ([^\n]*)\n(.*?)^```", GUIDE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
)


def words(line: str) -> list[str]:
    """A line without the time that it took."""
    return re.sub(r"(ramp\.replay\.json +300) +[\d.]+", r"\1", line).split()


@needs_git
@pytest.mark.parametrize(("command", "printed"), PRINTED, ids=[command for command, _ in PRINTED])
def test_every_line_is_printed_in_this_order(cli: Callable, command: str, printed: str) -> None:  # noqa: F811
    for name in ("ramp.scene.json", "ramp.replay.json"):
        shutil.copy(scenes_dir() / "friction" / name, name)
    shutil.copy("ramp.scene.json", "old.scene.json")
    commit()
    scene = Path("ramp.scene.json")
    text = scene.read_text(encoding="utf-8")
    assert text.count('"pine": {"friction": 0.09}') == 1
    scene.write_text(text.replace('"pine": {"friction": 0.09}', '"pine": {"friction": 0.1}'), encoding="utf-8")
    done = cli(*shlex.split(command))
    assert done.code == 1
    left = iter([words(line) for line in done.out.splitlines()])
    assert [line for line in printed.splitlines() if words(line) not in left] == []


def test_there_are_two() -> None:
    assert [command.split()[0] for command, _ in PRINTED] == ["replay", "diff"]
