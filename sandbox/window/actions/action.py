"""What an action is: something the user can ask for by a key, in a menu, or by a button."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from sandbox.window.workspace import Workspace


def _always(workspace: Workspace) -> bool:
    return True


@dataclass(frozen=True)
class Action:
    """`title` and `menu` say where it stands in the menus, `keys` are texts of chords, `help` is one line.

    `run` does it. A `held` action is done once a picture for as long as its key is down. `checked` tells whether what
    it switches is on, `enabled` whether it can be done now; whose keys are pressed all the same is told why not.
    """

    name: str
    title: str
    menu: str
    keys: tuple[str, ...]
    help: str
    run: Callable[[Workspace], object]
    held: bool = False
    checked: Callable[[Workspace], bool] | None = None
    enabled: Callable[[Workspace], bool] = _always
