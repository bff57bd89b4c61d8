"""The nearest of many names, as far as the effort for one file goes."""

from __future__ import annotations

import difflib
import re
from collections.abc import Collection, Iterable
from itertools import islice

from sandbox.scene.effort import Effort, effort
from sandbox.scene.limits import MAX_NAME

_WORDS = re.compile(r"[^-._:]+")
_FEW = 8
"""So many names are listed where none is meant."""
_CONSIDERED = 2000
"""So many names are looked at for one that is wrong."""


def nearest(name: str, known: Iterable[str], left: Effort | None = None) -> str | None:
    """The one of the `known` names that is most like `name`, if any is; None where `name` itself is among them.

    In Python, a key may be anything.
    That is an effort, for which there is what is `left`, by default of the file at hand.
    """
    wanted, left = str(name).casefold(), left or effort()
    if len(wanted) > MAX_NAME or left.compared <= 0:
        return None
    by_folded = {other.casefold(): other for other in islice(known, _CONSIDERED) if len(other) <= MAX_NAME}
    if by_folded.get(wanted) == name:
        return None
    if wanted in by_folded:
        return by_folded[wanted]
    left.compared -= (len(wanted) + 1) * sum(len(other) + 1 for other in by_folded)
    near = difflib.get_close_matches(wanted, by_folded, n=1, cutoff=0.6)
    return by_folded[near[0]] if near else None


def is_misspelling(name: str, near: str | None) -> bool:
    """Whether a name that is near one is meant by it, word by word: `crat` and `crate`, not `ball-1` and `ball-2`."""
    words, meant = _WORDS.findall(name.casefold()), _WORDS.findall((near or "").casefold())
    pairs = zip(words, meant, strict=False)
    return len(words) == len(meant) and all(difflib.get_close_matches(a, [b], cutoff=0.7) for a, b in pairs)


def near_pattern(name: str, known: Iterable[str]) -> str:
    """The hint with a pattern like `name`, a beginning and a star, that means some of the `known` names."""
    head, star, rest = name.partition("*")
    if not star or rest or head[-1:] not in ("-", "."):
        return ""
    texts, end = islice(known, _CONSIDERED), head[-1]
    near = nearest(head, {text[: k + 1]: None for text in texts for k, letter in enumerate(text) if letter == end})
    return f'did you mean "{near}*"?' if near else ""


def near_or_all(name: str, known: Collection[str]) -> str:
    """The hint with the nearest of the `known` names; where none is near, and these are few, with all of them."""
    listed = ", ".join(f'"{other}"' for other in islice(known, _FEW))
    there = f"there {'is' if len(known) == 1 else 'are'} {listed}" if 1 <= len(known) <= _FEW else ""
    return did_you_mean(name, known) or there


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """The hint with the nearest of the `known` names, empty if none is near."""
    near = nearest(name, known)
    return f'did you mean "{near}"?' if near else ""
