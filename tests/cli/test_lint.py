"""`sandbox lint`: what it prints, and what it ends with."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

from sandbox.lint.registry import RULES
from tests.lint.cases import BALL, CRATE, GROUND


def test_lint_tells_file_line_rule_and_mend(cli: Callable, tmp_path: Path) -> None:
    path = tmp_path / "a.scene.json"
    path.write_text(json.dumps({"bodies": [GROUND, {**CRATE, "position": [0, 0]}, BALL], "prefabs": {"p": {}}}))
    done = cli("lint", tmp_path)
    assert done.code == 1
    assert f"{path}:1:1: no-expect: the scene expects nothing" in done.out
    assert done.out.endswith("1 scene: 3 findings\n")
    document = json.loads(cli("lint", path, "--json", "--ignore", "unused,overlap").out)
    assert document["exit_code"] == 1
    assert [each["rule"] for each in document["scenes"][0]["findings"]] == ["no-expect"]
    assert cli("lint", path, "--select", "static-wheel").code == 0
    done = cli("lint", path, "--select", "static-wheels")
    assert done.code == 2
    assert 'did you mean "static-wheel"?' in done.err
    assert [line.split()[0] for line in cli("lint", "--rules").out.splitlines()] == list(RULES)
    path.write_text("{")
    assert cli("lint", path).code == 2
