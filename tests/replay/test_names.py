"""Whatever is recorded can be replayed, whatever its files and bodies are called."""

from __future__ import annotations

import os
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.replay.recording import write
from tests.examples import examples

SCENE = '{"format": 1, "bodies": [{"id": "ball", "shapes": [{"circle": 1}]}]}'
AWKWARD = [
    "run:1",
    "C:",
    "C:x",
    "a\\b",
    "a\nb",
    "a\x1b[31mb",
    "\u202ea",
    "\u2028",
    "a\udc80b",
    "..a",
    " a",
    'a"b',
    "%20",
]


def names() -> st.SearchStrategy[str]:
    """What a POSIX file system takes as a name, bytes that are no UTF-8 included."""
    letters = st.characters(exclude_characters="/\0") | st.characters(min_codepoint=0xDC80, max_codepoint=0xDCFF)
    return st.sampled_from(AWKWARD) | st.text(letters, min_size=1, max_size=40).filter(is_name)


def is_name(text: str) -> bool:
    """Whether it can be encoded, and is no folder."""
    try:
        os.fsencode(text)
    except UnicodeEncodeError:
        return False
    return text not in (".", "..")


def put(home: Path, folder: str, name: str) -> Path:
    """A scene file; skipped where the file system does not take the name."""
    try:
        (home / folder).mkdir()
        path = home / folder / name
        path.write_text(SCENE)
        assert path.name in os.listdir(path.parent)
    except (OSError, ValueError, AssertionError):
        pytest.skip("no such name on this system")
    return path


@examples(200)
@given(names(), names(), st.sampled_from([".scene.json", ".json", ".txt", ""]), st.sampled_from([None, True]))
def test_a_recording_of_a_scene_of_any_name_can_be_replayed(folder, stem, suffix, embed):
    with TemporaryDirectory() as home:
        scene = put(Path(home), folder, stem + suffix)
        recording = Path(home, "a.replay.json")
        sandbox.record(scene, 2).save(recording, embed=embed)
        assert sandbox.rerun(sandbox.Recording.load(recording)).passed


@pytest.mark.skipif(os.name != "posix", reason="has names that Windows does not take")
@pytest.mark.parametrize("name", ["a\\b.json", "a\nb.json", "a.txt", "C:.json"])
def test_a_way_that_cannot_be_said_is_embedded_or_refused(tmp_path, name):
    recording, path = sandbox.record(put(tmp_path, "x", name), 2), tmp_path / "x" / "a.replay.json"
    recording.save(path)
    assert sandbox.Recording.load(path).scene.content is not None
    with pytest.raises(sandbox.RecordingError, match="cannot stand in a recording: rename that file, or embed it"):
        recording.save(path, embed=False)


def test_a_colon_is_a_letter_like_others(tmp_path):
    path = put(tmp_path, "at 12:30", "run:1.scene.json")
    sandbox.record(path, 2).save(tmp_path / "a.replay.json")
    assert sandbox.Recording.load(tmp_path / "a.replay.json").scene.path == tmp_path / "at 12:30" / "run:1.scene.json"


def test_generated_bodies_have_longer_ids(tmp_path):
    scene = sandbox.Scene(
        prefabs={"ball": {"shapes": [{"circle": 0.1}]}}, generate=[{"id": "x" * 100, "pyramid": "ball", "rows": 2}]
    )
    sandbox.record(scene, 2).save(tmp_path / "a.replay.json")
    assert len(sandbox.Recording.load(tmp_path / "a.replay.json").final) == 3


def test_what_is_too_large_to_be_read_is_not_written(tmp_path, monkeypatch):
    monkeypatch.setattr(write, "MAX_BYTES", 500)
    with pytest.raises(sandbox.RecordingError, match="at most 0 MiB"):
        sandbox.record(sandbox.loads_scene(SCENE), 50).save(tmp_path / "a.replay.json")
    assert os.listdir(tmp_path) == []
