"""All rules by name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sandbox.errors import ArgumentError
from sandbox.lint.rule import Rule
from sandbox.lint.rules import (
    blind_sensor,
    falls_away,
    far_anchor,
    idle_motor,
    idle_rule,
    left_off,
    mass_ratio,
    never_fails,
    no_expect,
    out_of_view,
    overlap,
    pixels,
    radians,
    runaway_speed,
    static_wheel,
    stuck_joint,
    twice_placed,
    unused,
    upside_down,
)
from sandbox.scene.near_names import did_you_mean

_MODULES = (
    overlap, falls_away, runaway_speed, far_anchor, twice_placed, stuck_joint, static_wheel, idle_motor, left_off,
    mass_ratio, blind_sensor, idle_rule, pixels, radians, upside_down, out_of_view, no_expect, never_fails, unused,
)  # fmt: skip
RULES: Mapping[str, Rule] = {module.RULE.name: module.RULE for module in _MODULES}
"""In the order in which they are listed."""


def chosen(select: Iterable[str] = (), ignore: Iterable[str] = ()) -> tuple[Rule, ...]:
    """The selected rules (all, if none is) without the ignored ones. Raises `ArgumentError` for a name of none."""
    wanted, unwanted = list(select), set(ignore)
    for name in [*wanted, *unwanted]:
        if name not in RULES:
            raise ArgumentError(unknown_rule(name))
    return tuple(rule for name, rule in RULES.items() if name in (wanted or RULES) and name not in unwanted)


def unknown_rule(name: str) -> str:
    """What is said of a name that no rule has."""
    return f"there is no rule {name!r}; {did_you_mean(name, RULES) or 'there are ' + ', '.join(RULES)}"
