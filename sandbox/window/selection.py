"""What the user has picked: bodies, by id, a joint or a region; and the pair of bodies whose test is looked at."""

from __future__ import annotations

from dataclasses import dataclass

from sandbox.engine.world import World


@dataclass
class Selection:
    """Ids, so that they mean the same after undo and when rows have moved."""

    bodies: tuple[str, ...] = ()
    joint: str | None = None
    region: str | None = None
    pair: tuple[str, str] | None = None
    figure: tuple[str, int | None] | None = None
    """What of the pair's test is to be shown next: a figure of `sandbox sat`, and an axis. The inspector takes it."""

    def pick(self, name: str | None, more: bool = False) -> None:
        """Select a body alone, or with `more` add it to those selected, or take it out if it is one."""
        if name is None:
            self.bodies = self.bodies if more else ()
        elif not more:
            self.bodies = (name,)
        elif name in self.bodies:
            self.bodies = tuple(one for one in self.bodies if one != name)
        else:
            self.bodies = (*self.bodies, name)
        self.joint = self.region = None
        if len(self.bodies) == 2:
            self.pair = self.bodies[0], self.bodies[1]

    def pick_all(self, names: tuple[str, ...]) -> None:
        """Select these bodies, and nothing else."""
        self.bodies, self.joint, self.region = names, None, None

    def pick_joint(self, name: str) -> None:
        """Select a joint alone."""
        self.bodies, self.joint, self.region = (), name, None

    def pick_region(self, name: str | None) -> None:
        """Select a region alone; None selects nothing."""
        self.bodies, self.joint, self.region = (), None, name

    @property
    def region_title(self) -> str:
        """The region for people: "pond", or "region #2" if it has no id."""
        name = self.region or ""
        return f"region {name}" if name.startswith("#") else name

    def clear(self) -> bool:
        """Select nothing; False if nothing was."""
        some = bool(self.bodies or self.joint or self.region)
        self.pick(None)
        return some

    def present(self, world: World) -> tuple[str, ...]:
        """Those bodies of it that there are now, in the order in which they were selected."""
        names = set(world.names)
        return tuple(name for name in self.bodies if name in names)
