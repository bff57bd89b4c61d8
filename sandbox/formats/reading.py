"""Plain data of a foreign file, read value by value: what has the wrong type is told with its place."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Self

from sandbox.scene.constraints import describe
from sandbox.scene.finding import Path, quoted

Vec = tuple[float, float]

_ANY_FORCE = 1e15


class MisreadError(Exception):
    """A value cannot be used. `path` leads to it, as in `sandbox.scene.finding`; no user sees this one."""

    def __init__(self, path: Path, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.path, self.message, self.hint = path, message, hint


def place_of(path: Path, name: str = "") -> str:
    """A path as remarks tell it, such as `joint[3] "rope"`."""
    parts = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in path)
    return parts.removeprefix(".") + (f" {quoted(name)}" if name else "")


class Node:
    """An object of a file and the path to it. A key that is missing, or null, has the default.

    It remembers which keys it was asked for, so that the others can be told: `unread`.
    """

    def __init__(self, data: dict[str, Any], path: Path = ()) -> None:
        self.data, self.path = data, path
        self._asked = {"name"}

    @property
    def place(self) -> str:
        """Where it is, with its name if it has one."""
        name = self.data.get("name")
        return place_of(self.path, name if isinstance(name, str) else "")

    def value(self, key: str) -> Any:
        """What stands there, whatever it is; None for nothing."""
        self._asked.add(key)
        return self.data.get(key)

    def unread(self, *known: str) -> list[str]:
        """Keys that nobody asked for, but for those `known` to mean nothing and those whose value says nothing."""
        says = (key for key, value in self.data.items() if value not in (None, 0, "", [], {}))
        return [key for key in says if key not in self._asked and key not in known]

    def has(self, key: str) -> bool:
        """Whether there is a value."""
        return self.value(key) is not None

    def number(self, key: str, default: float = 0.0) -> float:
        """A finite number. Raises `MisreadError`."""
        value = self.value(key)
        return default if value is None else self.number_of(value, (*self.path, key))

    def number_of(self, value: Any, path: Path) -> float:
        """A finite number; formats that write numbers in their own way override this. Raises `MisreadError`."""
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise MisreadError(path, f"must be a number, not {describe(value)}")
        if not -1e20 <= value <= 1e20:  # nor NaN
            raise MisreadError(path, "must be a finite number")
        return float(value)

    def strength(self, key: str, default: float = 0.0) -> float:
        """A force or torque: one greater than a scene has is the greatest that it has. Raises `MisreadError`."""
        value = self.value(key)
        if isinstance(value, (int, float)) and not isinstance(value, bool) and value > _ANY_FORCE:
            return _ANY_FORCE
        return self.number(key, default)

    def whole(self, key: str, default: int = 0) -> int:
        """A whole number. Raises `MisreadError`."""
        value = self.number(key, default)
        if value != int(value):
            raise MisreadError((*self.path, key), "must be a whole number")
        return int(value)

    def flag(self, key: str, default: bool = False) -> bool:
        """true or false, or 1 and 0. Raises `MisreadError`."""
        value = self.value(key)
        if value is None:
            return default
        if not isinstance(value, (bool, int)):
            raise MisreadError((*self.path, key), f"must be true or false, not {describe(value)}")
        return bool(value)

    def text(self, key: str, default: str = "") -> str:
        """A text. Raises `MisreadError`."""
        value = self.value(key)
        if value is None:
            return default
        if not isinstance(value, str):
            raise MisreadError((*self.path, key), f"must be text, not {describe(value)}")
        return value

    def vector(self, key: str, default: Vec = (0.0, 0.0)) -> Vec:
        """{"x": .., "y": ..}, or the number 0 for the zero vector. Raises `MisreadError`."""
        value = self.value(key)
        return default if value is None else self.vector_of(value, (*self.path, key))

    def vector_of(self, value: Any, path: Path) -> Vec:
        """The same for a value that was found elsewhere. Raises `MisreadError`."""
        if isinstance(value, dict):
            x, y = (0.0 if (part := value.get(axis)) is None else part for axis in "xy")
            return self.number_of(x, (*path, "x")), self.number_of(y, (*path, "y"))
        if isinstance(value, list) and len(value) == 2:
            return self.number_of(value[0], (*path, 0)), self.number_of(value[1], (*path, 1))
        if value == 0 and not isinstance(value, bool):
            return 0.0, 0.0
        raise MisreadError(path, f'must be {{"x": .., "y": ..}}, not {describe(value)}')

    def listed(self, key: str) -> list[Any]:
        """A list; none is empty. Raises `MisreadError`."""
        value = self.value(key)
        if value is None:
            return []
        if not isinstance(value, list):
            raise MisreadError((*self.path, key), f"must be a list, not {describe(value)}")
        return value

    def node(self, key: str) -> Self | None:
        """An object, or None. Raises `MisreadError`."""
        value = self.value(key)
        return None if value is None else self._made(value, (*self.path, key))

    def nodes(self, key: str) -> Iterator[Self]:
        """The objects of a list. Raises `MisreadError`."""
        for index, value in enumerate(self.listed(key)):
            yield self._made(value, (*self.path, key, index))

    def points(self, key: str) -> list[Vec]:
        """A list of vectors, or parallel lists {"x": [..], "y": [..]}. Raises `MisreadError`."""
        value, path = self.value(key), (*self.path, key)
        if isinstance(value, dict):
            columns = self._made(value, path)
            xs, ys = columns.listed("x"), columns.listed("y")
            if len(xs) != len(ys):
                raise MisreadError(path, f'"x" has {len(xs)} entries and "y" has {len(ys)}')
            pairs = enumerate(zip(xs, ys, strict=True))
            return [(self.number_of(x, (*path, "x", i)), self.number_of(y, (*path, "y", i))) for i, (x, y) in pairs]
        return [self.vector_of(each, (*path, i)) for i, each in enumerate(self.listed(key))]

    def _made(self, value: Any, path: Path) -> Self:
        if not isinstance(value, dict):
            raise MisreadError(path, f"must be an object, not {describe(value)}")
        return type(self)(value, path)
