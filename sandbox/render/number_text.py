"""Numbers as people write them: whole ones without a point, others with six digits, or four where room is scarce."""

from __future__ import annotations


def plain(value: float) -> str:
    """`91`, `-2.54558`, `1.5e-07`; never `-0`."""
    if value == int(value) and abs(value) < 1e15:
        return str(int(value))
    return f"{value:.6g}"


def short(value: float) -> str:
    """`plain`, but four digits before and after the point together: `-0.3526`, `1338`."""
    if 1e3 <= abs(value) < 1e6:
        return plain(round(value))
    return plain(value) if abs(value) < 1e3 and value == int(value) else f"{value:.4g}"


def metres(value: float) -> str:
    """A length with its unit and four digits."""
    text = f"{value:.4g}"
    return f"{'0' if text == '-0' else text} m"


def point(value: tuple[float, float]) -> str:
    """`(7, 0)`."""
    return f"({plain(value[0])}, {plain(value[1])})"


def counted(count: int, one: str, many: str = "") -> str:
    """`1 box`, `2 boxes`; with an s if `many` is not said."""
    return f"{count:,} {one if count == 1 else many or one + 's'}"
