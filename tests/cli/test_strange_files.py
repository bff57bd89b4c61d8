"""Pipes, sockets, devices and folders that are named like scenes and recordings are refused, and nobody waits."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import sandbox
from sandbox._bounded_read import is_regular, read_bytes
from sandbox._lent import is_lent, lent_number

pytestmark = pytest.mark.skipif(os.name != "posix", reason="has no pipes among its files")
SCENE = '{"format": 1, "bodies": [{"id": "ball", "shapes": [{"circle": 1}]}], "settings": {"steps": 3}}'


def _socket(path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as one:
        one.bind(os.path.relpath(path))


STRANGE: dict[str, tuple[Callable[[Path], object], str]] = {
    "pipe": (os.mkfifo, "it is a pipe, not a regular file"),
    "socket": (_socket, "it is a socket, not a regular file"),
    "device": (lambda path: path.symlink_to("/dev/zero"), "it is a device, not a regular file"),
    "loop": (lambda path: path.symlink_to(path.name), "cannot be read: Too many levels of symbolic links"),
}


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Everything happens in an empty folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("name", STRANGE)
@pytest.mark.parametrize("ending", [".scene.json", ".replay.json"])
def test_it_is_told_and_the_others_run(cli: Callable, here: Path, name: str, ending: str) -> None:
    make, words = STRANGE[name]
    folder = here / "all"
    folder.mkdir()
    make(folder / f"strange{ending}")
    (folder / "fine.scene.json").write_text(SCENE)
    done = cli("check" if ending == ".scene.json" else "replay", folder)
    assert done.code == 2
    assert words in done.err
    assert done.err.count("\n") == 1


@pytest.mark.parametrize("name", STRANGE)
@pytest.mark.parametrize(
    "arguments",
    [
        ["run"], ["check"], ["events"], ["sat"], ["solver"], ["compare"], ["bench"], ["render", "-o", "x.png"],
        ["render", "-o", "x.html"], ["record", "-o", "x.replay.json"], ["replay"],
        ["record", "pyramid-10", "-o", "x.replay.json", "--commands"],
    ],
    ids=" ".join,
)  # fmt: skip
def test_every_command_refuses_it(cli: Callable, here: Path, arguments: list[str], name: str) -> None:
    make, words = STRANGE[name]
    make(here / "strange.scene.json")
    done = cli(*arguments, "strange.scene.json")
    assert done.code == 2
    assert words in done.err
    assert os.listdir(here) == ["strange.scene.json"]


@pytest.mark.parametrize("name", ["strange.replay.json", "none.scene.json", "."])
def test_no_window_opens_for_what_is_no_file(
    cli: Callable, here: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    """It is told of first even where no window could be opened."""
    os.mkfifo(here / "strange.replay.json")
    monkeypatch.setenv("SDL_VIDEODRIVER", "none")
    done = cli("run", name)
    words = {"strange.replay.json": "it is a pipe", "none.scene.json": "no such file", ".": "this is a folder"}
    assert (done.code, words[name] in done.err, done.err.count("\n")) == (2, True, 1)


def test_a_pipe_in_the_place_of_a_recording_is_not_written_to(cli: Callable, here: Path) -> None:
    (here / "a.scene.json").write_text(SCENE)
    os.mkfifo("a.replay.json")
    assert cli("replay", "a.scene.json", "--update=all").code == 2
    assert cli("record", "a.scene.json", "-o", "a.replay.json").code == 2


def test_a_page_of_a_strange_recording_is_refused(cli: Callable, here: Path) -> None:
    os.mkfifo("a.replay.json")
    done = cli("render", "a.replay.json", "-o", "x.html")
    assert (done.code, "it is a pipe" in done.err) == (2, True)


@pytest.mark.skipif(not os.path.exists("/dev/fd"), reason="has no /dev/fd")
@pytest.mark.parametrize(("fed", "code"), [(SCENE, 0), (" " * (17 << 20), 2)], ids=["scene", "endless"])
def test_what_a_shell_lends_is_read_to_the_limit(fed: str, code: int) -> None:
    reading, writing = os.pipe()

    def feed() -> None:
        try:
            with os.fdopen(writing, "w") as file:
                file.write(fed)
        except BrokenPipeError:
            pass

    feeder = threading.Thread(target=feed)
    feeder.start()
    command = [sys.executable, "-m", "sandbox", "check", f"/dev/fd/{reading}"]
    done = subprocess.run(command, pass_fds=[reading], capture_output=True, text=True)
    os.close(reading)
    feeder.join()
    assert done.returncode == code, done.stderr
    assert ("the file is larger than 16 MiB" in done.stderr) == (code == 2)


@pytest.fixture
def lend(here: Path) -> Iterator[Callable[[str], str]]:
    """Lends this process a pipe with a text in it, as a shell does for `<(command)`; its name."""
    numbers = []

    def make(text: str) -> str:
        reading, writing = os.pipe()
        numbers.append(reading)
        threading.Thread(target=lambda: (os.write(writing, text.encode()), os.close(writing))).start()
        return f"/dev/fd/{reading}"

    yield make
    for number in numbers:
        os.close(number)


@pytest.mark.skipif(not os.path.exists("/dev/fd"), reason="has no /dev/fd")
class TestLent:
    """What a shell lends is a scene or a recording as its contents say, and in the current folder."""

    @pytest.fixture
    def recording(self, cli: Callable) -> str:
        Path("a.scene.json").write_text(SCENE)
        assert cli("record", "a.scene.json", "-o", "a.replay.json").code == 0
        return Path("a.replay.json").read_text()

    @pytest.mark.parametrize(
        "arguments",
        [
            ["replay"], ["replay", "-j", "2", "a.replay.json"], ["diff", "a.scene.json"], ["diff", "a.replay.json"],
            ["render", "-o", "x.png", "--size", "64x48"], ["render", "-o", "x.gif", "--size", "64x48"],
            ["render", "-o", "x.html"], ["replay", "--report", "x.html"],
            ["record", "a.scene.json", "-o", "b.replay.json", "--commands"],
        ],
        ids=" ".join,
    )  # fmt: skip
    @pytest.mark.slow
    def test_a_recording_is_one(self, cli: Callable, recording: str, lend: Callable, arguments: list[str]) -> None:
        done = cli(*arguments, lend(recording))
        assert (done.code, done.err) == (0, "")

    @pytest.mark.parametrize("jobs", [1, 2])
    @pytest.mark.slow
    def test_scenes_are_read_once_for_all_processes(self, cli: Callable, lend: Callable, jobs: int) -> None:
        done = cli("check", "-j", jobs, lend(SCENE), lend(SCENE))
        assert (done.code, "2 scenes: 2 hold" in done.out) == (0, True), done.err

    def test_a_scene_is_no_recording(self, cli: Callable, lend: Callable) -> None:
        done = cli("replay", lend(SCENE))
        assert (done.code, "this is a scene, not a recording: sandbox record makes one of it" in done.err) == (2, True)

    def test_nothing_is_written_to_it(
        self, cli: Callable, recording: str, lend: Callable, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.delenv("CI", raising=False)  # there recordings are never updated
        for done in (cli("replay", "--update=all", lend(recording)), cli("fmt", lend(SCENE))):
            told = "it cannot be written: it is lent to be read only; name the file itself"
            assert (done.code, told in done.err) == (2, True)

    def test_one_whose_scene_is_gone_is_not_removed(
        self, cli: Callable, recording: str, lend: Callable, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.delenv("CI", raising=False)  # there recordings are never removed
        os.remove("a.scene.json")
        removed: list[str] = []
        monkeypatch.setattr(Path, "unlink", lambda path, **_: removed.append(str(path)))
        done = cli("replay", "--prune", lend(recording))
        assert (done.code, "orphaned" in done.out) == (1, True)
        assert not [name for name in removed if name.startswith("/dev")]

    def test_an_output_needs_no_force(self, cli: Callable, here: Path) -> None:
        Path("a.scene.json").write_text(SCENE)
        reading, writing = os.pipe()
        assert cli("expand", "a.scene.json", "-o", f"/dev/fd/{writing}").code == 0
        os.close(writing)
        with os.fdopen(reading) as file:
            assert "ball" in file.read()

    def test_it_has_no_files_beside_it(self, cli: Callable, lend: Callable) -> None:
        done = cli("check", lend(SCENE.replace('"format"', '"include": ["b.json"], "format"')))
        assert (done.code, "a scene that is in no file includes only what comes" in done.err) == (2, True)


def test_streams_of_other_processes_are_not_ours() -> None:
    own = {"/dev/stdin": 0, "/dev/fd/7": 7, "/proc/self/fd/3": 3, f"/proc/{os.getpid()}/fd/3": 3}
    assert {name: lent_number(Path(name)) for name in own} == own
    assert is_lent(Path("/proc/1/fd/3"))
    assert lent_number(Path("/proc/1/fd/3")) is None
    assert not is_lent(Path("/dev/null"))


def test_reading_stops_at_the_limit(here: Path) -> None:
    (here / "a").write_bytes(b"x" * 5_000_000)
    assert len(read_bytes(here / "a", 3_000_000)) == 3_000_000
    assert read_bytes(here / "a", 10**9) == b"x" * 5_000_000
    assert is_regular(here / "a")
    assert not is_regular(here)
    assert not is_regular(here / "none")
    assert not is_regular(Path("a\0b"))


def test_a_scene_of_a_pipe_is_refused_in_python(here: Path) -> None:
    os.mkfifo("a.json")
    with pytest.raises(sandbox.SceneError, match="it is a pipe, not a regular file"):
        sandbox.load_scene("a.json")
    with pytest.raises(sandbox.RecordingError, match="it is a pipe, not a regular file"):
        sandbox.Recording.load("a.json")


@pytest.mark.parametrize("name", STRANGE)
def test_a_gallery_shows_the_others(cli: Callable, here: Path, name: str) -> None:
    folder = here / "all"
    folder.mkdir()
    STRANGE[name][0](folder / "strange.scene.json")
    (folder / "fine.scene.json").write_text(SCENE)
    done = cli("gallery", folder, "-o", "page.html")
    assert done.code == 2
    assert "strange.scene.json" in done.err
    assert "<h3>fine</h3>" in (here / "page.html").read_text()
