"""Files are written whole or not at all: what was there survives, and nothing else is left behind."""

from __future__ import annotations

import errno
import json
import os
import stat
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from sandbox._atomic_write import check_writable, write_bytes, write_text

posix = pytest.mark.skipif(os.name != "posix", reason="permissions, pipes and limits of POSIX")
a_user = pytest.mark.skipif(getattr(os, "geteuid", lambda: 1)() == 0, reason="the administrator may write everything")


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    """A file that must not be harmed."""
    path = tmp_path / "kept.txt"
    path.write_text("what was there")
    return path


@contextmanager
def full_disk() -> Iterator[None]:
    """No file may grow beyond 100 bytes: no longer than must be, as pytest's own output may go into one."""
    resource = pytest.importorskip("resource")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def test_text_is_utf8_with_plain_line_ends(tmp_path):
    path = tmp_path / "a.txt"
    write_text(path, "é\nb\n")
    assert path.read_bytes() == "é\nb\n".encode()
    assert os.listdir(tmp_path) == ["a.txt"]


def test_half_a_character_is_written_as_json_has_it(tmp_path):
    """As of a file whose name is no UTF-8: a page of it was an error of this program."""
    path = tmp_path / "a.json"
    write_text(path, '"\ud800 b"')
    assert path.read_bytes() == b'"\\ud800 b"'
    assert json.loads(path.read_text()) == "\ud800 b"


def test_a_full_disk_leaves_what_was_there_and_nothing_else(kept):
    with full_disk(), pytest.raises(OSError, match=r"it cannot be written: ") as caught:
        write_bytes(kept, b"x" * 1000)
    assert (caught.value.errno, caught.value.filename) == (errno.EFBIG, str(kept))
    with full_disk(), pytest.raises(OSError, match=r"it cannot be written: "):
        write_bytes(kept.with_name("new.txt"), b"x" * 1000)
    assert kept.read_text() == "what was there"
    assert os.listdir(kept.parent) == ["kept.txt"]


@pytest.mark.parametrize("refuses", ["replace", "fsync", "open"])
def test_any_failure_leaves_what_was_there_and_nothing_else(kept, monkeypatch, refuses):
    def fail(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, refuses, fail)
    with pytest.raises(OSError, match=r"it cannot be written: No space") as caught:
        write_bytes(kept, b"x")
    monkeypatch.undo()
    assert caught.value.filename == str(kept)
    assert kept.read_text() == "what was there"
    assert os.listdir(kept.parent) == ["kept.txt"]


def test_an_interrupt_leaves_nothing_behind(kept, monkeypatch):
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupt)
    with pytest.raises(KeyboardInterrupt):
        write_bytes(kept, b"x")
    monkeypatch.undo()
    assert os.listdir(kept.parent) == ["kept.txt"]


def test_a_file_system_that_cannot_sync_is_written_to(kept, monkeypatch):
    def fail(_: int) -> None:
        raise OSError(errno.EINVAL, "cannot sync")

    monkeypatch.setattr(os, "fsync", fail)
    write_bytes(kept, b"x")
    assert kept.read_bytes() == b"x"


@posix
@pytest.mark.parametrize("mode", [0o640, 0o600, 0o666, 0o755])
def test_permissions_are_kept(kept, mode):
    kept.chmod(mode)
    write_bytes(kept, b"new")
    assert (stat.S_IMODE(kept.stat().st_mode), kept.read_bytes()) == (mode, b"new")


@posix
def test_a_new_file_has_the_usual_permissions(tmp_path):
    (tmp_path / "usual").write_text("")
    write_bytes(tmp_path / "new", b"")
    assert (tmp_path / "new").stat().st_mode == (tmp_path / "usual").stat().st_mode


@posix
def test_links_are_followed(kept, tmp_path):
    (tmp_path / "far").mkdir()
    link, hanging = tmp_path / "far/link", tmp_path / "far/hanging"
    link.symlink_to("../kept.txt")
    hanging.symlink_to("../comes.txt")
    write_bytes(link, b"one")
    write_bytes(hanging, b"two")
    assert (link.is_symlink(), hanging.is_symlink()) == (True, True)
    assert (kept.read_bytes(), (tmp_path / "comes.txt").read_bytes()) == (b"one", b"two")
    assert sorted(os.listdir(tmp_path / "far")) == ["hanging", "link"]


@posix
def test_a_pipe_and_a_device_are_written_as_they_are(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    got: list[bytes] = []
    reader = threading.Thread(target=lambda: got.append(pipe.read_bytes()))
    reader.start()
    check_writable(pipe)
    write_bytes(pipe, b"through")
    reader.join()
    write_bytes(Path(os.devnull), b"away")
    assert (got, os.listdir(tmp_path)) == ([b"through"], ["pipe"])
    assert not Path(os.devnull).is_file()


@pytest.mark.skipif(not os.path.exists("/dev/stdout"), reason="has no /dev/stdout")
def test_stdout_goes_on_where_it_is(capfd):
    print("before")
    write_text(Path("/dev/stdout"), "between\n")
    print("after")
    assert capfd.readouterr().out == "before\nbetween\nafter\n"


@posix
@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="has no /dev/full")
def test_a_full_device_is_told():
    with pytest.raises(OSError, match="/dev/full") as caught:
        write_bytes(Path("/dev/full"), b"x" * 100)
    assert caught.value.errno == errno.ENOSPC


def refused(path: Path, words: str) -> None:
    """Both refuse it with the same words."""
    for refuse in (lambda: check_writable(path), lambda: write_bytes(path, b"x")):
        with pytest.raises(OSError, match=words) as caught:
            refuse()
        assert caught.value.filename == str(path)


def test_what_can_be_told_before(tmp_path, kept):
    refused(tmp_path, "it is a folder")
    refused(tmp_path / "no" / "a.txt", "does not exist")
    refused(kept / "a.txt", "(?i)not a directory|does not exist")
    check_writable(kept)
    check_writable(tmp_path / "new.txt")
    assert os.listdir(tmp_path) == ["kept.txt"]


@posix
@a_user
def test_what_may_not_be_written_is_not(kept):
    kept.chmod(0o444)
    refused(kept, "Permission denied")
    kept.chmod(0o644)
    kept.parent.chmod(0o555)
    refused(kept, "cannot be written to")
    kept.parent.chmod(0o755)
    assert kept.read_text() == "what was there"


@pytest.mark.parametrize("links", [True, False], ids=["links", "no links"])
def test_of_several_who_write_a_new_file_at_once_one_does(tmp_path, monkeypatch, links):
    if not links:
        monkeypatch.setattr(os, "link", lambda *_: (_ for _ in ()).throw(PermissionError(errno.EPERM, "no links")))
    start, refused = threading.Barrier(8), []

    def write(number: int) -> None:
        start.wait()
        try:
            write_text(tmp_path / "new.txt", f"{number}\n" * 1000, over=False)
        except FileExistsError as error:
            refused.append(error)

    threads = [threading.Thread(target=write, args=(number,)) for number in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    lines = (tmp_path / "new.txt").read_text().splitlines()
    assert (len(lines), len(set(lines)), len(refused)) == (1000, 1, 7)
    assert {error.filename for error in refused} == {str(tmp_path / "new.txt")}
    assert os.listdir(tmp_path) == ["new.txt"]
