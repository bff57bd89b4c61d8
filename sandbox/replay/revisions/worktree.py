"""Revisions of the engine, one after another, in a temporary work tree of its git repository."""

from __future__ import annotations

import hashlib
import os
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Self

import sandbox
from sandbox._kernel_cache import cache_root
from sandbox.errors import SandboxError
from sandbox.replay.causes.history import surroundings


@dataclass(frozen=True)
class Commit:
    """A commit: its full hash and the first line of its message."""

    hash: str
    subject: str

    def __str__(self) -> str:
        return f"{self.hash[:12]} {self.subject}"


class Repository:
    """The git repository with the engine's code: that of the running package, or the one in `folder`."""

    def __init__(self, folder: Path | None = None) -> None:
        package = folder.resolve() if folder is not None else Path(sandbox.__file__).resolve().parents[1]
        self.root = package
        try:
            top = self.git("rev-parse", "--show-toplevel")
            self.git("ls-files", "--error-unmatch", "sandbox/__init__.py")
        except SandboxError as error:
            text = f"{package} is no git checkout of the engine ({error}); name one with --engine FOLDER"
            raise SandboxError(text) from None
        self.inside = package.resolve().relative_to(Path(top).resolve())

    def git(self, *arguments: str) -> str:
        """What git prints. Raises `SandboxError` with git's own words."""
        try:
            command = ["git", "-C", str(self.root), *arguments]
            done = subprocess.run(command, capture_output=True, text=True, check=False, env=surroundings())
        except OSError as error:
            raise SandboxError(f"git cannot be run: {error.strerror}") from None
        if done.returncode:
            raise SandboxError(f"git: {(done.stderr.strip().splitlines() or ['it failed'])[0]}")
        return done.stdout.strip()

    def commit(self, revision: str) -> Commit:
        """The commit that a revision names. Raises `SandboxError` if there is none."""
        try:
            found = self.git("rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}")
        except SandboxError:
            raise SandboxError(f"there is no revision {revision!r} in {self.root}") from None
        return Commit(found, self.git("show", "--no-patch", "--format=%s", found))


class Worktree:
    """A context manager: a work tree that goes away in the end. It lies in the same place every time, if it can.

    Engines of older revisions file machine code under the path of its source: what was not changed is compiled once.
    """

    def __init__(self, repository: Repository) -> None:
        self._repository = repository
        self._folder = _place(repository)

    def checkout(self, commit: Commit) -> Path:
        """Put the code of a commit there; the folder to import `sandbox` from."""
        self._git_there("checkout", "--quiet", "--force", "--detach", commit.hash)
        return self._folder / self._repository.inside

    def __enter__(self) -> Self:
        self._repository.git("worktree", "prune")
        self._repository.git("worktree", "add", "--quiet", "--detach", "--no-checkout", str(self._folder))
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._repository.git("worktree", "remove", "--force", str(self._folder))

    def _git_there(self, *arguments: str) -> None:
        self._repository.git("-C", str(self._folder), *arguments)


def _place(repository: Repository) -> Path:
    """A folder that is not there yet."""
    code = hashlib.blake2b(str(repository.root.resolve()).encode(), digest_size=4).hexdigest()
    home = cache_root() / "revisions"
    home.mkdir(parents=True, exist_ok=True)
    usual = home / code
    return Path(tempfile.mkdtemp(prefix=f"{code}-", dir=home), str(os.getpid())) if usual.exists() else usual
