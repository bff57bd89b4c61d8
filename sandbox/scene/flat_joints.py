"""From the joints and chains of a scene to flat joints, and what shows only then to be wrong with them."""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from sandbox.scene.finding import Finding, quoted
from sandbox.scene.flat import INFINITE, FlatBody, FlatJoint, Vec
from sandbox.scene.generators import Chain
from sandbox.scene.known import NOTHING, Known

if TYPE_CHECKING:
    from sandbox.scene.joints import Joint

_COUPLED = ("revolute", "wheel", "prismatic")


def flat_joint(joint: Joint, number: int) -> FlatJoint:
    """A joint of the scene's list."""
    return replace(joint.flat(), pointer=f"/joints/{number}")


def chain_joints(chain: Chain, step: Vec, number: int) -> Iterator[FlatJoint]:
    """The hinges of a chain: `ID-joint-K` after body K; at the ends if they are pinned to the world."""
    first = 0 if chain.pin in ("start", "both") else 1
    last = chain.count if chain.pin in ("end", "both") else chain.count - 1
    for k in range(first, last + 1):
        anchor = (chain.at[0] + k * step[0], chain.at[1] + k * step[1])
        yield FlatJoint(
            id=f"{chain.id}-joint-{k}",
            kind="revolute",
            body_a=f"{chain.id}-{k}" if k > 0 else None,
            body_b=f"{chain.id}-{k + 1}" if k < chain.count else None,
            anchor_a=anchor,
            anchor_b=anchor,
            break_force=INFINITE if chain.break_force is None else chain.break_force,
            collide=chain.collide,
            pointer=f"/generate/{number}",
        )


def joint_faults(joints: Sequence[FlatJoint], bodies: Sequence[FlatBody], known: Known = NOTHING) -> Iterator[Finding]:
    """Mistakes of joints whose bodies and joints are all there, in the scene or among the `known`."""
    types = ChainMap({body.id: str(body.type) for body in bodies}, known.types)  # type: ignore[arg-type]
    kinds = ChainMap({joint.id: str(joint.kind) for joint in joints}, known.kinds)  # type: ignore[arg-type]
    for joint in joints:
        path = tuple(int(part) if part.isdigit() else part for part in joint.pointer.split("/")[1:])
        if joint.joints is not None:
            for k, name in enumerate(joint.joints):
                if kinds[name] not in _COUPLED:
                    text = f"a gear cannot couple {quoted(name)}, which is a {kinds[name]} joint"
                    yield Finding((*path, "joints", k), text, "it couples revolute, wheel and prismatic joints")
        elif "dynamic" not in (types.get(joint.body_a or ""), types.get(joint.body_b or "")):
            yield Finding(path, f"the joint {quoted(joint.id)} joins nothing that can move", "one body must be dynamic")
