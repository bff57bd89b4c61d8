"""Outlines that an author draws with a path in the syntax of SVG instead of listing their points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from sandbox.scene.svg_path import PathError, outlines


@dataclass(frozen=True)
class Drawn:
    """Annotates a list of points: takes a path of one stroke for it; one that is closed only if it `may_close`."""

    may_close: bool = True

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_before_validator_function(self._points, handler(source))

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return {"anyOf": [handler(schema), {"type": "string", "pattern": r"^\s*[Mm]"}]}

    def _points(self, value: Any) -> Any:
        if not isinstance(value, str):
            return value
        try:
            found = outlines(value)
        except PathError as error:
            raise _error(error.message, error.span) from None
        if len(found) != 1:
            said = "draws nothing" if not found else f"has {len(found)} strokes, and this is one outline"
            raise _error(f"the path {said}", (0, max(len(value), 1)))
        points, closed = found[0]
        if closed and not self.may_close:
            end = max(value.rfind("z"), value.rfind("Z"))
            raise _error('a chain is closed by "closed": true, not by Z', (end, end + 1))
        return [list(point) for point in points]


def _error(message: str, span: tuple[int, int]) -> PydanticCustomError:
    return PydanticCustomError("drawing", message, {"span": span})
