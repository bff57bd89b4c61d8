"""Controls: what a player presses, and what it does."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from sandbox.scene.base import Model
from sandbox.scene.constraints import Listed
from sandbox.scene.limits import MAX_ACTIONS
from sandbox.scene.near_names import did_you_mean
from sandbox.scene.objects import known_as
from sandbox.scene.play.any_action import AnyAction
from sandbox.scene.quantities import Name

KEYS = (
    *"abcdefghijklmnopqrstuvwxyz0123456789",
    "left", "right", "up", "down", "space", "enter", "tab", "backspace", "left shift", "right shift",
    "left ctrl", "right ctrl", "left alt", "right alt",
    ".", ",", "-", "=", "/", ";", "'", "[", "]",
)  # fmt: skip
"""Names of keys: what stands on them in an American layout."""
PadInput = Literal[
    "a", "b", "x", "y", "left bumper", "right bumper", "back", "start", "up", "down", "left", "right",
    "left stick x", "left stick y", "right stick x", "right stick y", "left trigger", "right trigger",
]  # fmt: skip
MouseInput = Literal["left", "middle", "right", "move"]
PAD_INPUTS: tuple[str, ...] = get_args(PadInput)
MOUSE_INPUTS: tuple[str, ...] = get_args(MouseInput)
_MOST = 8


def _check_key(name: str) -> str:
    if name not in KEYS:
        near = did_you_mean(name, KEYS)
        text = "is no key; keys are letters, digits, and names such as left, space, enter, left shift"
        raise PydanticCustomError("key", f"{text}: {near}" if near else text)
    return name


Key = Annotated[str, AfterValidator(_check_key)]
Keys = Annotated[tuple[Key, ...], Listed('["left", "a"]', 0, _MOST)]
_Actions = Annotated[tuple[AnyAction, ...], Listed("of actions", 0, MAX_ACTIONS)]


@known_as("a control")
class InputControl(Model):
    """What a player presses and holds. Its value is 0 to 1, or -1 to 1 with `minus` or a stick."""

    id: Name = Field(description="A name that no other control has.")
    title: str = Field(default="", description="What it does, for the player.")
    keys: Keys = Field(default=(), description="Keys that hold it.")
    minus: Keys = Field(default=(), description="Keys that hold it the other way: with the value -1.")
    pad: Annotated[tuple[PadInput, ...], Listed('["a", "left stick x"]', 0, _MOST)] = Field(
        default=(), description="Buttons, sticks and triggers of a gamepad."
    )
    mouse: Annotated[tuple[MouseInput, ...], Listed('["left"]', 0, _MOST)] = Field(
        default=(), description='Buttons of the mouse; "move": the pointer is told while it moves.'
    )
    press: _Actions = Field(default=(), description="Done once when it is pressed.")
    hold: _Actions = Field(default=(), description="Done before every step while it is held, times its value.")
    release: _Actions = Field(default=(), description="Done once when it is let go.")
