"""Keys by name: what menus write can be pressed by a script too."""

from __future__ import annotations

from pathlib import Path

import pytest

from sandbox.errors import SandboxError
from sandbox.window.actions.action import Action
from sandbox.window.actions.registry import ACTIONS
from sandbox.window.keys import chord, split
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas
from sandbox.window.script import Script
from tests.window.hands import Act, play
from tests.window.test_session import SCENE


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


def test_keys_of_what_cannot_be_done_now_leave_the_window_as_it_is(canvas: Canvas, tmp_path: Path) -> None:
    """Nothing is selected or copied, nothing was done, and time stands at its beginning."""
    idle = [action for action in ACTIONS if action.keys and action.enabled is not Action.enabled]
    idle = [action for action in idle if action.name not in ("forward", "end")]  # a step is known
    notes: dict[str, str] = {}

    def look(action: Action) -> Act:
        def see(screen: PlayScreen) -> None:
            assert not action.enabled(screen.workspace)
            assert screen.session.timeline.step_count == 0
            notes[action.name], screen.workspace.note = screen.workspace.note, ""

        return see

    acts = [act for action in idle for act in (f'key "{action.keys[0]}"\n', look(action))]
    play(canvas, SCENE, tmp_path, "key Home\nwait 2\n", *acts)
    assert list(notes) == [action.name for action in idle]
    assert notes["other-future"] == "there is no other future: one begins with what you do at an earlier moment"
    assert notes["resume"] == "nothing is known that was done in this scene the last time"


@pytest.mark.parametrize(
    ("act", "said"),
    [
        ("key Hyper+S", "there is no key 'Hyper' to hold; there are Ctrl and Shift"),
        ("hold Rigth for 5", "there is no key 'Rigth'; did you mean \"Right\"?"),
        ("let Right", "only Ctrl, Shift, left, middle, right are let, not 'Right'"),
        ("hold Right for ever", "'hold' takes a whole number there, not 'ever'"),
        ("wait long", "'wait' takes a whole number there, not 'long'"),
    ],
)
def test_a_wrong_act_is_told_with_its_line(tmp_path: Path, act: str, said: str) -> None:
    acts = tmp_path / "acts.txt"
    acts.write_text(f"wait 1\n{act}\n", encoding="utf-8")
    with pytest.raises(SandboxError) as caught:
        Script(acts)
    assert str(caught.value) == f"{acts}:2: {said}"


def test_keys_are_known_as_scenes_write_them() -> None:
    assert chord("left") == chord("Left")
