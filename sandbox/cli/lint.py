"""`sandbox lint`: what is allowed in a scene, and hardly meant."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from sandbox._printable import told
from sandbox.cli.document import JSON, print_document
from sandbox.cli.failures import FAILED, HOLDS, UNUSABLE, problems
from sandbox.cli.options import SET, takes, values_set
from sandbox.errors import ArgumentError, SandboxError
from sandbox.resources import SCENE_SUFFIX

if TYPE_CHECKING:
    from sandbox.cli.annotations import Note
    from sandbox.lint.rule import Rule
    from sandbox.lint.run import Lint

    Look = Callable[[Path], Sequence[Lint]]

_PATHS = typer.Argument(
    metavar="SCENE", show_default=False,
    help=f"Scene files, or folders to search for *{SCENE_SUFFIX}; without any, this folder.",
)  # fmt: skip
_SELECT = typer.Option(metavar="RULES", show_default=False, help="Only these rules, with commas between.")
_IGNORE = typer.Option(metavar="RULES", show_default=False, help="Not these rules, with commas between.")
_RULES = typer.Option("--rules", help="List the rules, and run none.")


@dataclass(frozen=True)
class LintOptions:
    """What `sandbox lint` was asked for."""

    paths: Annotated[list[Path] | None, _PATHS] = None
    select: Annotated[str, _SELECT] = ""
    ignore: Annotated[str, _IGNORE] = ""
    rules: Annotated[bool, _RULES] = False
    set: Annotated[list[str] | None, SET] = None
    json: Annotated[bool, JSON] = False


@dataclass(frozen=True)
class Result:
    """What was found in a file, or the error that kept it from being looked at."""

    path: Path
    found: Sequence[Lint] = ()
    error: Exception | None = None


@takes(LintOptions)
def lint(options: LintOptions) -> None:
    """Find what a scene may have and its author hardly meant: bodies in each other, motors that do nothing, ...

    A scene keeps a rule away by its name: "lint": {"ignore": ["overlap"]}.

    Exit code 0: nothing was found.
    Exit code 1: something was.
    Exit code 2: a file or an option could not be used; the others were still looked at.
    Exit code 5: there was none to look at.
    """
    from sandbox.cli.annotations import annotate
    from sandbox.cli.check import find_files
    from sandbox.cli.compiling import announce_compilation

    rules = _chosen(options)
    if options.rules:
        _print_rules(rules, options.json)
        return
    files = find_files(options.paths or [Path()], verb="lint")
    announce_compilation()
    look = _look(rules, values_set(options.set))
    results = _for_machines(files, look) if options.json else _for_people(files, look)
    annotate(_notes(results), to_stderr=options.json)
    raise typer.Exit(_exit_code(results))


def _chosen(options: LintOptions) -> tuple[Rule, ...]:
    from sandbox.lint.registry import chosen

    for name, text in (("--select", options.select), ("--ignore", options.ignore)):
        try:
            chosen(_names(text))
        except ArgumentError as error:
            raise SandboxError(f"{name}: {error}") from None
    return chosen(_names(options.select), _names(options.ignore))


def _names(text: str) -> list[str]:
    return [name.strip() for name in text.split(",") if name.strip()]


def _print_rules(rules: Iterable[Rule], as_json: bool) -> None:
    if as_json:
        print_document({"rules": [{"name": rule.name, "finds": rule.finds} for rule in rules]})
    else:
        for rule in rules:
            typer.echo(f"{rule.name:<14} {rule.finds}")


def _look(rules: Sequence[Rule], values: Mapping[str, Any]) -> Look:
    from sandbox.cli.opening import open_any
    from sandbox.lint.run import lint

    return lambda file: lint(open_any(file, values), rules)


def _results(files: Sequence[Path], look: Look) -> Iterator[Result]:
    from rich.console import Console

    from sandbox.cli.progress import SceneProgress

    with SceneProgress(Console(stderr=True), 1, "files") as progress:
        progress.begin("scenes", len(files))
        for done, file in enumerate(files, 1):
            try:
                yield Result(file, look(file))
            except (SandboxError, OSError) as error:
                yield Result(file, error=error)
            progress.done(done)


def _for_people(files: Sequence[Path], look: Look) -> list[Result]:
    from rich.console import Console
    from rich.text import Text

    out = Console(soft_wrap=True, highlight=False)
    results = []
    for result in _results(files, look):
        for found in result.found:
            out.print(_line(result.path, found))
        _report(result)
        results.append(result)
    out.print(Text(_summary(results), style="bold"))
    return results


def _summary(results: Sequence[Result]) -> str:
    count, unusable = (sum(each) for each in zip(*((len(r.found), r.error is not None) for r in results), strict=True))
    scenes = f"{len(results)} scene{'' if len(results) == 1 else 's'}"
    lost = f"{unusable} could not be used"
    if unusable == len(results):
        return f"{scenes}: {lost}"
    return f"{scenes}: {count or 'no'} finding{'' if count == 1 else 's'}" + (f", {lost}" if unusable else "")


def _line(path: Path, found: Lint) -> Any:
    from rich.text import Text

    problem = found.problem
    place = f":{problem.line}:{problem.column}" if problem.line else f" (at {problem.pointer})" * bool(problem.pointer)
    hint = f": {problem.hint}" if problem.hint else ""
    return Text.assemble((f"{told(path)}{place}: ", "bold"), (f"{found.rule}: ", "cyan"), problem.message, hint)


def _for_machines(files: Sequence[Path], look: Look) -> list[Result]:
    results = list(_results(files, look))
    for result in results:
        _report(result)
    print_document({"scenes": [_entry(result) for result in results]}, _exit_code(results))
    return results


def _entry(result: Result) -> dict[str, Any]:
    from dataclasses import asdict

    entry = {"path": result.path.as_posix()}
    if result.error is not None:
        return {**entry, "problems": problems(result.error)}
    return {**entry, "findings": [{"rule": found.rule, **asdict(found.problem)} for found in result.found]}


def _notes(results: Sequence[Result]) -> Iterator[Note]:
    """What GitHub shows beside the files."""
    from sandbox.cli.annotations import Note, notes_of_error

    for result in results:
        if result.error is not None:
            yield from notes_of_error(result.path, result.error, "lint")
        for found in result.found:
            text = ": ".join(filter(None, (found.problem.message, found.problem.hint)))
            yield Note(result.path.as_posix(), found.problem.line, f"lint {found.rule}", text, "warning")


def _report(result: Result) -> None:
    from sandbox.cli.failures import report

    if result.error is not None:
        report(result.error)


def _exit_code(results: Sequence[Result]) -> int:
    if any(result.error is not None for result in results):
        return UNUSABLE
    return FAILED if any(result.found for result in results) else HOLDS
