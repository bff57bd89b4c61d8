"""What all scene models share: unknown fields are mistakes, values are strict and never change."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pydantic import BaseModel, ConfigDict, ValidationError

from sandbox.attributes import refusal
from sandbox.scene.report import scene_error
from sandbox.scene.wording import findings


class Model(BaseModel):
    """A part of a scene. Immutable; bad values raise one `SceneError` with all mistakes."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, allow_inf_nan=False, defer_build=True)

    def __init__(self, **data: Any) -> None:
        try:
            super().__init__(**data)
        except ValidationError as error:
            raise scene_error(type(self).__name__, findings(error, type(self)), None) from None

    # Unless it is marked so, pydantic calls this for nested models too, but only the outermost may reword.
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    if not TYPE_CHECKING:  # a type checker knows the fields by itself

        def __setattr__(self, name: str, value: Any) -> None:
            if not name.startswith("_"):  # what pydantic and the loader keep
                raise refusal(type(self).__name__, name, name in type(self).model_fields)
            super().__setattr__(name, value)

    def to_data(self) -> dict[str, Any]:
        """The entry as plain data, as a file holds it; fields that were not given are left out."""
        return self.model_dump(mode="json", by_alias=True, exclude_unset=True)

    def given(self) -> dict[str, Any]:
        """The fields the author gave, by Python name; defaults are left out."""
        return {name: getattr(self, name) for name in type(self).model_fields if name in self.model_fields_set}
