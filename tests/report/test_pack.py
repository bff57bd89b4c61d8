"""Packed poses come back within half a quantum."""

from __future__ import annotations

import base64
import zlib

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sandbox.report.pack import LARGEST, pack
from sandbox.report.toggles import toggles


def unpack_slowly(text: str, first: np.ndarray, quanta: np.ndarray, samples: int) -> np.ndarray:
    """As the format is described, number by number."""
    data = zlib.decompress(base64.b64decode(text))
    count = len(first)
    poses = np.zeros((count, samples, 3))
    for column in range(3):
        for body in range(count):
            speed = place = 0
            for k in range(samples):
                at = column * 4 * count * samples + body * samples + k
                code = sum(data[at + plane * count * samples] << 8 * plane for plane in range(4))
                speed = wrapped(speed + (-(code + 1) // 2 if code % 2 else code // 2))
                place = wrapped(place + speed)
                poses[body, k, column] = first[body, column] + place * quanta[body, column]
    return poses


def wrapped(value: int) -> int:
    return (value + 2**31) % 2**32 - 2**31


@given(st.integers(1, 4), st.integers(1, 9), st.integers(0, 2**32 - 1), st.sampled_from([0.01, 1.0, 1e6]))
def test_what_is_packed_comes_back(bodies: int, samples: int, seed: int, way: float) -> None:
    rng = np.random.default_rng(seed)
    poses = rng.normal(0.0, way, (bodies, samples, 3))
    quanta = np.full((bodies, 3), way * 10.0 ** -rng.integers(1, 6))
    back = unpack_slowly(pack(poses, quanta), poses[:, 0], quanta, samples)
    assert np.abs(back - poses).max() <= 0.5001 * quanta[0, 0]


def test_what_is_too_far_away_is_put_at_the_edge() -> None:
    poses = np.zeros((1, 3, 3))
    poses[0, :, 0] = 0.0, 1e15, -1e15
    back = unpack_slowly(pack(poses, np.ones((1, 3))), poses[:, 0], np.ones((1, 3)), 3)
    assert back[0, :, 0].tolist() == [0.0, LARGEST, -LARGEST]


@given(st.integers(0, 12).flatmap(lambda n: st.lists(st.lists(st.booleans(), min_size=n, max_size=n), max_size=4)))
def test_toggles_tell_when_it_is_on(switches: list[list[bool]]) -> None:
    count = len(switches[0]) if switches else 0
    changes = toggles(np.array(switches, bool).reshape(len(switches), count))
    assert [[sum(change <= k for change in row) % 2 == 1 for k in range(count)] for row in changes] == switches
