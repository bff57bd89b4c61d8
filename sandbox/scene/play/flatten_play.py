"""From the models of controls and rules to plain values."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sandbox.scene.finding import Path
from sandbox.scene.flat_rules import FlatAction, FlatControl, FlatRule
from sandbox.scene.plain import OCCASIONS
from sandbox.scene.play.actions import Action
from sandbox.scene.play.control import InputControl
from sandbox.scene.play.rule import Rule

Flatten = Callable[[Action, Path], FlatAction]


def flat_controls(controls: Sequence[InputControl], flatten: Flatten) -> tuple[FlatControl, ...]:
    """The controls of a scene; `flatten` takes an action and its path in the file."""
    return tuple(_control(control, ("controls", k), flatten) for k, control in enumerate(controls))


def _control(control: InputControl, path: Path, flatten: Flatten) -> FlatControl:
    press, hold, release = (_actions(getattr(control, name), (*path, name), flatten) for name in OCCASIONS)
    inputs = control.keys, control.minus, control.pad, control.mouse
    return FlatControl(control.id, control.title, *inputs, press, hold, release)


def flat_rules(rules: Sequence[Rule], flatten: Flatten) -> tuple[FlatRule, ...]:
    """The rules of a scene."""
    return tuple(_rule(rule, ("rules", k), flatten) for k, rule in enumerate(rules))


def _rule(rule: Rule, path: Path, flatten: Flatten) -> FlatRule:
    do = _actions(rule.do, (*path, "do"), flatten)
    condition = None if rule.condition is None else rule.condition.flat()
    return FlatRule(rule.when.flat(), do, rule.id or "", condition, rule.limit, rule.cooldown)


def _actions(actions: Sequence[Action], path: Path, flatten: Flatten) -> tuple[FlatAction, ...]:
    return tuple(flatten(action, (*path, k)) for k, action in enumerate(actions))
