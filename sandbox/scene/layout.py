"""JSON texts laid out anew: the same tokens, other white space.

Nothing is read into numbers and back, so every number, string and key keeps its text, and keys their order. What fits
on a line stays on one. Of what does not, the outermost two levels have a line a member, as a scene lists its bodies;
deeper ones fill their lines, and keep the breaks that their author made between members, as gofmt does.
"""

from __future__ import annotations

import re
from typing import NamedTuple, TypeAlias

WIDTH = 120
"""Columns of a line, as long as there is somewhere to break it."""

_TOKEN = re.compile(r'(\s*)(?:("(?:[^"\\]|\\.)*")(\s*:)?|(\[[^\[\]{}"]*\])|([{}\[\]])|([^\s{}\[\],:"]+))(?:\s*,)?')
"""White space, then a text with a colon if it is a key, a list without texts, a bracket or another word."""
_LISTED = 2
"""Containers nested less deep than this have a line a member."""
_HEAD = ('"$schema"', '"format"')
"""Two short keys that begin a file, on one line."""


class Container(NamedTuple):
    """A list, or an object; `flat` is all of it on one line."""

    brackets: str
    members: tuple[Member, ...]
    flat: str


Value: TypeAlias = Container | str
"""What is no container is its own text, and so is a list of numbers as long as it fits on a line."""


class Member(NamedTuple):
    """What stands in a list (`key` is "" there) or an object; `parted`: its author began a line with it."""

    key: str
    value: Value
    parted: bool

    @property
    def prefix(self) -> str:
        """What comes before the value."""
        return self.key + ": " if self.key else ""

    @property
    def flat(self) -> str:
        """The member on one line."""
        return self.prefix + _flat(self.value)


def laid_out(text: str) -> str:
    """A JSON text that a parser has accepted, laid out; ends with a line feed. Laid out again it stays the same."""
    return _laid(_tree(text), 0, 0) + "\n"


def _tree(text: str) -> Value:
    members: list[Member] = []
    around: list[tuple[str, list[Member], str, bool]] = []
    key, parted = "", False
    for match in _TOKEN.finditer(text):
        space, string, colon, numbers, bracket, word = match.groups()
        if not key:
            parted = "\n" in space
        if colon:
            key = string
            continue
        if bracket in ("{", "["):
            around.append((bracket, members, key, parted))
            members, key = [], ""
            continue
        value: Value = string or word
        if bracket:
            opening, outer, key, parted = around.pop()
            value, members = _container(opening + bracket, members), outer
        elif numbers:
            value = f"[{', '.join(numbers[1:-1].replace(',', ' ').split())}]"
        members.append(Member(key, value, parted))
        key = ""
    return members[0].value


def _container(brackets: str, members: list[Member]) -> Container:
    flat = brackets[0] + ", ".join([member.flat for member in members]) + brackets[1]
    return Container(brackets, tuple(members), flat)


def _flat(value: Value) -> str:
    return value if isinstance(value, str) else value.flat


def _laid(value: Value, depth: int, used: int) -> str:
    """The text of a value whose line has `used` columns before it; one more is kept for a comma."""
    node = _opened(value) if used + len(_flat(value)) + 1 > WIDTH else value
    if isinstance(node, str) or not node.members or not _is_broken(node, depth, used):
        return _flat(node)
    inner, words = "  " * (depth + 1), _only_words(node)
    lines: list[str] = []
    for number, member in enumerate(node.members):
        comma = "," if number + 1 < len(node.members) else ""
        kept = member.parted and not words
        fills = not kept if depth >= _LISTED or words else _is_head(node, number, depth)
        if (
            number
            and fills
            and _has_room(node, number, depth)
            and len(lines[-1]) + 1 + len(member.flat + comma) <= WIDTH
        ):
            lines[-1] += f" {member.flat}{comma}"
        else:
            laid = _laid(member.value, depth + 1, len(inner) + len(member.prefix))
            lines.append(f"{inner}{member.prefix}{laid}{comma}")
    return "\n".join([node.brackets[0], *lines, "  " * depth + node.brackets[1]])


def _opened(value: Value) -> Value:
    """A list of numbers as a container."""
    if not isinstance(value, str) or value[0] != "[":
        return value
    return Container("[]", tuple(Member("", word, False) for word in value[1:-1].split(", ")), value)


def _is_broken(node: Container, depth: int, used: int) -> bool:
    if depth == 0 or used + len(node.flat) + 1 > WIDTH:
        return True
    objects = node.brackets == "[]" and any(_flat(value)[0] == "{" for _, value, _ in node.members)
    return depth == 1 and objects and (len(node.members) > 1 or node.members[0].parted)


def _has_room(node: Container, number: int, depth: int) -> bool:
    """Whether a member and the one before it each fit on a line."""
    room = 2 * (depth + 1)
    return all(room + len(each.flat) + 1 <= WIDTH for each in node.members[number - 1 : number + 1])


def _is_head(node: Container, number: int, depth: int) -> bool:
    return depth == 0 and (node.members[number - 1].key, node.members[number].key) == _HEAD


def _only_words(node: Container) -> bool:
    return node.brackets == "[]" and all(isinstance(value, str) and value[0] != "[" for _, value, _ in node.members)
