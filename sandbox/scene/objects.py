"""Models by the words an author knows them by, so that a field in the wrong place can be told where it belongs."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from pydantic import BaseModel

ModelClass = TypeVar("ModelClass", bound=type[BaseModel])

OBJECTS: dict[str, type[BaseModel]] = {}
"""Filled by `known_as`: "a body" -> `Body`."""


def known_as(words: str) -> Callable[[ModelClass], ModelClass]:
    """Decorator: put a model into `OBJECTS`."""

    def register(model: ModelClass) -> ModelClass:
        OBJECTS[words] = model
        return model

    return register
