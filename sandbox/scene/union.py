"""Unions told apart by the key that is there: `{"circle": 1}` is a circle, `{"box": [1, 1]}` a box."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel, Discriminator

TAG = "\x00"
"""Begins every tag, so that a tag in pydantic's error location cannot be taken for a field name."""


def by_key(what: str, kinds: Mapping[str, type[BaseModel]]) -> Discriminator:
    """A discriminator over `kinds` (key -> model); its error has type `kind` and the message `what`."""

    def tag_of(value: Any) -> str | None:
        given = value if isinstance(value, dict) else getattr(type(value), "model_fields", ())
        found = [key for key in kinds if key in given]
        return TAG + found[0] if len(found) == 1 else None

    return Discriminator(tag_of, custom_error_type="kind", custom_error_message=what)


def by_type(what: str) -> Discriminator:
    """A discriminator over number, text and list; `what` completes "must be ..." in its error."""

    def tag_of(value: Any) -> str | None:
        if isinstance(value, bool):
            return None
        tags = ((int, "number"), (str, "text"), ((list, tuple), "list"))
        return next((TAG + tag for kind, tag in tags if isinstance(value, kind)), None)

    return Discriminator(tag_of, custom_error_type="choice", custom_error_message=what)


def by_value(what: str, field: str, kinds: Mapping[str, type[BaseModel]]) -> Discriminator:
    """A discriminator by the value of `field`, a key of `kinds`; its error has type `kind_value`."""

    def tag_of(value: Any) -> str | None:
        given = value.get(field) if isinstance(value, dict) else getattr(value, field, None)
        return TAG + given if isinstance(given, str) and given in kinds else None

    return Discriminator(tag_of, custom_error_type="kind_value", custom_error_message=what)
