"""Reading a scene's file again while the scene that was read last runs on."""

from __future__ import annotations

from pathlib import Path

from sandbox.errors import SandboxError
from sandbox.window.loader import Loader
from sandbox.window.session import Session

LOOK_SECONDS = 0.5
"""How often the file is looked at."""


class Reloader:
    """Watches the file of a session: `poll` gives the new session, `problem` says what is wrong with the file."""

    def __init__(self, session: Session, workers: int = 1) -> None:
        """Of a recording the file of its scene is watched; it is then played with the scene as it is now."""
        self.path = Path(session.scene.source)
        recording, other = session.recording, session.other
        self._read_from = (recording.source if recording is not None else None) or self.path
        self._other = other.source if other is not None else None
        self.problem = ""
        """Why the file as it stands cannot be used; empty if it can."""
        self._workers = workers
        self._values = session.scene.set_values if recording is None else {}
        self._files = [self.path, *session.scene.included_files]
        self._stamp = self._stamps()
        self._since = 0.0
        self._loader: Loader | None = None

    @property
    def busy(self) -> bool:
        """Whether the file is being read just now."""
        return self._loader is not None

    def poll(self, elapsed: float) -> Session | None:
        """Let `elapsed` seconds pass; a session once the file has changed and is right."""
        if self._loader is not None:
            return self._take() if self._loader.done else None
        self._since += elapsed
        if self._since >= LOOK_SECONDS:
            self._since = 0.0
            stamp = self._stamps()
            if None not in stamp and stamp != self._stamp:
                self._stamp = stamp
                self.read()
        return None

    def read(self) -> None:
        """Read it now, whether it has changed or not."""
        if self._loader is None:
            self._loader = Loader(self._read_from, workers=self._workers, other=self._other, values=self._values)

    def _stamps(self) -> list[tuple[int, int] | None]:
        """Changes when one of the files does, those that the scene includes among them."""
        return [_stamp(path) for path in self._files]

    def _take(self) -> Session | None:
        assert self._loader is not None
        loader, self._loader = self._loader, None
        try:
            session = loader.result()
        except (SandboxError, OSError) as error:
            self.problem = str(error)
            return None
        self.problem = ""
        return session


def _stamp(path: Path) -> tuple[int, int] | None:
    """Changes when the file does; None while there is none, as when an editor is just writing it."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size
