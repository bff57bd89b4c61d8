"""Poses in few bytes: rounded to what can be seen, second differences in time, byte planes, deflate, base64.

Second differences are zero at rest and constant in free flight. Their high bytes are nearly all zero, and lie side by
side in planes, which deflate likes. A browser undoes it with `DecompressionStream` and two running sums.
"""

from __future__ import annotations

import base64
import zlib

import numpy as np

from sandbox.tables import Floats

LARGEST = 2.0**29
"""Quanta from its first place that a body can be away; farther ones are drawn there."""


def pack(poses: Floats, quanta: Floats) -> str:
    """Base64 text of `poses` (bodies, samples, 3), each body's columns in units of its own `quanta` (bodies, 3).

    The text holds, column by column, four planes of bytes (lowest first) of whole numbers, body by body.
    """
    first = poses[:, :1, :]
    whole = np.clip(np.rint((poses - first) / quanta[:, None, :]), -LARGEST, LARGEST).astype(np.int64)
    bent = np.diff(whole, n=2, axis=1, prepend=np.zeros((len(poses), 2, 3), np.int64)).astype(np.int32)
    folded = ((bent << 1) ^ (bent >> 31)).view(np.uint32)  # small ones of either sign have small codes
    planes = folded.transpose(2, 0, 1).astype("<u4").reshape(3, -1, 1).view(np.uint8).transpose(0, 2, 1)
    return base64.b64encode(zlib.compress(planes.tobytes(), 9)).decode("ascii")
