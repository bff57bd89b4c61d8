"""JSON as a person would lay it out: what fits on a line stays on one line, whole numbers have no point."""

from __future__ import annotations

import json
import math
from typing import Any

from sandbox.scene.layout import laid_out
from sandbox.scene.shapes import SHAPES

_WIDTH = 100
_EXACT = 2.0**53


def pretty(value: Any) -> str:
    """JSON text of plain data without NaN and infinities."""
    return _lines(_plain(value), 0, 0)


def scene_text(data: dict[str, Any]) -> str:
    """The text of a scene's file: `$schema` and `format` come first, and it is laid out as `sandbox fmt` does."""
    head = {"$schema": data["$schema"]} if "$schema" in data else {}
    whole = {**head, "format": 1, **data}
    return laid_out(json.dumps(_plain(kinds_first(whole)), ensure_ascii=False, allow_nan=False))


def kinds_first(value: Any) -> Any:
    """The same data with the key that tells a shape's kind before its other fields."""
    if isinstance(value, list):
        return [kinds_first(entry) for entry in value]
    if not isinstance(value, dict):
        return value
    first = {key: value[key] for key in SHAPES if key in value}
    return {key: kinds_first(entry) for key, entry in {**first, **value}.items()}


def _plain(value: Any) -> Any:
    """The same data with whole floats as whole numbers; they read back as equal floats."""
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [_plain(entry) for entry in value]
    whole = isinstance(value, float) and value.is_integer() and abs(value) < _EXACT
    negative_zero = value == 0 and isinstance(value, float) and math.copysign(1.0, value) < 0
    return int(value) if whole and not negative_zero else value


def _lines(value: Any, indent: int, used: int) -> str:
    """`used` is what already stands on the first line."""
    flat = json.dumps(value, ensure_ascii=False, allow_nan=False)
    if not isinstance(value, (dict, list)) or not value or (indent and len(flat) + used <= _WIDTH):
        return flat
    inner, outer = "\n" + "  " * (indent + 1), "\n" + "  " * indent
    if isinstance(value, list):
        parts = [_lines(entry, indent + 1, 2 * indent + 3) for entry in value]
        return f"[{inner}{f',{inner}'.join(parts)}{outer}]"
    keys = [json.dumps(key, ensure_ascii=False) + ": " for key in value]
    pairs = zip(keys, value.values(), strict=True)
    parts = [key + _lines(entry, indent + 1, 2 * indent + 3 + len(key)) for key, entry in pairs]
    return f"{{{inner}{f',{inner}'.join(parts)}{outer}}}"
