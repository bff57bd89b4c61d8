"""Files as others hand them on: packed, in other encodings, or wrapped in a script."""

from __future__ import annotations

import gzip
import json
from pathlib import Path

import pytest

from sandbox.errors import SceneError
from sandbox.formats import decoded, import_scene
from sandbox.formats.decoded import unwrapped

SCENE = {"gravity": 0, "body": [{"name": "bál", "type": 0, "fixture": [{"circle": {"radius": 1}}]}]}
TEXT = json.dumps(SCENE, ensure_ascii=False)
DRAWING = '<?xml version="1.0" encoding="{}"?><svg width="64" height="64"><circle id="bál" r="32"/></svg>'


@pytest.mark.parametrize(
    "data",
    [
        f"var scene =\n{TEXT};\n".encode(),
        f"// made by hand\nwindow.levels['one'] = {TEXT}".encode(),
        f"module.exports = {TEXT};".encode(),
        f'(function(name,data){{\n if (x) {{ f(name,data); }}\n}})("level",\n{TEXT});'.encode(),
        gzip.compress(TEXT.encode(), mtime=0),
        TEXT.encode("utf-16"),
        DRAWING.format("iso-8859-1").encode("latin-1"),
        DRAWING.format("windows-1252").encode("cp1252"),
        DRAWING.format("UTF-16").encode("utf-16"),
    ],
)
def test_is_read_all_the_same(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "file"
    path.write_bytes(data)
    assert [body.id for body in import_scene(path).scene.bodies] == ["bál"]


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (gzip.compress(TEXT.encode(), mtime=0)[:9] + b"??", "packed by gzip and cannot be unpacked"),
        (gzip.compress(bytes(2000), mtime=0), "unpacks to more than"),
        (DRAWING.format("utf-16").encode(), "is not utf-16, as it says it is"),
    ],
)
def test_damage_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, data: bytes, message: str) -> None:
    monkeypatch.setattr(decoded, "MAX_BYTES", 1000)
    path = tmp_path / "file"
    path.write_bytes(data)
    with pytest.raises(SceneError, match=message):
        import_scene(path)


@pytest.mark.parametrize(
    "text", ["var a = {}; f({})", "a = b", "/**/ " * 900, "(function(name,data){" + '})("a",' * 900]
)
def test_other_scripts_stay_as_they_are(text: str) -> None:
    assert unwrapped(text) in (text, "        {}; f({}")
