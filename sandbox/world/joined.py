"""Who is joined to whom: for commands that wake a body with all that hangs on it, without a look at all joints."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sandbox.tables import Integers, Records, plain

_FEW = 64
"""Joints that have come since are looked through, unless they are more than so many and than a fourth of all."""


@dataclass(frozen=True)
class Joined:
    """The bodies on both sides of the first joints of a table, which were so many, sorted by body: of each the `others`
    and the `rows` of the joints.

    Joints keep their bodies until rows go; broken ones and those that are switched off have theirs as well.
    """

    joints: int
    bodies: Integers
    others: Integers
    rows: Integers

    @classmethod
    def of(cls, joints: Records) -> Joined:
        """Those of all joints that there are."""
        a, b = (plain(joints)[name] for name in ("body_a", "body_b"))
        bodies, others = np.concatenate([a, b]), np.concatenate([b, a])
        order = bodies.argsort(kind="stable")
        return cls(len(joints), bodies[order], others[order], order % max(len(joints), 1))

    def holds(self, joints: Records) -> bool:
        """Whether few joints have come since."""
        return len(joints) - self.joints <= max(_FEW, len(joints) // 4)

    def others_of(self, rows: Integers, joints: Records) -> Integers:
        """The bodies that joints hold to some; -1 where it is the world."""
        first, end = (np.searchsorted(self.bodies, rows, side) for side in ("left", "right"))
        found = [self.others[start:stop] for start, stop in zip(first.tolist(), end.tolist(), strict=True)]
        fresh = plain(joints)[self.joints :]
        for one, two in (("body_a", "body_b"), ("body_b", "body_a")):
            found.append(fresh[two][np.isin(fresh[one], rows)])
        return np.concatenate(found)

    def before(self, first_body: int, first_joint: int) -> Joined:
        """Bodies from the first one on have other rows, and so have joints: what is known of those before."""
        later = self.rows[np.searchsorted(self.bodies, first_body) :]
        joints = min(self.joints, first_joint, int(later.min(initial=self.joints)))
        if joints == self.joints:
            return self
        left = self.rows < joints
        return Joined(joints, self.bodies[left], self.others[left], self.rows[left])
