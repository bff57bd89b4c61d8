"""What hangs together: the connected components of a graph, many edges at once.

Each root hooks onto the least root beside it, then every node onto its root: Y. Shiloach, U. Vishkin, "An O(log n)
Parallel Connectivity Algorithm", 1982. The answer does not depend on the order of the edges.
"""

from __future__ import annotations

import numpy as np

from sandbox.tables import Integers


def components(count: int, ones: Integers, twos: Integers) -> Integers:
    """The lowest node that hangs together with each of `count` nodes, by the edges from `ones` to `twos`."""
    root = np.arange(count)
    while True:
        one, two = root[ones], root[twos]
        apart = one != two
        if not apart.any():
            return root
        np.minimum.at(root, np.maximum(one, two)[apart], np.minimum(one, two)[apart])
        above = root[root]
        while (above != root).any():
            root, above = above, above[above]
