"""Rules: what is done when something happens."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from sandbox.scene.base import Model
from sandbox.scene.body_refs import Pair
from sandbox.scene.constraints import Range
from sandbox.scene.flat_body import INFINITE
from sandbox.scene.flat_rules import FlatCondition
from sandbox.scene.objects import known_as
from sandbox.scene.play.any_action import Actions
from sandbox.scene.play.triggers import AnyTrigger
from sandbox.scene.quantities import Name, Number, Seconds


class Condition(Model):
    """What has to be so, or the rule does nothing: a counter, or bodies that touch, or both."""

    counter: Name | None = Field(default=None, description="Which counter.")
    equals: Number | None = Field(default=None, description="It has this value.")
    least: Number | None = Field(default=None, description="It is at least this.")
    most: Number | None = Field(default=None, description="It is at most this.")
    touches: Pair | None = Field(default=None, description='["a", "b"], ids or patterns: these touch.')

    def flat(self) -> FlatCondition:
        """The closed range, and the pair."""
        low = self.least if self.equals is None else self.equals
        high = self.most if self.equals is None else self.equals
        return FlatCondition(
            self.counter or "", -INFINITE if low is None else low, INFINITE if high is None else high, self.touches
        )


@known_as("a rule")
class Rule(Model):
    """What is done when something happens."""

    id: Name | None = Field(default=None, description="A name that no other rule has, for events.")
    when: AnyTrigger = Field(description="What the rule waits for.")
    condition: Condition | None = Field(default=None, alias="if", description="Only if a counter is in a range.")
    do: Actions = Field(description="What is done then, in this order.")
    limit: Annotated[int, Range(1, 1_000_000_000)] | None = Field(
        default=None, description="So many times at most; default: any number."
    )
    cooldown: Seconds = Field(default=0.0, description="Not again for so long, s.")
