"""The union of all actions."""

from __future__ import annotations

from typing import Annotated

from pydantic import Tag

from sandbox.scene.constraints import Listed
from sandbox.scene.limits import MAX_ACTIONS
from sandbox.scene.play.actions import (
    Action,
    Blast,
    BreakJoints,
    ChangeGravity,
    Count,
    DeleteBodies,
    Lose,
    MoveAt,
    PushOnce,
    PushStep,
    PutBodies,
    SpawnBody,
    Win,
)
from sandbox.scene.play.setting_actions import ChangeJoint, ChangeRegion, RunPath, SetBodySurface, SwitchThruster
from sandbox.scene.union import TAG, by_key

ACTIONS: dict[str, type[Action]] = {
    "delete": DeleteBodies,
    "spawn": SpawnBody,
    "impulse": PushOnce,
    "force": PushStep,
    "velocity": MoveAt,
    "put": PutBodies,
    "explode": Blast,
    "gravity": ChangeGravity,
    "surface": SetBodySurface,
    "thruster": SwitchThruster,
    "joint": ChangeJoint,
    "break_joint": BreakJoints,
    "region": ChangeRegion,
    "path": RunPath,
    "counter": Count,
    "win": Win,
    "lose": Lose,
}
"""Every kind of action by its key."""

AnyAction = Annotated[
    Annotated[DeleteBodies, Tag(TAG + "delete")]
    | Annotated[SpawnBody, Tag(TAG + "spawn")]
    | Annotated[PushOnce, Tag(TAG + "impulse")]
    | Annotated[PushStep, Tag(TAG + "force")]
    | Annotated[MoveAt, Tag(TAG + "velocity")]
    | Annotated[PutBodies, Tag(TAG + "put")]
    | Annotated[Blast, Tag(TAG + "explode")]
    | Annotated[ChangeGravity, Tag(TAG + "gravity")]
    | Annotated[SetBodySurface, Tag(TAG + "surface")]
    | Annotated[SwitchThruster, Tag(TAG + "thruster")]
    | Annotated[ChangeJoint, Tag(TAG + "joint")]
    | Annotated[BreakJoints, Tag(TAG + "break_joint")]
    | Annotated[ChangeRegion, Tag(TAG + "region")]
    | Annotated[RunPath, Tag(TAG + "path")]
    | Annotated[Count, Tag(TAG + "counter")]
    | Annotated[Win, Tag(TAG + "win")]
    | Annotated[Lose, Tag(TAG + "lose")],
    by_key("action", ACTIONS),
]
"""Any action; exactly one of the keys of `ACTIONS` tells which."""

Actions = Annotated[tuple[AnyAction, ...], Listed("of actions", 1, MAX_ACTIONS)]
