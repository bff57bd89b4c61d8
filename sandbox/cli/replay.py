"""`sandbox replay`: run recordings again and compare."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import typer

from sandbox.cli.command import Command
from sandbox.cli.options import takes
from sandbox.cli.output import check_report
from sandbox.cli.replay_options import ReplayOptions
from sandbox.errors import SandboxError

if TYPE_CHECKING:
    from sandbox.replay.golden.examine import ReplaySettings

UPDATES = ("missing", "changed", "all")


class CommandClass(Command):
    """`--update` stands for `--update=changed`."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Give a bare `--update` its value: the word that follows, if it is one and nothing is called so."""
        given: list[str] = []
        for arg in args:
            if given[-1:] == ["--update"] and arg in UPDATES and not os.path.exists(arg):
                arg = f"{given.pop()}={arg}"
            given.append(arg)
        return super().parse_args(ctx, ["--update=changed" if arg == "--update" else arg for arg in given])


@takes(ReplayOptions)
def replay(options: ReplayOptions) -> None:
    """Run recordings again without a window and compare every step with what was recorded.

    passed: the same bits. diverged: other bits. stale: the scene was edited since. missing: a scene with expectations
    has no recording beside it. orphaned: the recording's scene is gone.

    Exit code 0: all passed, or were renewed as asked.
    Exit code 1: some did not.
    Exit code 2: a file or an option could not be used; the others still ran.
    Exit code 5: nothing was found to run.
    """
    settings = _settings(options)
    part = _part(options.shard)
    check_report("--report", options.report, [".html", ".htm"], options.paths)
    check_report("--junit", options.junit, [".xml"], options.paths)
    if options.against and (options.tolerance or options.heavy or options.update or options.prune):
        raise SandboxError("--against: two revisions are compared bit for bit, and nothing is renewed")
    if options.engine is not None and not options.against:
        raise SandboxError("--engine says where the revision of --against is: give both")
    from sandbox.cli.replay_run import Work, run

    raise typer.Exit(run(Work(options, settings, part)))


def _settings(options: ReplayOptions) -> ReplaySettings:
    update, prune = options.update, options.prune
    if update and update not in UPDATES:
        raise SandboxError(f"--update={update}: there are {', '.join(UPDATES)}")
    if (update or prune) and os.environ.get("CI"):
        option = "--update" if update else "--prune"
        raise SandboxError(f"{option}: CI is set, and recordings are never written there; run it on your machine")
    from sandbox.replay.golden.examine import ReplaySettings
    from sandbox.replay.golden.tolerance import Tolerance

    return ReplaySettings(Tolerance() if options.tolerance else None, options.heavy, update, prune)  # type: ignore[arg-type]


def _part(text: str) -> tuple[int, int]:
    number, slash, count = text.partition("/")
    if not text:
        return 1, 1
    if not (slash and number.isdecimal() and count.isdecimal() and 1 <= int(number) <= int(count)):
        raise SandboxError(f"--shard={text}: write I/N, as in 1/4")
    return int(number), int(count)
