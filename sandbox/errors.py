"""Every error the package raises on purpose. All derive from `SandboxError`, so one `except` catches them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sandbox._printable import printable


class SandboxError(Exception):
    """Base of all errors of this package. Its text is one clear message that a user can act on."""

    def __reduce__(self) -> tuple[Any, ...]:
        """How process pools and `copy` make it again: with its text and attributes, whatever `__init__` takes."""
        return _made_again, (type(self), self.args), self.__dict__


def _made_again(kind: type[SandboxError], args: tuple[Any, ...]) -> SandboxError:
    return kind.__new__(kind, *args)


@dataclass(frozen=True)
class Problem:
    """One mistake in a scene or recording.

    `pointer` is a JSON pointer (RFC 6901) such as `/bodies/3/shapes/0`; `line` and `column` count from 1 and are
    0 where it did not come from a file; `hint` is the mend, if one is known. `source` is the file or the option that it
    is in, where that is another one than the error speaks of.
    """

    message: str
    pointer: str = ""
    line: int = 0
    column: int = 0
    hint: str = ""
    excerpt: str = ""
    source: str = ""


class FileError(SandboxError):
    """A file cannot be used. Carries every problem found, in the order of the file."""

    def __init__(self, source: str, problems: list[Problem]) -> None:
        self.source = source
        self.problems = problems
        super().__init__("\n".join(self.lines()))

    def lines(self) -> list[str]:
        """The error list as text lines: `file:line:column: message`, then the excerpt with a caret, then the hint."""
        out: list[str] = []
        for problem in self.problems:
            source = printable(problem.source or self.source)
            place = f"{source}:{problem.line}:{problem.column}" if problem.line else source
            where = f" (at {problem.pointer})" if problem.pointer and not problem.line else ""
            hint = f" {printable(problem.hint)}" if problem.hint else ""
            colon = ":" if hint and not where else ""  # leads to the hint, unless the pointer comes between
            out.append(f"{place}: {problem.message}{colon}{where}{hint}")
            if problem.excerpt:
                out.append(problem.excerpt)
        return out


class SceneError(FileError):
    """A scene cannot be used."""


class RecordingError(FileError):
    """A recording cannot be used, made or written."""


class ArgumentError(SandboxError, ValueError):
    """A function was given what it does not take."""


class UnknownAttributeError(SandboxError, AttributeError):
    """An object has no attribute of that name; nothing was set."""


class ReadOnlyAttributeError(UnknownAttributeError):
    """An object has that attribute, but it cannot be set."""


class ShapeError(SandboxError, ValueError):
    """A shape cannot be made of the given numbers."""


class QueryError(SandboxError, ValueError):
    """A query cannot be answered as it was asked."""


class CapacityError(SandboxError):
    """Too much is in one place: a step would need more memory, or a world more time, than is allowed.

    A world is as before the step.
    """


class CommandError(SandboxError):
    """A command was refused; the world is unchanged."""


class RefusedCommandError(CommandError):
    """The world refused a command of a run; the run ended there.

    `index` counts the commands of the run from 0, `command` is the command's name, `step` how many steps come before
    it, `reason` why it was refused.
    """

    def __init__(self, index: int, command: str, step: int, time: float, reason: str) -> None:
        self.index, self.command, self.step, self.reason = index, command, step, reason
        self.message = f"{command} after step {step} ({time:.3f} s) was refused: {reason}"
        super().__init__(f"commands[{index}]: {self.message}")


class UnknownBodyError(SandboxError, KeyError):
    """No body of that id in the world."""

    def __str__(self) -> str:
        return str(self.args[0])


class UnknownJointError(SandboxError, KeyError):
    """No joint of that id in the world."""

    def __str__(self) -> str:
        return str(self.args[0])


class UnknownRegionError(SandboxError, KeyError):
    """No region of that id in the world."""

    def __str__(self) -> str:
        return str(self.args[0])


REFUSALS = (CommandError, UnknownBodyError, UnknownJointError, UnknownRegionError)
"""What a world raises for a command that it refuses."""


class SnapshotError(SandboxError):
    """A snapshot cannot be read by this version; the world is unchanged."""


class MissingDependencyError(SandboxError):
    """An optional package or a system library is not there; the text says what to install."""
