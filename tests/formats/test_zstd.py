"""Zstandard: what the reference program has packed, and damage to it."""

from __future__ import annotations

import base64

import pytest

from sandbox.formats.tiled.zstd import ZstdError, decompress

WORDS = ("tile", "map", "wall", "floor", "sky", "ladder", "stone", "door")
PACKED = base64.b64decode(
    "KLUv/QRoXRgAdnhgFaCnkg6ImBff337eZO+9Jf//H1ZVOGYAUwBWALV9dd2V7FRjd6gQSCGalCwJkjjPdjHta99xTtDNPWpSNwlyts8S9Qq0CR"
    "uHIJrhqtoqHM5myOHamSsem8X+y4PlzhStKCKGxaAMxAADEJAIDQoIHBwYTIGBgQcKRMCBgQIFCQAUCBuNWcsghf1V6DglyR+qSJFpqG1hK3U9"
    "0CrulHrYoR0yxzmk1DlN7KjKG15byqT1pr5K7jJUYWWX9KqFL+5G9ywEhTQibMdV0dmizOLHJcLIUhZCo1mCXHRaI1HUoHvW8998cSQIyezbCl"
    "MGWcaXvkhYIUhDqPi26Qkp+hVZ9YchN/GWODW3wSeCtL8MT64jhp3UUVxQLagurJkVwfqp8SQ6aB4mbBEzir0IQr0abmiju5EfHROZGVMSLuzm"
    "o+6tI+o9K9owROIZNlIWHiTDhlGMbWvDjlmiyNbJBnWzjWe6auNKFMeWUtCVEKYc1GsUZ3rkJm9jHU5t5VuWvPTKA4DGqNGKiEggEohEaUm0HB"
    "AQYoxidx6CWJwEI+AIEA8FNhoUsrH/Z/C8J4DopkJdDiVOH9xu+BuDg5Ik9lpCvo1K8IwfQHK9xWXGt9TXUFJkSGeTZqR48STwplGxkRN6tHT1"
    "18HbofGe9/P4pqalhk/54zHQuT7ofWNjOs+xoEx8quqRhOtfdihJCGp/7al5xoPWj1xPkKx+xIdExbk+M3aDeAXJWJbZBmyWhzD6k9HgodA/Ar"
    "05qMd7NRSQqpFoK4K/2hb/WihHLkn7Io2i75k41Iio/LMnHgbBA459xpidQSJy747/rm4//dnBXgmq4+uAE1qXmfGXs2dVtrk/7uYR15E/aRy/"
    "COEREw+0zs7QuA1qhQgey4q+f1jNnCOtvXgZ8t7D+bQDfcJ/FdnB5Mj2QjXP0Xs586DH7VzqKBVC8cHegf/xEood3Wj7+Ezs+O2hL2WXRtNw9P"
    "swcnuGH+Rkp4FnKka8Kf/yXL+PBhpw2J+g9XXdqiQ939TLnni/kQdb81IxLgqy07uM"
)
"""`plain()`, packed with level 19: words, noise in four streams of literals, and a run."""


def drawn(state: int, count: int) -> list[int]:
    found = []
    for _ in range(count):
        state = (state * 1103515245 + 12345) & 0x7FFFFFFF
        found.append(state >> 16 & 15)
    return found


def plain() -> bytes:
    words = " ".join(WORDS[k & 7] for k in drawn(7, 300))
    noise = "".join("aaaaabbbccdefghi"[k] for k in drawn(1, 1100))
    return (words + noise + "x" * 500).encode()


def test_it_is_what_was_packed() -> None:
    assert decompress(PACKED, 10_000) == plain()
    assert decompress(b"\x50\x2a\x4d\x18\x03\0\0\0abc" + PACKED, 10_000) == plain()


def test_it_ends_with_what_was_asked_for() -> None:
    blocks = bytes.fromhex("02000c 61") * 40  # 98,304 letters each
    assert decompress(bytes.fromhex("28b52ffd 8068") + bytes.fromhex("00003c00") + blocks, 1000) == b"a" * 1000
    with pytest.raises(ZstdError, match="memory"):
        decompress(bytes.fromhex("28b52ffd a4 00000010") + blocks, 1000)  # says that it is 256 MB in one piece


@pytest.mark.parametrize("data", [PACKED[:-9], PACKED[:40], PACKED[:6], b"PK" + PACKED])
def test_what_is_cut_is_told(data: bytes) -> None:
    with pytest.raises(ZstdError):
        decompress(data, 10_000)


def test_damage_is_told_or_other_bytes() -> None:
    for at in range(4, len(PACKED), 9):
        for value in (0, 0x5A, 0xFF):
            try:
                decompress(PACKED[:at] + bytes([value]) + PACKED[at + 1 :], 10_000)
            except ZstdError:
                continue
