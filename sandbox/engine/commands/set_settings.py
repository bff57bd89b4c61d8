"""The command that changes how the world is simulated: the `settings` of a scene file, but for its step rate."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

from sandbox.engine.active.wake import wake_all
from sandbox.engine.commands.base import Command, CommandTarget, Touched
from sandbox.engine.commands.checks import title
from sandbox.errors import CommandError, SceneError
from sandbox.world.state import State

_CONTACT = (
    "normal_impulse1", "tangent_impulse1", "rest_length1", "normal_impulse2", "tangent_impulse2", "rest_length2",
    "rolling_impulse",
)  # fmt: skip
_JOINT = tuple(f"impulse_{k}" for k in range(5))
_DRAG = ("impulse_x", "impulse_y")


@dataclass(frozen=True)
class SetSettings(Command):
    """Change how the world is simulated; what is None stays as it is. Wakes everything.

    Fields are those of `settings` in a scene file, with the same units and limits. Before the first step, the world is
    then as if its scene had said so.
    """

    substeps: int | None = None
    contact_hertz: float | None = None
    contact_damping_ratio: float | None = None
    push_out_speed: float | None = None
    restitution_threshold: float | None = None
    sleeping: bool | None = None
    warm_starting: bool | None = None
    accumulate: bool | None = None
    soft: bool | None = None
    relax: bool | None = None
    speculative: bool | None = None

    def apply(self, target: CommandTarget) -> Touched:
        """Write the settings and wake all sleepers."""
        given = {item.name: value for item in fields(self) if (value := getattr(self, item.name)) is not None}
        _check(self, given)
        setting = target.state.settings[0]
        before = int(setting.substeps)
        for name, value in given.items():
            setting[name] = value
        if setting.substeps != before:
            _share_impulses(target.state, before / int(setting.substeps))
        return Touched(bodies=wake_all(target.state))


def _check(command: SetSettings, given: dict[str, Any]) -> None:
    from sandbox.scene.settings import Settings

    try:
        Settings(**given)
    except SceneError as error:
        raise CommandError(f"{title(command)}: {error.problems[0].message}") from None


def _share_impulses(state: State, share: float) -> None:
    """Impulses are those of one substep: where it has another length, the same forces give a `share` of them."""
    contacts = state.contacts[: int(state.counters[0].contact_count)]
    for table, names in ((contacts, _CONTACT), (state.joints, _JOINT), (state.drags, _DRAG)):
        for name in names:
            table[name] *= share
