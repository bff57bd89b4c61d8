"""Commands whose options are the fields of a dataclass, for those with more than a signature should hold."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import Any, TypeVar, get_type_hints

import typer

Options = TypeVar("Options")
WORKERS = typer.Option(
    "--workers", min=1, max=64, metavar="N", help="Threads that share a step of many bodies; the bits are the same."
)


def takes(options_class: type[Options]) -> Callable[[Callable[[Options], None]], Callable[..., None]]:
    """Decorator for a command `(options) -> None`: typer sees the fields of `options_class` as its parameters.

    A field is annotated as typer's parameters are, `Annotated[TYPE, typer.Option(...)]`, and has its default; the
    order of the fields is that of the help text. Help and errors are those of a function with that signature.
    """

    def decorate(command: Callable[[Options], None]) -> Callable[..., None]:
        @functools.wraps(command)
        def run(**given: Any) -> None:
            command(options_class(**given))

        # Typer reads both.
        run.__signature__ = inspect.signature(options_class, eval_str=True)  # type: ignore[attr-defined]
        run.__annotations__ = get_type_hints(options_class, include_extras=True)
        return run

    return decorate
