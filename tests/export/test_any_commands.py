"""Whatever commands have done to a world, it can be written down, and read again as it was."""

from __future__ import annotations

from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

from hypothesis import given
from hypothesis import strategies as st

from sandbox import CapacityError, Spawn, World, copy_of
from sandbox.errors import SandboxError
from sandbox.replay.recording.command_words import decode
from tests.examples import examples
from tests.export.worlds import difference, saved
from tests.fuzz import commands
from tests.shipped import shipped

_LOSSES = ("limit of scene files", "froze")
"""Remarks that say that a body is not as it was."""


def disturbed(seed: int) -> World | None:
    """A shipped scene to which random commands were given, some of them damaged; None if it is too crowded."""
    case = commands.make(Random(seed))
    world = World(shipped(case["scene"]))
    try:
        for what in case["todo"]:
            if isinstance(what, int):
                world.step(what)
                continue
            found, _ = decode([0, *what[:2]], ("commands", 0))
            try:
                if found is not None:
                    world.apply(found[1])
            except SandboxError:
                continue
    except CapacityError:
        return None
    return world


@given(st.integers(0, 100_000))
@examples(60)
def test_it_can_be_written_down(seed: int) -> None:
    world = disturbed(seed)
    if world is None:
        return
    with TemporaryDirectory() as folder:
        found, other = saved(world, Path(folder))
    if not any(loss in line for loss in _LOSSES for line in found.remarks):
        assert difference(world, other) < 1e-9
    near = [name for name in world.names if abs(world.body(name).position[0]) < 1e6]
    before = len(world.names)
    world.apply(Spawn(*copy_of(world, near, (50.0, 0.0))))
    assert len(world.names) == before + len(near)
