"""Islands by flood fill."""

from __future__ import annotations


def islands(count: int, links: list[tuple[int, int]], active: list[bool]) -> list[int]:
    """For each of `count` bodies the lowest body it is joined to by links between active bodies."""
    near: dict[int, set[int]] = {i: {i} for i in range(count)}
    for a, b in links:
        if active[a] and active[b]:
            near[a].add(b)
            near[b].add(a)
    lowest = [-1] * count
    for start in range(count):
        if lowest[start] >= 0:
            continue
        reached, frontier = {start}, [start]
        while frontier:
            for other in near[frontier.pop()] - reached:
                reached.add(other)
                frontier.append(other)
        for member in reached:
            lowest[member] = start
    return lowest
