"""Commands whose options are the fields of a dataclass, for those with more than a signature should hold."""

from __future__ import annotations

import functools
import inspect
import json
from collections.abc import Callable, Sequence
from typing import Any, TypeVar, get_type_hints

import typer

from sandbox.arguments import MOST_WORKERS
from sandbox.errors import SandboxError

Options = TypeVar("Options")
WORKERS = typer.Option(
    "--workers",
    min=1,
    max=MOST_WORKERS,
    metavar="N",
    help="Threads that share a step of many bodies; the bits are the same.",
)

SET = typer.Option(
    "--set", metavar="PATH=VALUE", show_default=False,
    help='Put a value into the scene before anything is made of it: "vars.rows=40", "bodies.crate.mass=2". Repeatable.',
)  # fmt: skip


def values_set(given: Sequence[str] | None) -> dict[str, Any]:
    """What `--set` options say, as `load_scene` takes it: values are JSON, or else text. Raises `SandboxError`."""
    values: dict[str, Any] = {}
    for words in given or ():
        path, equals, value = words.partition("=")
        if not path or not equals:
            raise SandboxError(f"--set {words!r}: write a path and a value, such as --set gravity.1=-1.62")
        if path in values:
            raise SandboxError(f"--set {path} is given twice")
        try:
            values[path] = json.loads(value)
        except (ValueError, RecursionError):
            values[path] = value
    return values


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
