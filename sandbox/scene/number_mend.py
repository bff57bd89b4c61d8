"""What to do about a text where a number is due."""

from __future__ import annotations

import re

_NUMBER = re.compile(r"\s*[+-]?[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?\s*(?P<unit>[^\W\d][^=]*)?")


def number_mend(text: str) -> str:
    """The mend for `text`: a number in quotes, one with a unit, or what was meant as an expression."""
    number = _NUMBER.fullmatch(text)
    if number is None:
        return 'an expression begins with "=", as in "=9.81 / 6"'
    return "a number stands without its unit and quotes" if number["unit"] else "take the quotes away"
