"""Kernels that only kernels call, for tests that call them one by one."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from sandbox._jit import entry_point

F = TypeVar("F", bound=Callable[..., object])


def called_from_python(kernel: F) -> F:
    """`kernel` as an entry point. Its machine code is kept, as that of the engine's own."""
    return entry_point(getattr(kernel, "py_func", kernel))
