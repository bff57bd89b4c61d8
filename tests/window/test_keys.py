"""Keys by name: what menus write can be pressed by a script too."""

from __future__ import annotations

from pathlib import Path

import pytest

from sandbox.errors import SandboxError
from sandbox.window.actions.registry import ACTIONS
from sandbox.window.keys import chord, split
from sandbox.window.script import Script


@pytest.mark.parametrize(
    ("text", "parts"),
    [("+", ([], "+")), ("Ctrl++", (["Ctrl"], "+")), ("Ctrl+Shift+S", (["Ctrl", "Shift"], "S")), ("F8", ([], "F8"))],
)
def test_a_chord_is_its_modifiers_and_a_key(text: str, parts: tuple[list[str], str]) -> None:
    assert split(text) == parts


def test_a_script_can_press_the_keys_of_every_action(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Script, "_post", lambda *given, **named: None)
    acts = tmp_path / "acts.txt"
    for key in (key for action in ACTIONS for key in action.keys):
        acts.write_text(f'key "{key}"\n', encoding="utf-8")
        for _ in Script(acts).hands(lambda point: point):
            pass


def test_a_modifier_that_is_not_there_is_told_with_its_line(tmp_path: Path) -> None:
    acts = tmp_path / "acts.txt"
    acts.write_text("wait 1\nkey Hyper+S\n", encoding="utf-8")
    with pytest.raises(SandboxError, match=r":2: there is no key 'Hyper' to hold; there are Ctrl and Shift"):
        Script(acts)
    with pytest.raises(ValueError, match="Hyper"):
        chord("Hyper+S")
