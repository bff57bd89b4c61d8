"""Functions that are instructions of LLVM's in kernels, and plain functions in Python."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any, Generic, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")


class Instruction(Generic[P, R]):
    """A function that kernels call. What it is in machine code is known to `instruction_type` of the module `emitter`,
    which imports numba, and is asked for when something is compiled."""

    def __init__(self, function: Callable[P, R], emitter: str) -> None:
        self._function, self._emitter = function, emitter

    def __call__(self, *arguments: P.args, **named: P.kwargs) -> R:
        return self._function(*arguments, **named)

    @property
    def _numba_type_(self) -> Any:
        """What numba asks of an object that a kernel mentions."""
        return import_module(self._emitter).instruction_type(self._function.__name__)
