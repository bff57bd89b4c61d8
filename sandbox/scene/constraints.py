"""Annotations that hold a value to its limits and say so in plain words."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema


def describe(value: object) -> str:
    """A value's kind in the words of a scene file."""
    names = {bool: "true or false", str: "text", int: "a number", float: "a number", type(None): "null"}
    if isinstance(value, (list, tuple)):
        return "a list"
    return names.get(type(value), "an object" if isinstance(value, dict) else "something else")


@dataclass(frozen=True)
class Range:
    """Annotates a number: the closed range it must lie in, and its unit.

    With `least`, a number that is not 0 must be at least that: tiny ones are the ruin of floating point.
    """

    low: float
    high: float
    unit: str = ""
    least: float = 0.0

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_after_validator_function(self._check, handler(source))

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return {**handler(schema), "minimum": self.low, "maximum": self.high}

    def _check(self, value: float) -> float:
        unit = f" {self.unit}" if self.unit else ""
        if 0 < value < self.least:
            raise PydanticCustomError("limit", f"must be 0 or at least {self.least:g}{unit}")
        if self.low <= value <= self.high:
            return value
        if value < self.low:
            limit = "negative" if self.low == 0 else f"below {self.low:g}{unit}"
        else:
            limit = f"above {self.high:g}{unit}"
        raise PydanticCustomError("limit", f"must not be {limit}")


@dataclass(frozen=True)
class Exactly:
    """Annotates a literal: the one value it can have. (Python takes 1, 1.0 and true for the same literal.)"""

    value: bool | int

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_before_validator_function(self._check, handler(source))

    def _check(self, value: object) -> object:
        if type(value) is type(self.value) and value == self.value:
            return value
        raise PydanticCustomError("exactly", f"must be {str(self.value).lower()}")


@dataclass(frozen=True)
class Listed:
    """Annotates a tuple: takes a JSON list or any Python sequence. `form` shows the author how it looks."""

    form: str
    low: int
    high: int

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        inner = handler(source)
        inner["strict"] = False  # type: ignore[index]
        return core_schema.no_info_before_validator_function(self._check, inner)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        found = dict(handler(schema))
        items = found.get("items") or found["prefixItems"][0]
        return {"type": "array", "items": items, "minItems": self.low, "maxItems": self.high}

    def _check(self, value: Any) -> Any:
        value = value.tolist() if hasattr(value, "tolist") else value
        if not isinstance(value, (list, tuple)):
            raise PydanticCustomError("listed", f"must be a list {self.form}, not {describe(value)}")
        if self.low <= len(value) <= self.high:
            return value
        if self.low == self.high:
            text = f"needs {self.low} entries, {self.form}, and has {len(value)}"
        elif len(value) < self.low:
            text = f"needs at least {self.low} {'entry' if self.low == 1 else 'entries'} and has {len(value)}"
        else:
            text = f"has {len(value)} entries; {self.high} is the limit"
        raise PydanticCustomError("listed", text)
