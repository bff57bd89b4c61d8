"""A whole scene simulated twice, by this engine and by somebody else, measured by the same code."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from sandbox.engine.world import World
from sandbox.reference.measures import Measurer, Measures
from sandbox.reference.others import TwinName, other_hands
from sandbox.scene import Scene
from sandbox.scene.flat import FlatScene

_REPORT_EVERY = 16


@dataclass(frozen=True)
class Twin:
    """Samples of both runs at the same `times` (s); `notes` say what of the scene the other one does otherwise.

    `name` is that of the other one on the command line, `label` the one for people.
    """

    times: tuple[float, ...]
    ours: tuple[Measures, ...]
    theirs: tuple[Measures, ...]
    notes: tuple[str, ...]
    name: TwinName = "pymunk"
    label: str = "pymunk"


def simulate_twin(
    scene: Scene | FlatScene,
    steps: int,
    every: int = 1,
    on_steps: Callable[[int], None] | None = None,
    name: TwinName = "pymunk",
) -> Twin:
    """Run `scene` for `steps` steps in both and measure it at the start, every `every` steps and at the end.

    Raises `SandboxError` for a scene that `name` cannot step.
    """
    flat = scene.flatten() if isinstance(scene, Scene) else scene
    world = World(flat)
    other = other_hands(name, flat, world.state.bodies)
    measurer, seconds = Measurer(world.state), 1.0 / flat.settings.step_rate
    times, ours, theirs = [], [], []
    for k in range(steps + 1):
        if k > 0:
            world.step()
            other.step()
        if k % every == 0 or k == steps:
            times.append(k * seconds)
            ours.append(measurer.measure(world.state.bodies))
            theirs.append(measurer.measure(other.records()))
        if on_steps is not None and k % _REPORT_EVERY == 0:
            on_steps(k)
    return Twin(tuple(times), tuple(ours), tuple(theirs), other.notes, name, other.label)
