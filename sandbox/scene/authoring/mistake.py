"""A mistake within a text of a scene, before the place of that text is known."""

from __future__ import annotations

from sandbox.scene.locate import Span

MARK = "="
"""Begins every expression."""


class ExpressionError(Exception):
    """What is wrong with an expression, the mend, and which characters of it show that."""

    def __init__(self, message: str, hint: str = "", span: Span = (0, 1)) -> None:
        super().__init__(message)
        self.message, self.hint, self.span = message, hint, span
