"""Files that are damaged, newer, hostile or just wrong: one clear error with its place, and nothing else."""

from __future__ import annotations

import contextlib
import json
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sandbox
from sandbox.replay.recording import migrate
from tests.replay.played import COMMANDS, scene


@pytest.fixture(scope="module")
def text(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A recording as it stands in its file."""
    path = tmp_path_factory.mktemp("good") / "good.replay.json"
    sandbox.record(scene(), 20, COMMANDS[:4]).save(path)
    return path.read_text(encoding="utf-8")


def error_of(text: str | bytes, folder: Path) -> str:
    """What is said of a file with that content."""
    path = folder / "bad.replay.json"
    path.write_bytes(text if isinstance(text, bytes) else text.encode("utf-8", "surrogatepass"))
    with pytest.raises(sandbox.RecordingError) as caught:
        sandbox.Recording.load(path)
    lines = str(caught.value).splitlines()
    assert lines[0].startswith(str(path))
    return str(caught.value)


def changed(text: str, change: Callable[[Any], object]) -> str:
    data = json.loads(text)
    change(data)
    return json.dumps(data, indent=1)


def test_cut_off_anywhere(text: str, tmp_path: Path) -> None:
    places = random.Random(3).sample(range(len(text) - 3), 60)
    for place in places:
        said = error_of(text[:place], tmp_path)
        assert "Traceback" not in said


def test_lines_that_are_missing(text: str, tmp_path: Path) -> None:
    lines = text.splitlines()
    first = lines.index('  "digests": [') + 1
    said = error_of("\n".join(lines[:first] + lines[first + 3 :]), tmp_path)
    assert f":{first}:14: 17 fingerprints for 20 steps: the file was cut or edited" in said


def test_one_character_changed_anywhere_is_told_or_changes_the_recording(text: str, tmp_path: Path) -> None:
    draw = random.Random(5)
    good = sandbox.Recording.load(_written(tmp_path, text))
    for _ in range(200):
        place = draw.randrange(len(text))
        damaged = text[:place] + chr(draw.choice((0, 34, 44, 48, 91, 101, 125, 0x2603))) + text[place + 1 :]
        try:
            found = sandbox.Recording.load(_written(tmp_path, damaged))
        except sandbox.RecordingError:
            continue
        assert json.loads(damaged) == json.loads(text) or found != good or damaged == text


def _written(folder: Path, text: str) -> Path:
    path = folder / "one.replay.json"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda d: d.update(format=2), "has format 2 and this version of sandbox reads up to 1"),
        (lambda d: d.update(format="1"), 'a recording begins with "format": 1'),
        (lambda d: d.update(format=True), 'a recording begins with "format": 1'),
        (lambda d: d.pop("format"), 'a recording begins with "format": 1'),
        (lambda d: d.update(steps=10**9), "steps must not be above 1e+06"),
        (lambda d: d.update(steps=19), "20 fingerprints for 19 steps"),
        (lambda d: d.update(steps=-1), "steps must not be below 1"),
        (lambda d: d.update(step_rate=0), "step_rate must not be below 1"),
        (lambda d: d.update(stepz=1), 'unknown field "stepz"'),
        (lambda d: d.update(digests={}), "digests must be a list of fingerprints"),
        (lambda d: d["digests"].__setitem__(4, "0" * 16), "digests[4] must be four times four hex digits"),
        (lambda d: d["digests"].__setitem__(4, 7), "digests[4] must be text"),
        (lambda d: d.update(digest="xyz"), "digest must be 16 hex digits"),
        (lambda d: d.pop("final"), '"final" is missing'),
        (lambda d: d["final"].update(crate=[1, 2]), "needs 3 entries"),
        (lambda d: d["final"].update(crate=[1, 2, "x"]), "must be a number"),
        (lambda d: d["final"].update({"a b": [1, 2, 3]}), "must be 1 to 200 letters"),
        (lambda d: d["scene"].update(path="../../a.scene.json"), 'either a "path" or its "content"'),
        (lambda d: d["scene"].pop("content"), 'either a "path" or its "content"'),
        (lambda d: d["scene"]["content"].update(bodys=[]), 'unknown field "bodys"'),
        (lambda d: d["scene"]["content"]["bodies"][1].update(mass=-1), "mass must not be"),
        (lambda d: d["scene"]["content"]["bodies"][1].update(prefab="nope"), "prefab"),
        (lambda d: d.update(commands=[[21, "EndDrag", {"body": "crate"}]]), "rise from 0 up to 20"),
        (lambda d: d.update(commands=[[1, "os.system", {}]]), 'there is no command "os.system"'),
        (lambda d: d.update(commands=[[1, "EndDrag", {"body": ["crate"]}]]), "body must be text"),
        (lambda d: d.update(commands=[[1.5, "EndDrag", {"body": "crate"}]]), "whole number"),
        (lambda d: d.update(commands=[[1, "EndDrag", []]]), "must be an object"),
        (lambda d: d.update(environment="\x1b[2J"), "environment must be one line that can be printed"),
        (lambda d: d.update(sandbox="1\n::error::"), "sandbox must be one line that can be printed"),
        (lambda d: d.update(environment="x" * 201), "environment must have at most 200 characters"),
        (lambda d: d.update(steps=10**300), "steps must not be above 1e+06"),
        (lambda d: d.update(commands=[[1, "SetGravity", {"gravity": [0, 10**400]}]]), "must be a finite number"),
        (lambda d: d["checkpoints"][0].update(step=99), "the steps of checkpoints rise"),
        (lambda d: d["checkpoints"][0].update(energy="high"), "energy must be a number"),
    ],
)
def test_wrong_members_are_told(text: str, tmp_path: Path, change: Callable[[Any], object], said: str) -> None:
    assert said in error_of(changed(text, change), tmp_path)


@pytest.mark.parametrize(
    "path",
    [
        "/etc/passwd",
        "C:/x.json",
        "..\\x.json",
        "",
        "a" * 2000 + ".json",
        "x.txt",
        "a\0.json",
        "a\x1b[2J.json",
    ],
)
def test_only_ways_from_here_lead_to_a_scene(text: str, tmp_path: Path, path: str) -> None:
    def point(data: Any) -> None:
        del data["scene"]["content"]
        data["scene"]["path"] = path

    assert "path must be the way to a .json file from here" in error_of(changed(text, point), tmp_path)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "the file is empty"),
        (b" \n", "the file is empty"),
        (b"\xff\xfe{\x00}\x00", "UTF-16"),
        (b'{"format": 1, \x80}', "is not UTF-8"),
        (b"[" * 100_000, "nested deeper than 32 levels"),
        (b'{"format": ' + b"[" * 50 + b"]" * 50 + b"}", "nested deeper"),
        (b"[]", "a recording is an object"),
        (b'"x"', "a recording is an object"),
        (b'{"format": 1, "format": 1}', "is missing"),
        (b'{"format": 1e400}', 'begins with "format": 1'),
        (b'{"format": NaN}', 'begins with "format": 1'),
        (b'{"format": ' + b"9" * 10_000 + b"}", 'begins with "format": 1'),
    ],
)
def test_what_is_no_recording_at_all(tmp_path: Path, content: bytes, said: str) -> None:
    assert said in error_of(content, tmp_path)


def test_infinities_and_nans_are_refused(text: str, tmp_path: Path) -> None:
    for number in ("NaN", "Infinity", "-Infinity", "1e999"):
        said = error_of(text.replace('"energy": ', f'"energy": {number}, "x": ', 1), tmp_path)
        assert "energy must be a finite number" in said


def test_a_number_of_thousands_of_digits_spoils_no_other(text: str, tmp_path: Path) -> None:
    said = error_of(text.replace('"steps": 20', f'"steps": {"9" * 5000}', 1), tmp_path)
    assert "steps must be a whole number" in said
    assert "format" not in said


def test_a_file_or_folder_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(sandbox.RecordingError, match="no such file"):
        sandbox.Recording.load(tmp_path / "none.replay.json")
    with pytest.raises(sandbox.RecordingError, match="not a recording file"):
        sandbox.Recording.load(tmp_path)


def test_a_file_that_is_too_large_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "large.replay.json"
    with path.open("wb") as file:
        file.truncate(65 * 1024 * 1024)
    with pytest.raises(sandbox.RecordingError, match="larger than 64 MiB, the limit of a recording"):
        sandbox.Recording.load(path)


def test_an_older_format_is_carried_over_step_by_step(
    text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As if two later formats had called the fingerprints and the figures otherwise."""
    monkeypatch.setattr(migrate, "FORMAT", 3)
    monkeypatch.setitem(migrate.MIGRATIONS, 1, lambda data: {**data, "marks": data["digests"]})
    monkeypatch.setitem(
        migrate.MIGRATIONS,
        2,
        lambda data: {key: value for key, value in data.items() if key != "marks"} | {"digests": data["marks"]},
    )
    loaded = sandbox.Recording.load(_written(tmp_path, text))
    assert sandbox.rerun(loaded).passed
    assert "up to 3" in error_of(text.replace('"format": 1,', '"format": 4,', 1), tmp_path)


@given(data=st.data())
def test_any_member_may_be_anything(text: str, data: st.DataObject, tmp_path_factory: pytest.TempPathFactory) -> None:
    """Wrong values anywhere give the error, or a recording that can be saved again."""
    whole = json.loads(text)
    node: Any = whole
    for _ in range(data.draw(st.integers(1, 4))):
        keys = list(node) if isinstance(node, dict) else list(range(len(node)))
        key = data.draw(st.sampled_from(keys))
        parent, node = node, node[key]
        if not isinstance(node, (dict, list)) or not node:
            break
    parent[key] = data.draw(_junk())
    folder = tmp_path_factory.mktemp("junk", numbered=True)
    path = _written(folder, json.dumps(whole))
    with contextlib.suppress(sandbox.RecordingError):
        sandbox.Recording.load(path).save(path)


def _junk() -> st.SearchStrategy[Any]:
    numbers = st.integers(-(10**30), 10**30) | st.floats()
    leaf = st.none() | st.booleans() | numbers | st.text(st.characters(exclude_categories=["Cs"]), max_size=20)
    return st.recursive(leaf, lambda s: st.lists(s, max_size=3) | st.dictionaries(st.text(max_size=5), s, max_size=3))
