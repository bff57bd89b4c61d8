"""What all expectations have: a time."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from sandbox.scene.base import Model
from sandbox.scene.constraints import Exactly
from sandbox.scene.quantities import Step, Steps


class Expectation(Model):
    """What all expectations have: exactly one of the three times. Step n is the state after n steps."""

    at: Step | None = Field(default=None, description="Holds at this step.")
    always: Annotated[Literal[True], Exactly(True)] | None = Field(
        default=None, description="true: holds at the start and after every step."
    )
    within: Steps | None = Field(default=None, description="[first, last]: holds at one of these steps at least.")

    @property
    def when(self) -> Literal["at", "always", "within"]:
        """Which of the three times this expectation has."""
        return "at" if self.at is not None else "within" if self.within is not None else "always"

    @property
    def last_step(self) -> int:
        """The last step named, 0 where none is."""
        return self.at or (self.within[1] if self.within else 0)
