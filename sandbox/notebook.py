"""What a notebook shows of a value, without the value's room knowing of pages."""

from __future__ import annotations

import importlib


class Shown:
    """A notebook shows a player of it."""

    def _repr_html_(self) -> str:
        # By name: pages are made of everything below them, also of the rooms of those that are shown.
        shown: str = importlib.import_module("sandbox.report.notebook").html_of(self)
        return shown
