"""A mistake within a text of a scene, before the place of that text is known."""

from __future__ import annotations

from sandbox.scene.locate import Span

MARK = "="
"""Begins every expression."""


class ExpressionError(Exception):
    """What is wrong with an expression, the mend, which characters of it show that, and whether a name is unknown."""

    def __init__(self, message: str, hint: str = "", span: Span = (0, 1), unknown: bool = False) -> None:
        super().__init__(message)
        self.message, self.hint, self.span, self.unknown = message, hint, span, unknown
