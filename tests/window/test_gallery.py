"""The gallery: what it lists, what is found by words, and its pictures."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from sandbox.render.thumbnail import thumbnail
from sandbox.scene.catalog import Entry, search, shipped_entries
from sandbox.window import thumbnails
from sandbox.window.path_search import is_path, path_entries
from sandbox.window.recent import note_recent, recent_files
from sandbox.window.scene_index import OWN, RECENT, scene_entries
from tests.window.test_session import SCENE


def test_recent_files_are_listed_once_the_last_one_first(tmp_path: Path) -> None:
    files = [tmp_path / f"{name}.scene.json" for name in "abc"]
    for file in files:
        SCENE.save(file)
        note_recent(tmp_path / "state", file)
    note_recent(tmp_path / "state", files[0])
    files[2].unlink()
    assert recent_files(tmp_path / "state") == [files[0], files[1]]


@pytest.mark.parametrize("text", ["", "{", "3", "[[]]", '["\\u0000"]'])
def test_a_damaged_list_of_recent_files_is_an_empty_one(tmp_path: Path, text: str) -> None:
    (tmp_path / "recent.json").write_text(text)
    assert recent_files(tmp_path) == []


def test_recent_and_own_files_come_before_the_shipped_ones(tmp_path: Path) -> None:
    for name in ("mine", "below/deeper"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        SCENE.save(tmp_path / f"{name}.scene.json")
    note_recent(tmp_path / "state", tmp_path / "mine.scene.json")
    entries = scene_entries(tmp_path / "state", tmp_path)
    first = [(entry.theme, entry.path.name) for entry in entries[:3]]
    assert first == [
        (RECENT, "mine.scene.json"), (OWN, "mine.scene.json"), (OWN, "deeper.scene.json"),
    ]  # fmt: skip
    assert entries[3].theme == "first"
    assert {entry.title for entry in entries[:3]} == {"Two crates"}


def test_a_mistake_in_drawing_one_file_is_told_and_the_others_get_their_pictures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def draw(path: Path) -> bytes | None:
        if path.stem == "bad":
            raise IndexError("beyond the end")
        return b"pixels"

    told: list[Any] = []
    monkeypatch.setattr(thumbnails, "_pixels", draw)
    monkeypatch.setattr(threading, "excepthook", lambda args: told.append(args.exc_value))
    drawn = Drawn(None)
    wanted = [tmp_path / "good", tmp_path / "bad"]  # what was asked for last is drawn first
    for path in wanted:
        drawn.texture(path)
    while drawn.left(wanted):
        time.sleep(0.001)
    drawn.close()
    assert [drawn.texture(path) for path in wanted] == [b"pixels", None]
    assert [str(error) for error in told] == ["beyond the end"]


class Drawn(thumbnails.Thumbnails):
    """Pictures that need no OpenGL."""

    def left(self, paths: list[Path]) -> bool:
        return any(path not in self._drawn for path in paths) and self._thread.is_alive()

    def _upload(self, pixels: bytes) -> Any:
        return pixels


def test_words_find_whatever_has_them_all() -> None:
    entry = Entry(Path("long-bridge.scene.json"), "A bridge of 160 planks", "It hangs.", "joints")
    assert all(search([entry], words) for words in ("", "bridge", "JOINT plank", "hangs 160", "long-br"))
    assert not any(search([entry], words) for words in ("bridges", "joint pyramid"))


def test_what_bears_the_word_in_its_title_comes_first_and_no_file_comes_twice() -> None:
    entries = shipped_entries()
    found = [entry.path.name.split(".")[0] for entry in search(entries, "dom")]
    assert set(found[:3]) == {"domino-run", "dominoes", "growing-dominoes"}
    assert len(found) > 3
    assert len(search([*entries, *entries], "dom")) == len(found)
    assert search(entries, "") == entries


def test_a_path_finds_folders_scenes_and_recordings(tmp_path: Path) -> None:
    (tmp_path / "deep").mkdir()
    (tmp_path / ".hidden").mkdir()
    for name in ("deep/a.scene.json", "drop.scene.json", "drop.replay.json", "other.json"):
        (tmp_path / name).write_text("{}")
    assert all(map(is_path, (str(tmp_path), "~/x", "./x")))
    assert not is_path("bridge")
    assert [entry.title for entry in path_entries(f"{tmp_path}{os.sep}")] == [
        f"deep{os.sep}", "drop.replay.json", "drop",
    ]  # fmt: skip
    assert [entry.path for entry in path_entries(str(tmp_path / "DE"))] == [tmp_path / "deep"]
    assert path_entries(str(tmp_path / "nowhere" / "x")) == []


def test_a_thumbnail_shows_the_scene_in_motion() -> None:
    picture = thumbnail(SCENE, (304, 171))
    assert picture.size == (304, 171)
    colors = np.asarray(picture.convert("RGB")).reshape(-1, 3)
    assert len(np.unique(colors, axis=0)) > 50


def gallery(tmp_path: Path, script: str) -> subprocess.CompletedProcess[str]:
    (tmp_path / "hands.txt").write_text(script)
    environment = {**os.environ, "SANDBOX_STATE_DIR": str(tmp_path / "state")}
    command = [sys.executable, "-m", "sandbox", "run", "--size", "1000x700", "--script", "hands.txt"]
    return subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)


def test_what_is_typed_filters_and_enter_opens(display: Any, tmp_path: Path) -> None:
    SCENE.save(tmp_path / "mine.scene.json")
    script = "type two crates mine\nwait 90\nshot found.png\nkey Enter\nwait 5\nkey S\nkey Esc\nwait 2\nkey Esc\n"
    done = gallery(tmp_path, script)
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "mine.replay.json").is_file()
    assert recent_files(tmp_path / "state") == [tmp_path / "mine.scene.json"]
    with Image.open(tmp_path / "found.png") as image:
        shown = np.asarray(image.convert("RGB")).astype(int)
    # One card, at the left; where a second one would be there is nothing.
    assert shown[200:320, 40:240].std(axis=(0, 1)).max() > 5.0
    assert shown[200:320, 300:900].std(axis=(0, 1)).max() < 0.5


@pytest.mark.slow
def test_a_scene_is_opened_by_its_path_folder_by_folder(display: Any, tmp_path: Path) -> None:
    (tmp_path / "deep").mkdir()
    SCENE.save(tmp_path / "deep" / "inner.scene.json")
    done = gallery(
        tmp_path,
        "wait 9\ntype .\nwait 9\ntype /dee\nkey Enter\nwait 3\ntype inn\nwait 2\nkey Enter\nwait 5\nkey S\nquit\n",
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "inner.replay.json").is_file()


@pytest.mark.slow
def test_a_file_that_is_gone_leads_back_with_a_message(display: Any, tmp_path: Path) -> None:
    (tmp_path / "bad.scene.json").write_text('{"format": 1, "bodys": []}')
    done = gallery(tmp_path, "type bad\nkey Enter\nwait 5\nshot told.png\nkey Esc\nkey Esc\n")
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "told.png").is_file()
