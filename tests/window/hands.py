"""Real keys and clicks on a real window with all panels, with looks at what has become of them in between."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from sandbox import Scene
from sandbox.window.app import App
from sandbox.window.options import Options
from sandbox.window.play import PlayScreen
from sandbox.window.screen import Canvas, Screen
from sandbox.window.script import Script
from tests.window.resizing import window_of

Act = str | Callable[[PlayScreen], None]
"""Lines of a script (`sandbox.window.script`), or what looks at the screen after those before it."""
SIZE = (1280, 800)


class Hands(App):
    """The program with a scene, and hands that do one act after another."""

    def __init__(self, canvas: Canvas, scene: Scene, folder: Path, acts: Sequence[Act]) -> None:
        scene.save(folder / "played.scene.json")
        empty = folder / "hands.txt"
        empty.write_text("")
        super().__init__(canvas, Options(folder / "played.scene.json", script=empty))
        self.screen: PlayScreen | None = None
        self._at, self._acts = folder, acts
        self._doing: Iterator[None] | None = None

    def _act(self, screen: Screen) -> bool:
        if not isinstance(screen, PlayScreen):
            return True
        if screen is not self.screen:
            self.screen = self._shown = screen
            screen.workspace.folder = self._at
            screen.session.clock.paused = True
        self._doing = self._doing or self._do()
        return next(self._doing, self) is None

    def _do(self) -> Iterator[None]:
        for act in self._acts:
            if callable(act):
                assert self.screen is not None
                act(self.screen)
                continue
            (self._at / "part.txt").write_text(act)
            yield from Script(self._at / "part.txt").hands(self._locate)


def play(canvas: Canvas, scene: Scene, folder: Path, *acts: Act, size: tuple[int, int] = SIZE) -> PlayScreen:
    """Play `scene` in a window of `size` pixels, a step a picture; after the first, time stands still at first."""
    hands = Hands(canvas, scene, folder, acts)
    with window_of(size):
        hands.run()
    assert hands.screen is not None
    return hands.screen
