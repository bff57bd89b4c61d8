"""What is said of the next click: a sentence, and the keys that go with it, kept apart so that none is cut."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Key:
    """What is pressed, a cap for each, and what that does."""

    caps: tuple[str, ...]
    does: str

    @property
    def text(self) -> str:
        """`Shift: add`, `Left / Right: Turn`."""
        return f"{' / '.join(self.caps)}: {self.does}"


@dataclass(frozen=True)
class Hint:
    """A sentence and keys."""

    words: str
    keys: tuple[Key, ...] = ()

    @property
    def text(self) -> str:
        """All of it in words."""
        return "  ".join([*([self.words] if self.words else []), *(key.text for key in self.keys)])


GIVE_UP = Key(("Esc",), "give up")
