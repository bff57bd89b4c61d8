"""What the engine's own narrow phase says of pairs of shapes where they lie."""

from __future__ import annotations

import numpy as np

from sandbox._jit import entry_point, kernel_argument
from sandbox.geometry.core import core_of
from sandbox.geometry.manifold import MANIFOLD, collide_cores
from sandbox.reference.poses import Poses
from sandbox.tables import Floats, Integers, Records

_FAR = 1e200


@entry_point
def _decide_all(
    bodies: Records, shapes: Records, cores: Records, pairs: Integers, manifold: Records, answers: Floats
) -> None:
    """Write separation and normal of every pair to `answers` (n, 3)."""
    for k in range(pairs.shape[0]):
        a = shapes[pairs[k, 0]]
        b = shapes[pairs[k, 1]]
        collide_cores(
            cores,
            core_of(a),
            core_of(b),
            bodies[b.body].center_x - bodies[a.body].center_x,
            bodies[b.body].center_y - bodies[a.body].center_y,
            _FAR,
            0.0,
            manifold,
        )
        answers[k, 0] = manifold[0].separation
        answers[k, 1] = manifold[0].normal_x
        answers[k, 2] = manifold[0].normal_y


def decide(poses: Poses, pairs: Integers) -> tuple[Floats, Floats]:
    """(separation, m, negative is the depth; unit normals (n, 2) from a to b) of `pairs` (n, 2) of shapes.

    The kernel is the step's own, asked without a margin and without its preference for the faces of a. Of sharp
    shapes that are apart, the separation is that of their best axis.
    """
    answers = np.zeros((len(pairs), 3))
    bodies, shapes, cores = (kernel_argument(table) for table in (poses.bodies, poses.shapes, poses.cores))
    asked, manifold = np.ascontiguousarray(pairs), kernel_argument(MANIFOLD.zeros(1))
    _decide_all(bodies, shapes, cores, asked, manifold, answers)
    return answers[:, 0].copy(), answers[:, 1:].copy()
