"""The finished runs of a sweep on disk while it goes on, so that a crash or a kill loses only the runs under way.

A journal is a file of JSON lines beside the output: first what sweep it is of, then a line for each run, in the order
of finishing. A last line that was cut off is left out. When the output has been written, the journal goes.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import takewhile
from pathlib import Path
from typing import Any

from sandbox._bounded_read import read_bytes
from sandbox._printable import told
from sandbox.errors import SandboxError
from sandbox.sweeps.study import Outcome

SUFFIX = ".journal"
_LARGEST = 1 << 30
"""Bytes of a journal that is read back at most."""


def journal_of(output: Path) -> Path:
    """Where the journal of a sweep is that writes to `output`."""
    return output.with_name(output.name + SUFFIX)


class Journal:
    """Writes finished runs down."""

    def __init__(self, path: Path, fingerprint: str, runs: int) -> None:
        self._path = path
        self._head = {"sweep": 1, "fingerprint": fingerprint, "runs": runs}
        self._file: Any = None

    def done(self) -> dict[int, Outcome]:
        """The runs that an earlier sweep has finished; none where there is no journal.

        Raises `SandboxError` where the journal is that of another sweep, and `OSError`.
        """
        if not self._path.exists():
            return {}
        head, *rows = list(_rows(read_bytes(self._path, _LARGEST))) or [None]
        if head != self._head:
            raise SandboxError(
                f"{told(self._path)}: this journal is of another sweep, of another scene, other options or another "
                "version; --force begins anew"
            )
        return {row[0]: _outcome(row) for row in rows}

    @contextmanager
    def writing(self, goes_on: bool) -> Iterator[Journal]:
        """Be open for `note`; `goes_on`: behind what is there, without a line that was cut off.

        Raises `SandboxError` while another sweep writes it, and `OSError`.
        """
        with open(self._path, "a", encoding="utf-8", newline="\n") as self._file:
            self._claim()
            kept = len(_whole_lines(read_bytes(self._path, _LARGEST))) if goes_on else 0
            self._file.truncate(kept)
            if not kept:
                self._line(self._head)
            yield self

    def note(self, outcome: Outcome) -> None:
        """Write a run down."""
        self._line([outcome.run, outcome.values, outcome.digest, outcome.steps, outcome.status])

    def _claim(self) -> None:
        """Two sweeps that wrote one journal would mix their runs. The claim goes with the process, however it ends."""
        try:
            import fcntl
        except ImportError:  # no such claims on this system
            return
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise SandboxError(f"{told(self._path)}: another sweep writes it now; give this one another -o") from None
        except OSError:  # nor on this file system
            return

    def remove(self) -> None:
        """The output has been written."""
        self._path.unlink(missing_ok=True)

    def _line(self, data: Any) -> None:
        self._file.write(json.dumps(data) + "\n")
        self._file.flush()  # a killed process loses nothing that the system has


def _rows(data: bytes) -> Iterator[Any]:
    """What the whole lines of a journal say."""
    return map(json.loads, _whole_lines(data).splitlines())


def _whole_lines(data: bytes) -> bytes:
    """A journal up to the first line that was cut off or damaged: those runs are made again."""
    lines = data.split(b"\n")[:-1]
    good = list(takewhile(_is_whole, lines))
    return b"".join(line + b"\n" for line in good)


def _is_whole(line: bytes) -> bool:
    try:
        return isinstance(json.loads(line), (dict, list))
    except ValueError:
        return False


def _outcome(row: Any) -> Outcome:
    run, values, digest, steps, status = row
    return Outcome(int(run), tuple(map(float, values)), str(digest), int(steps), str(status))
