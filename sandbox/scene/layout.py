"""JSON texts laid out anew: the same tokens, other white space.

Nothing is read into numbers and back, so every number, string and key keeps its text, and keys their order. What fits
on a line stays on one. Of what does not, the outermost two levels have a line a member, as a scene lists its bodies;
deeper ones fill their lines, and keep the breaks that their author made between members, as gofmt does.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

WIDTH = 120
"""Columns of a line, as long as there is somewhere to break it."""

_TOKEN = re.compile(r'(\s*)("(?:[^"\\]|\\.)*"|[{}\[\],:]|[^\s{}\[\],:"]+)')
_LISTED = 2
"""Containers nested less deep than this have a line a member."""
_HEAD = ('"$schema"', '"format"')
"""Two short keys that begin a file, on one line."""

Tokens = Iterator[tuple[str, str]]
"""White space, and the token after it."""


@dataclass(frozen=True)
class Leaf:
    """A number, a string or a word, as it is written."""

    flat: str


class Member(NamedTuple):
    """What stands in a list (`key` is "" there) or an object; `parted`: its author began a line with it."""

    key: str
    value: Container | Leaf
    parted: bool

    @property
    def prefix(self) -> str:
        """What comes before the value."""
        return self.key + ": " if self.key else ""

    @property
    def flat(self) -> str:
        """The member on one line."""
        return self.prefix + self.value.flat


@dataclass(frozen=True)
class Container:
    """A list, or an object; `flat` is all of it on one line."""

    brackets: str
    members: tuple[Member, ...]
    flat: str


def laid_out(text: str) -> str:
    """A JSON text that a parser has accepted, laid out; ends with a line feed. Laid out again it stays the same."""
    tokens = ((match[1], match[2]) for match in _TOKEN.finditer(text))
    return _laid(_value(tokens, next(tokens)[1]), 0, 0) + "\n"


def _value(tokens: Tokens, token: str) -> Container | Leaf:
    if token not in ("{", "["):
        return Leaf(token)
    brackets = "{}" if token == "{" else "[]"
    members = tuple(_members(tokens, brackets))
    return Container(brackets, members, brackets[0] + ", ".join(member.flat for member in members) + brackets[1])


def _members(tokens: Tokens, brackets: str) -> Iterator[Member]:
    for space, token in tokens:
        if token == brackets[1]:
            return
        if token != ",":
            key = ""
            if brackets == "{}":
                key = token
                next(tokens)  # the colon
                token = next(tokens)[1]
            yield Member(key, _value(tokens, token), "\n" in space)


def _laid(node: Container | Leaf, depth: int, used: int) -> str:
    """The text of a value whose line has `used` columns before it; one more is kept for a comma."""
    if isinstance(node, Leaf) or not node.members or not _is_broken(node, depth, used):
        return node.flat
    inner = "  " * (depth + 1)
    lines: list[str] = []
    for number, member in enumerate(node.members):
        comma = "," if number + 1 < len(node.members) else ""
        if number and _joins(node, number, depth) and len(lines[-1]) + 1 + len(member.flat + comma) <= WIDTH:
            lines[-1] += f" {member.flat}{comma}"
        else:
            value = _laid(member.value, depth + 1, len(inner) + len(member.prefix))
            lines.append(f"{inner}{member.prefix}{value}{comma}")
    return "\n".join([node.brackets[0], *lines, "  " * depth + node.brackets[1]])


def _is_broken(node: Container, depth: int, used: int) -> bool:
    if depth == 0 or used + len(node.flat) + 1 > WIDTH:
        return True
    objects = node.brackets == "[]" and any(value.flat[0] == "{" for _, value, _ in node.members)
    return depth == 1 and objects and (len(node.members) > 1 or node.members[0].parted)


def _joins(node: Container, number: int, depth: int) -> bool:
    """Whether a member may stand behind the one before it, if there is room."""
    before, member = node.members[number - 1 : number + 1]
    if depth < _LISTED and not _only_leaves(node):
        return depth == 0 and (before.key, member.key) == _HEAD
    room = 2 * (depth + 1)
    return not member.parted and all(room + len(each.flat) + 1 <= WIDTH for each in (before, member))


def _only_leaves(node: Container) -> bool:
    return node.brackets == "[]" and all(isinstance(value, Leaf) for _, value, _ in node.members)
