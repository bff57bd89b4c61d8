"""Contacts in blocks by colour; those that found none get further ones in rounds: the judge of `fill_blocks`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from sandbox.engine.contact_solver.blocks import ALL_COLORS, ENOUGH, KIND, LANES, MAX_COLORS

Pair = tuple[int, int]


class Block(NamedTuple):
    """Contacts that are solved at once, or one by one."""

    serial: bool
    contacts: tuple[int, ...]


def lowest_colors(pairs: Sequence[Pair], contacts: Sequence[int], movable: Sequence[bool]) -> dict[int, int]:
    """For each of some contacts, in order, the lowest colour that no earlier one has at a body that moves; 62 if all
    are taken."""
    had: dict[int, set[int]] = {body: set() for body in range(len(movable))}
    found = {}
    for contact in contacts:
        bodies = [body for body in pairs[contact] if movable[body]]
        taken = set().union(*(had[body] for body in bodies))
        found[contact] = next(c for c in range(MAX_COLORS + 1) if c == MAX_COLORS or c not in taken)
        if found[contact] < MAX_COLORS:
            for body in bodies:
                had[body].add(found[contact])
    return found


def fill_blocks(pairs: Sequence[Pair], colors: Sequence[int], movable: Sequence[bool], room: int) -> list[Block]:
    """The blocks, of which there is room for so many. `colors` are those of all contacts, -1 for none to be solved."""
    found: list[Block] = []
    for color in range(ALL_COLORS):
        left = [k for k, own in enumerate(colors) if own == color]
        if color % KIND < MAX_COLORS:
            found += cut(left, False)
            continue
        later = sum(blocks_of(sum(own == c for own in colors)) for c in range(color + 1, ALL_COLORS))
        while len(left) >= ENOUGH:
            further = lowest_colors(pairs, left, movable)
            by_color: list[list[int]] = [[] for _ in range(MAX_COLORS + 1)]
            for contact in left:
                by_color[further[contact]].append(contact)
            groups, rest = [group for group in by_color[:MAX_COLORS] if group], by_color[MAX_COLORS]
            needed = len(found) + sum(blocks_of(len(group)) for group in groups) + blocks_of(len(rest)) + later
            if not groups or len(left) - len(rest) < ENOUGH * len(groups) or needed > room:
                break
            for group in groups:
                found += cut(group, False)
            left = rest
        found += cut(left, True)
    return found


def cut(contacts: Sequence[int], serial: bool) -> list[Block]:
    """Blocks of four."""
    return [Block(serial, tuple(contacts[k : k + LANES])) for k in range(0, len(contacts), LANES)]


def blocks_of(count: int) -> int:
    """How many blocks so many contacts of a colour take."""
    return -(-count // LANES)
