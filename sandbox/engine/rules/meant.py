"""Who and what place the words of an action mean, in the world of now."""

from __future__ import annotations

from collections.abc import Iterator

from sandbox.engine.commands.base import Vec
from sandbox.engine.rules.base import RuledWorld
from sandbox.engine.rules.occasions import Occasion
from sandbox.engine.rules.selectors import Selector
from sandbox.scene.flat_rules import FIRST, POINTER, SECOND, Names
from sandbox.tables import plain


class Meant:
    """Looks up the ids, patterns and places of actions; patterns once, until somebody comes or goes."""

    def __init__(self, world: RuledWorld) -> None:
        self._world = world
        self._selectors: dict[Names, Selector] = {}
        self._found: dict[Selector, list[str]] = {}
        self._layout = -1
        """That of the state for which `_found` holds."""

    def bodies(self, names: Names, occasion: Occasion) -> list[str]:
        """The ids that are meant and there, each once."""
        found: dict[str, None] = {}
        for name in names:
            found.update(dict.fromkeys(self._named(name, occasion)))
        return [name for name in found if self._world.directory.has_body(name)]

    def joints(self, names: Names) -> list[str]:
        """The ids of joints."""
        return self._selector(names).among([name for name in self._world.state.census.joints.names if name])

    def regions(self, names: Names) -> list[str]:
        """The ids of regions."""
        return self._selector(names).among([name for name in self._world.state.census.regions.names if name])

    def place(self, place: Vec | str, occasion: Occasion) -> Vec | None:
        """A place in the world; None if nobody is there any more."""
        if not isinstance(place, str):
            return place
        if place == POINTER:
            return occasion.pointer
        for name in self.bodies((place,), occasion):
            body = plain(self._world.state.bodies)[self._world.directory.body(name)]
            return float(body["position_x"]), float(body["position_y"])
        return None

    def _named(self, name: str, occasion: Occasion) -> Iterator[str]:
        if name in (FIRST, SECOND):
            body = occasion.first if name == FIRST else occasion.second
            yield from () if body is None else (body,)
            return
        selector = self._selector((name,))
        yield from self._matching(selector) if selector.is_several else (name,)

    def _matching(self, selector: Selector) -> list[str]:
        """The ids of the bodies that are there and meant by a pattern; looked for anew when some came or went."""
        state = self._world.state
        if self._layout != state.layout:
            self._layout, self._found = state.layout, {}
        if selector not in self._found:
            self._found[selector] = selector.among(state.census.bodies.names)
        return self._found[selector]

    def _selector(self, names: Names) -> Selector:
        if names not in self._selectors:
            self._selectors[names] = Selector(names)
        return self._selectors[names]
