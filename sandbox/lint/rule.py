"""What a rule is: a name, what it finds, and how."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from sandbox.lint.subject import Subject
from sandbox.scene.finding import Finding


@dataclass(frozen=True)
class Rule:
    """`name` is what authors ignore it by, `finds` completes "this rule finds ..."."""

    name: str
    finds: str
    check: Callable[[Subject], Iterable[Finding]]
