"""Whatever is found under a path: a scene or one clear line."""

from __future__ import annotations

import os

import pytest

from sandbox.errors import SceneError
from sandbox.scene import load_scene
from sandbox.scene.limits import MAX_BYTES


def unreadable(path) -> str:
    with pytest.raises(SceneError) as caught:
        load_scene(path)
    return str(caught.value)


def test_a_missing_file_is_told_with_the_nearest_name(tmp_path):
    (tmp_path / "pyramid.scene.json").write_text("{}")
    told = unreadable(tmp_path / "piramid.scene.json")
    assert told == f'{tmp_path}/piramid.scene.json: there is no such file: did you mean "pyramid.scene.json"?'
    for path in (tmp_path / "card-house.json", tmp_path / "none" / "x.json"):
        assert unreadable(path) == f"{path}: there is no such file"
    assert unreadable("-") == "-: there is no such file: what a pipe brings is /dev/stdin"


@pytest.mark.skipif(os.name != "posix", reason="links need rights elsewhere")
def test_a_link_to_nothing_is_not_what_is_meant(tmp_path):
    path = tmp_path / "crate.scene.json"
    path.symlink_to("nowhere")
    with pytest.raises(SceneError, match=r": it is a link to what is not there$"):
        load_scene(path)


def test_a_folder_is_no_scene(tmp_path):
    assert unreadable(tmp_path) == f"{tmp_path}: this is a folder, not a scene file"


def test_an_impossible_path_is_no_scene():
    assert "cannot be read" in unreadable("a\0b")


def test_a_file_over_the_limit_is_not_parsed(tmp_path):
    path = tmp_path / "x.json"
    path.write_bytes(b" " * (MAX_BYTES + 1))
    assert "larger than 16 MiB" in unreadable(path)


def test_what_is_not_utf8_is_told_at_its_byte(tmp_path):
    path = tmp_path / "x.json"
    path.write_bytes('{\n"title": "Größe"}'.encode("latin-1"))
    assert f"{path}:2:13: the byte 0xf6 is not UTF-8: save the file as UTF-8" in unreadable(path)
    for encoding in ("utf-16", "utf-16-le", "utf-16-be"):
        path.write_text('{"title": "Größe"}', encoding=encoding)
        assert "it looks like UTF-16" in unreadable(path)
    path.write_bytes(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\5\0\0\0\3 " + bytes(range(1, 256)))
    assert f"{path}: this is no text, but a picture" in unreadable(path)
