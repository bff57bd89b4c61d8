"""How heavy jointed parts are on the bodies at which they stand: a car on its wheels, a table on its legs.

Joints carry the weight of a part to whatever of it lies on something. All its contacts there count as if they bore
alike: what each of them bears changes from step to step, and substeps that changed with it would shake the part.
"""

from __future__ import annotations

from sandbox._jit import kernel
from sandbox.engine.bodies.flags import is_active
from sandbox.engine.joints.records import JointWork
from sandbox.tables import Records

_NONE = 1e300
"""The smallest of none."""


@kernel
def begin_parts(joints: JointWork) -> None:
    """Nobody is known to be in a part, and none stands anywhere."""
    for p in range(joints.parts.shape[0]):
        part = joints.parts[p]
        part.mass = 0.0
        part.stands_on = 0
        part.bearer = part.slight = _NONE


@kernel
def add_member(joints: JointWork, index: int, mass: float, root: int) -> None:
    """Body number `index`, of an island with that root, is in a part with so much mass (kg)."""
    p = joints.part_of[index]
    if p >= 0:
        joints.parts[p].mass += mass
        joints.parts[p].root = root


@kernel
def add_stand(joints: JointWork, above: int, upper: Records, lower: Records) -> None:
    """Note that body number `above`, `upper`, lies on `lower`. Of a part that nothing else holds, the lighter of both
    has to bear it, if both move."""
    p = joints.part_of[above]
    if p < 0 or joints.parts[p].anchored == 1:
        return
    part = joints.parts[p]
    lighter = lower if is_active(lower) and lower.mass < upper.mass else upper
    part.stands_on += 1
    part.bearer = lighter.mass if lighter.mass < part.bearer else part.bearer
    part.slight = lighter.extent if lighter.extent < part.slight else part.slight


@kernel
def add_part_weights(joints: JointWork, piles: Records) -> None:
    """Add to the largest ratios of piles those of the parts that stand in them."""
    for p in range(joints.parts.shape[0]):
        part = joints.parts[p]
        if part.stands_on > 0:
            pile = piles[part.root]
            ratio = part.mass / (part.stands_on * part.bearer)
            pile.ratio = ratio if ratio > pile.ratio else pile.ratio
            pile.slight = part.slight if part.slight < pile.slight else pile.slight
