"""Unions told apart by the key that is there: `{"circle": 1}` is a circle, `{"box": [1, 1]}` a box."""

from __future__ import annotations

from collections.abc import Container, Mapping
from functools import cache
from typing import Any

from pydantic import BaseModel, Discriminator

TAG = "\x00"
"""Begins every tag, so that a tag in pydantic's error location cannot be taken for a field name."""
TAGS: set[str] = set()
"""All tags that the unions below have."""
UNIONS: dict[str, Mapping[str, type[BaseModel]]] = {}
"""The kinds of each union (key -> model), by the word for what they are, such as "shape"."""


def by_key(what: str, kinds: Mapping[str, type[BaseModel]]) -> Discriminator:
    """A discriminator over `kinds` (key -> model); its error has type `kind` and the message `what`."""

    def tag_among(given: Container[str]) -> str | None:
        found = [key for key in kinds if key in given]
        return TAG + found[0] if len(found) == 1 else None

    @cache  # pydantic asks for each shape of a scene, and makes its fields anew each time
    def tag_of_model(model: type) -> str | None:
        return tag_among(getattr(model, "model_fields", ()))

    def tag_of(value: Any) -> str | None:
        if isinstance(value, dict):
            return tag_among(value)
        model: Any = type(value)
        return tag_of_model(model)

    _register(what, kinds)
    return Discriminator(tag_of, custom_error_type="kind", custom_error_message=what)


def by_type(what: str) -> Discriminator:
    """A discriminator over number, text and list; `what` completes "must be ..." in its error."""

    tags = ((int, "number"), (str, "text"), ((list, tuple), "list"))

    def tag_of(value: Any) -> str | None:
        if isinstance(value, bool):
            return None
        return next((TAG + tag for kind, tag in tags if isinstance(value, kind)), None)

    TAGS.update(TAG + tag for _, tag in tags)
    return Discriminator(tag_of, custom_error_type="choice", custom_error_message=what)


def by_value(what: str, field: str, kinds: Mapping[str, type[BaseModel]]) -> Discriminator:
    """A discriminator by the value of `field`, a key of `kinds`; its error has type `kind_value`."""

    def tag_of(value: Any) -> str | None:
        given = value.get(field) if isinstance(value, dict) else getattr(value, field, None)
        return TAG + given if isinstance(given, str) and given in kinds else None

    _register(what, kinds)
    return Discriminator(tag_of, custom_error_type="kind_value", custom_error_message=what)


def _register(what: str, kinds: Mapping[str, type[BaseModel]]) -> None:
    UNIONS[what] = kinds
    TAGS.update(TAG + key for key in kinds)
