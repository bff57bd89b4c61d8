"""Damage to plain data of a file, and to its text: what an editor, a generator or an enemy would do."""

from __future__ import annotations

import json
from copy import deepcopy
from random import Random
from typing import Any

NUMBERS: list[Any] = [
    0, -0.0, 1, -1, 0.5, 2, 3, 7, 64, 65, 1e308, -1e308, 1e-308, 5e-324, 1e9, -1e9, 1e15, 1e-7, 100_000, 1_000_001,
    2**31, 2**53 + 1, 2**63, -(2**63) - 1, 10**400, float("nan"), float("inf"), float("-inf"),
]  # fmt: skip
TEXTS = [
    "", "a", "*", "[", "[" * 50, "?" * 100, "*a" * 50, "x" * 101, "x" * 10_000, "[" * 20_000, "a\x00b", "\x1b[31m",
    "\ud800", "\u202e", "e\u0301", "\u00e9", "\u0130", "ß", "١٢", "‮", "😀", "#12", "default", "world", "a/b~c", "../x",
    "crate", "ball", "ground", "-1", "NaN", "true", "static", "kinematic", "dynamic", "made", "=i", "=2 * i + 1",
]  # fmt: skip
OTHERS: list[Any] = [
    None, True, False, [], {}, [[]], [{}], [None], [0, 0], [1, 2, 3, 4], [[0, 0], [1, 0], [0, 1]], [[0, 0], [0, 0]],
    {"circle": 1}, {"box": [1, 1]}, {"chain": [[0, 0], [1, 0], [2, 1]]}, {"id": "a"}, {"segment": [[0, 0], [1, 0]]},
]  # fmt: skip
FRAGMENTS = [
    *'{}[]:,"\\-.eE+#/ \n\t\ufeff\x00',
    "NaN",
    "Infinity",
    "1e999",
    "9" * 5000,
    "null",
    "[" * 5000,
    '{"a":' * 40,
]
MOST_NODES = 3000
"""Objects and lists of data that is damaged further: it is to stay a small file."""
MOST_TEXT = 200_000
KINDS = ["row", "stack", "grid", "pyramid", "scatter", "chain", "place"]
MADE = [3, 30, 100, 300, "=2 + i", "=1 / 0"]
MADE_INSIDE = [0, 1, 3, "=n", "=n + i", "=1 / (n - 1)"]
"""Counts of what a generator makes, in a scene and in a prefab."""
COUNTS = [0, 1, 2, 1000, 5000, 99_999, 100_000, 100_001, 2**31, 10**30]


def damaged(random: Random, data: Any) -> Any:
    """A copy in which a few values are other ones."""
    data = deepcopy(data)
    for _ in range(random.choice((1, 1, 1, 2, 3, 6))):
        parents = list(_containers(data))
        if not parents or len(parents) > MOST_NODES:
            return data
        random.choice(_DAMAGES)(random, random.choice(parents), data)
    return data


def damaged_text(random: Random, data: Any) -> str:
    """The text of damaged data, which now and then is damaged itself."""
    text = json.dumps(damaged(random, data), indent=random.choice((None, None, 1)))
    if len(text) > MOST_TEXT:
        text = text[:MOST_TEXT] if random.random() < 0.1 else json.dumps(data)
    if random.random() < 0.15:
        for _ in range(random.randint(1, 3)):
            start = random.randint(0, len(text))
            text = text[:start] + random.choice(FRAGMENTS) + text[start + random.choice((0, 0, 1, 5, 50)) :]
    return text


def _containers(data: Any) -> Any:
    level = [data]
    while level:
        node = level.pop()
        if isinstance(node, (dict, list)) and node:
            yield node
            children = node.values() if isinstance(node, dict) else node[:300]
            level += [child for child in children if isinstance(child, (dict, list))]


def _key(random: Random, parent: Any) -> Any:
    return random.choice(list(parent)) if isinstance(parent, dict) else random.randrange(len(parent))


def value(random: Random, now: Any = None) -> Any:
    """Another value, more often than not of the kind that is there."""
    if isinstance(now, (int, float)) and not isinstance(now, bool) and random.random() < 0.6:
        return random.choice([*NUMBERS, -now, now * 1_000_000, now // 3, now + 1])
    if isinstance(now, str) and random.random() < 0.6:
        return random.choice([*TEXTS, now + "x", now[:-1], now.upper(), now + "-1"])
    return deepcopy(random.choice(random.choice((NUMBERS, TEXTS, OTHERS))))


def _replace(random: Random, parent: Any, data: Any) -> None:
    key = _key(random, parent)
    parent[key] = value(random, parent[key])


def _delete(random: Random, parent: Any, data: Any) -> None:
    del parent[_key(random, parent)]


def _swap(random: Random, parent: Any, data: Any) -> None:
    one, two = _key(random, parent), _key(random, parent)
    parent[one], parent[two] = parent[two], parent[one]


def _transplant(random: Random, parent: Any, data: Any) -> None:
    """What stands somewhere else: fields of other kinds, references to itself."""
    other = random.choice(list(_containers(data)))
    key = _key(random, parent)
    parent[key] = deepcopy(random.choice((other, other[_key(random, other)])))


def _add(random: Random, parent: Any, data: Any) -> None:
    if isinstance(parent, list):
        parent.insert(random.randint(0, len(parent)), deepcopy(random.choice([*parent, value(random)])))
    else:
        others = [key for node in _containers(data) if isinstance(node, dict) for key in node]
        parent[random.choice([*others, *TEXTS[:30]])] = value(random)


def _nest(random: Random, parent: Any, data: Any) -> None:
    key, depth = _key(random, parent), random.choice((1, 2, 5, 30, 40, 100))
    for _ in range(depth):
        parent[key] = [parent[key]] if random.random() < 0.7 else {"a": parent[key]}


def _copies(random: Random, parent: Any, data: Any) -> None:
    """Thousands of one entry, as far as that stays a small file."""
    key = _key(random, parent)
    many = max(1, min(random.choice((10, 300, 2000)), 60_000 // len(json.dumps(parent[key]))))
    if isinstance(parent, list):
        parent += [deepcopy(parent[key]) for _ in range(many)]
    else:
        parent.update({f"{key}-{k}": parent[key] for k in range(many)})


def _count(random: Random, parent: Any, data: Any) -> None:
    """Huge numbers of what generators make."""
    made = [node for node in _containers(data) if isinstance(node, dict) and {"count", "rows", "columns"} & node.keys()]
    for node in made[:1]:
        node[random.choice([key for key in ("count", "rows", "columns") if key in node])] = random.choice(COUNTS)


def _generate(random: Random, parent: Any, data: Any) -> None:
    """Heaps of one prefab, beside each other or in one place; prefabs in prefabs."""
    prefabs = data.setdefault("prefabs", {}) if isinstance(data, dict) else None
    if not isinstance(prefabs, dict):
        return
    shape = random.choice(({"box": [1, 1]}, {"circle": "=n"}, {"segment": [[0, 0], [1, 0]]}))
    kind = random.choice(("static", "static", "kinematic", "dynamic"))
    prefabs["made-0"] = {"type": kind, "params": {"n": 1}, "shapes": [shape]}
    depth = random.choice((0, 0, 0, 1, 2, 3))
    for k in range(depth):
        inner = {**_generator(random, f"made-{k}", MADE_INSIDE), "params": {"n": random.choice((2, "=m", "=m + i"))}}
        prefabs[f"made-{k + 1}"] = {"params": {"n": 2, "m": 3}, "generate": [inner]}
    made = data.setdefault("generate", [])
    if isinstance(made, list):
        made.append(_generator(random, f"made-{depth}", MADE))


def _generator(random: Random, prefab: str, counts: list[Any]) -> Any:
    kind = random.choice(KINDS)
    fields = {"id": "made", kind: prefab, "at": [0, 0]}
    sizes = {"grid": ("columns", "rows"), "pyramid": ("rows",)}.get(kind, ("count",))
    for name in sizes if kind != "place" else ():
        fields[name] = random.choice(counts)
    apart = {"row": "step", "chain": "step", "stack": "spacing", "grid": "spacing", "pyramid": "spacing"}.get(kind)
    if apart is not None:
        spacing: Any = random.choice(([0, 0], [1e-9, 0], [1, 0], [1, 1]))
        fields[apart] = spacing[0] if kind == "stack" else spacing
    if kind == "scatter":
        fields["inside"] = random.choice(([0, 0, 1, 1], [-50, 0, 50, 50]))
    return fields


_DAMAGES = (
    [_replace] * 8 + [_delete] * 3 + [_swap] * 2 + [_transplant] * 3 + [_add] * 3 + [_nest, _copies, _count, _generate]
)
